#include "viz/colouring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace furnas {
namespace {

/// Five spheres that all touch, and a sixth that hangs on one of them.
Packing clique_and_rattler() {
  Packing p;
  p.cell.edges = {10, 10, 10, 0, 0, 0};
  p.resize(6);
  p.radius.assign(6, 0.5);
  const auto join = [&p](std::uint32_t i, std::uint32_t j, double force) {
    Contact c;
    c.i = i, c.j = j;
    c.branch = {0.99, 0, 0};
    c.force = {force, 0, 0};
    p.contacts.push_back(c);
  };
  for (std::uint32_t j = 1; j < 5; ++j)
    for (std::uint32_t i = 0; i < j; ++i) join(i, j, 1e-3);
  join(0, 5, 0.5e-3);
  return p;
}

TEST(Colouring, GradesRiseInBrightness) {
  double before = -1;
  for (int k = 0; k <= 20; ++k) {
    const Rgb c = graded(k / 20.0);
    const double brightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    EXPECT_GT(brightness, before) << k;
    before = brightness;
  }
  EXPECT_EQ(graded(-1), graded(0));
  EXPECT_EQ(graded(7), graded(1));
}

/// Spheres of many sizes are neither large nor small.
TEST(Colouring, GradesTheSizesOfAPolydispersePacking) {
  Packing p = clique_and_rattler();
  p.radius = {0.5, 0.75, 1, 0.5, 0.5, 0.5};
  const Coloured linear = coloured(p, Colouring::species, 3);
  EXPECT_EQ(linear.particles[0], graded(0));
  EXPECT_EQ(linear.particles[1], graded(0.5));
  EXPECT_EQ(linear.particles[2], graded(1));
  EXPECT_THAT(linear.key, testing::HasSubstr("diameters from 1 (dark blue) to 2 (yellow)"));
  p.radius[1] = 5, p.radius[2] = 50;
  const Coloured wide = coloured(p, Colouring::species, 3);
  EXPECT_EQ(wide.particles[1], graded(0.5));
  EXPECT_TRUE(wide.legend.scale->logarithmic);
  EXPECT_THAT(coloured(p, Colouring::rattlers, 3).key, testing::Not(testing::HasSubstr("large")));
}

TEST(Colouring, TellsRattlersFromTheBackbone) {
  const Packing p = clique_and_rattler();
  const Coloured c = coloured(p, Colouring::rattlers, 3);
  for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(c.particles[k], c.particles[0]);
  EXPECT_NE(c.particles[5], c.particles[0]);
  EXPECT_THAT(c.key, testing::HasSubstr("fewer than 3 live contacts"));
}

TEST(Colouring, GradesContactsAndPressure) {
  const Packing p = clique_and_rattler();
  const Coloured contacts = coloured(p, Colouring::coordination, 3);
  EXPECT_EQ(contacts.particles[0], graded(5 / 12.0));
  EXPECT_EQ(contacts.particles[1], graded(4 / 12.0));
  EXPECT_EQ(contacts.particles[5], graded(1 / 12.0));
  // Equal spheres: the pressure goes with the sum of the forces, and the mean is that of 21 halves over 6.
  const Coloured pressure = coloured(p, Colouring::pressure, 3);
  EXPECT_EQ(pressure.particles[0], graded(9 / 7.0 / 3));
  EXPECT_EQ(pressure.particles[1], graded(8 / 7.0 / 3));
  EXPECT_EQ(pressure.particles[5], graded(1 / 7.0 / 3));
}

TEST(Colouring, PressureOfNothingIsNothing) {
  Packing p = clique_and_rattler();
  p.contacts.clear();
  EXPECT_EQ(coloured(p, Colouring::pressure, 3).particles[2], graded(0));
}

}  // namespace
}  // namespace furnas
