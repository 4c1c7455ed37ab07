#include "io/packing_csv.h"

#include <sstream>

#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(PackingCsv, HasALineForEachParticle) {
  const TemporaryFolder folder;
  const Packing p = random_packing(1);
  write_packing_csv(p, folder / "a.csv");
  std::istringstream stream(content(folder / "a.csv"));
  std::string line;
  std::getline(stream, line);
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  EXPECT_EQ(commas(line), 19);
  std::size_t lines = 0;
  for (; std::getline(stream, line); ++lines) EXPECT_EQ(commas(line), 19);
  EXPECT_EQ(lines, p.size());
  EXPECT_TRUE(content(folder / "a.csv").find("\n3,large,") != std::string::npos);
}

}  // namespace
}  // namespace furnas
