#include "engine/base/hasher.h"

#include <gtest/gtest.h>

#include <string>

namespace furnas {
namespace {

std::uint64_t hash(const std::string& bytes, std::size_t piece) {
  Hasher hasher;
  for (std::size_t at = 0; at < bytes.size(); at += piece)
    hasher.add_bytes(bytes.data() + at, std::min(piece, bytes.size() - at));
  return hasher.value();
}

TEST(Hasher, IsXxh3) {
  EXPECT_EQ(Hasher().value(), 0x2d06800538d394c2U);  // of no bytes at all
}

TEST(Hasher, DoesNotDependOnThePieces) {
  std::string bytes(5000, '\0');
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * k % 251);
  for (const std::size_t piece : {1U, 7U, 64U, 1024U})
    EXPECT_EQ(hash(bytes, piece), hash(bytes, bytes.size()));
  bytes[2500] ^= 1;
  EXPECT_NE(hash(bytes, 64), hash(std::string(5000, '\0'), 64));
}

TEST(Hasher, ForgetsWhenRestarted) {
  Hasher hasher;
  hasher.add(1.5);
  EXPECT_NE(hasher.value(), Hasher().value());
  hasher.restart();
  EXPECT_EQ(hasher.value(), Hasher().value());
}

}  // namespace
}  // namespace furnas
