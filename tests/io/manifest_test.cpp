#include "io/manifest.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

// Each file stands in the manifest once, with its size; the same bytes have the same hash, others another.
TEST(Manifest, NamesEachFileWithItsSizeAndHash) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "frames");
  std::ofstream(folder / "a.txt") << "jammed";
  std::ofstream(folder / "frames/b.txt") << "jammed";
  std::ofstream(folder / "c.txt") << "jammer";
  write_manifest(folder / "", "furnas test");
  write_manifest(folder / "", "furnas test");  // does not list itself

  const auto manifest = nlohmann::json::parse(std::ifstream(folder / "manifest.json"));
  EXPECT_EQ(manifest.at("program"), "furnas test");
  const auto& files = manifest.at("files");
  EXPECT_EQ(files.size(), 3U);
  EXPECT_EQ(files.at("a.txt").at("bytes"), 6);
  EXPECT_EQ(files.at("a.txt").at("xxh3"), files.at("frames/b.txt").at("xxh3"));
  EXPECT_NE(files.at("a.txt").at("xxh3"), files.at("c.txt").at("xxh3"));
}

// A name may have bytes that JSON cannot hold, such as those of Latin-1.
TEST(Manifest, NamesFilesOfAnyEncoding) {
  const TemporaryFolder folder;
  std::ofstream(folder / "gr\xfc\xdf.txt") << "jammed";
  write_manifest(folder / "", "furnas test");
  const auto manifest = nlohmann::json::parse(std::ifstream(folder / "manifest.json"));
  EXPECT_EQ(manifest.at("files").at("gr\uFFFD\uFFFD.txt").at("bytes"), 6);
}

}  // namespace
}  // namespace furnas
