#include "cases/bench/roofline.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

TEST(Roofline, CountsWhatTheArraysHold) {
  // Without friction and pairs: five passes over 64 bytes, two over a force of 24.
  EXPECT_EQ(bytes_per_particle_step({.spins = false, .pairs = 0}), 5 * 64 + 2 * 24);
  // A pair adds two indices, and its row twice.
  EXPECT_EQ(bytes_per_particle_step({.spins = false, .pairs = 2}), 5 * 64 + 2 * 24 + 2 * (8 + 2 * 24));
  EXPECT_LT(bytes_per_particle_step({.pairs = 4, .real = 4}), bytes_per_particle_step({.pairs = 4}));
}

TEST(Roofline, MeasuresABandwidth) {
  EXPECT_GT(triad_bandwidth(2, std::size_t{1} << 20), 1e8);
  EXPECT_GE(triad_size(), std::size_t{1} << 20);
}

}  // namespace
}  // namespace furnas
