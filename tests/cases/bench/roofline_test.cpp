#include "cases/program/bench/roofline.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

TEST(Roofline, CountsWhatTheArraysHold) {
  // Without friction and pairs: five passes over a record of 64 bytes, two over a force of 32.
  EXPECT_EQ(bytes_per_particle_step({.spins = false, .pairs = 0, .mixed = false}), 5 * 64 + 2 * 32);
  // A pair adds two indices, and its row twice.
  EXPECT_EQ(bytes_per_particle_step({.spins = false, .pairs = 2, .mixed = false}),
            5 * 64 + 2 * 32 + 2 * (8 + 2 * 32));
  // With friction and mixed: a record of one cache line, forces and torques, rows of 32 bytes, histories
  // of 16.
  EXPECT_EQ(bytes_per_particle_step({.pairs = 3}), 5 * 64 + 2 * 32 + 3 * (8 + 2 * 32 + 2 * 16));
}

TEST(Roofline, MeasuresABandwidth) {
  EXPECT_GT(triad_bandwidth(2, std::size_t{1} << 20), 0);
  EXPECT_GE(triad_size(), std::size_t{1} << 20);
}

}  // namespace
}  // namespace furnas
