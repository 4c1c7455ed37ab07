#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"
#include "tests/engine/support/symmetries.h"

namespace furnas {
namespace {

using test::operator*;

template <class Law>
class Symmetry : public testing::Test {
 protected:
  const Model model = model_of<Law>({.friction = 0.3});
};
TYPED_TEST_SUITE(Symmetry, EveryLaw, LawName);

std::vector<Vec3<double>> turned(std::vector<Vec3<double>> vectors, const Eigen::Matrix3d& turn) {
  for (Vec3<double>& v : vectors) v = turn * v;
  return vectors;
}

/// Expects q to be p turned: motion, forces, contacts, stress.
void expect_turned(const Packing& p, const Packing& q, const Eigen::Matrix3d& turn, double tolerance) {
  const Eigen::Matrix3d axial = turn.determinant() * turn;
  EXPECT_LT(largest_difference(turned(p.velocity, turn), q.velocity), tolerance);
  EXPECT_LT(largest_difference(turned(p.force, turn), q.force), tolerance);
  EXPECT_LT(largest_difference(turned(p.spin, axial), q.spin), tolerance);
  EXPECT_LT(largest_difference(turned(p.torque, axial), q.torque), tolerance);
  test::expect_same_contacts(p, q, tolerance, turn);
  const Eigen::Matrix3d stress = turn * p.stress.contacts * turn.transpose();
  EXPECT_LT((stress - q.stress.contacts).norm(), tolerance * stress.norm());
  const Eigen::Matrix3d motion = turn * p.stress.motion * turn.transpose();
  EXPECT_LT((motion - q.stress.motion).norm(), tolerance * motion.norm());
}

// T26: axes renamed and reversed, the cell turned or reflected until it is triangular again: because it is
// skewed, that turns it by angles of all kinds. Forces, torques, stress and histories after a step follow.
TYPED_TEST(Symmetry, NoAxisIsSpecial) {
  const Packing start = reskewed(squeezed(1e-2), 1, -1, 1);
  const Packing expected = after(this->model, start, 1);
  double largest_turn = 0;
  for (const Eigen::Matrix3i& m : test::signed_permutations()) {
    const auto [other, turn] = test::with_edges(start, m);
    largest_turn = std::max(largest_turn, (turn - Eigen::Matrix3d::Identity()).norm());
    expect_turned(expected, after(this->model, other, 1), turn, 1e-12);
  }
  EXPECT_GT(largest_turn, 1);
}

// T26: spheres alone in a large cell, turned by any angle and reflected, for twenty steps.
TYPED_TEST(Symmetry, NoDirectionIsSpecial) {
  const Packing expected = after(this->model, alone(cluster()), 20);
  ASSERT_GT(expected.contacts.size(), 5u);
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d axis(std::sin(n), std::cos(2 * n), std::sin(3 * n + 1));
    const double reflect = n % 2 == 0 ? 1 : -1;
    const Eigen::Matrix3d turn =
        reflect * Eigen::AngleAxisd(0.7 * n + 0.3, axis.normalized()).toRotationMatrix();
    std::vector<Ball> balls = cluster();
    for (Ball& ball : balls) {
      ball.position = turn * ball.position;
      ball.velocity = turn * ball.velocity;
      ball.spin = reflect * (turn * ball.spin);
    }
    // Places in a cell of 128 are rounded to 1e-14, which the steps carry on.
    expect_turned(expected, after(this->model, alone(balls), 20), turn, 1e-11);
  }
}

/// Numbers for the particles at random, the same in every run.
std::vector<std::uint32_t> random_numbers(std::size_t count) {
  std::vector<std::uint32_t> number(count);
  std::iota(number.begin(), number.end(), 0u);
  std::shuffle(number.begin(), number.end(), std::minstd_rand(3));
  return number;
}

/// Another order in memory, random within each size.
std::vector<std::uint32_t> shuffled_order(const Packing& p) {
  std::vector<std::uint32_t> order = p.order;
  std::shuffle(order.begin(), order.end(), std::minstd_rand(4));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return p.radius[a] > p.radius[b]; });
  return order;
}

// T29: the numbers of particles are names: no bit changes while the order in memory stays.
TYPED_TEST(Symmetry, NumbersAreNames) {
  const Packing start = squeezed(1e-2);
  const std::vector<std::uint32_t> number = random_numbers(start.size());
  const Packing expected = test::renumbered(after(this->model, start, 300), number);
  Packing other = after(this->model, test::renumbered(start, number), 300);
  EXPECT_TRUE(test::same_packing(other, expected));
}

// T29: with another order in memory sums run differently: one step agrees to 1e-12. In the long run the bits
// part, the pressure of a packing at rest does not.
TYPED_TEST(Symmetry, OrderInMemoryIsRounding) {
  const Packing start = squeezed(1e-2);
  Packing other = start;
  other.order = shuffled_order(start);
  ASSERT_NE(other.order, start.order);
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  expect_turned(after(this->model, start, 1), after(this->model, other, 1), same, 1e-12);
  const double p = after(this->model, start, 3000).stress.contacts.trace();
  const double q = after(this->model, other, 3000).stress.contacts.trace();
  EXPECT_NEAR(p / q, 1, 1e-3);
}

/// The packing at places that can be halved.
Packing even(Packing p) {
  for (Fraction& s : p.fraction) s = {s.x & ~1ull, s.y & ~1ull, s.z & ~1ull};
  return p;
}

/// Largest difference of a copy's vector from the original's.
double largest_deviation(const std::vector<Vec3<double>>& original, const std::vector<Vec3<double>>& copies) {
  double largest = 0;
  for (std::size_t n = 0; n < copies.size(); ++n)
    largest = std::max(largest, norm(copies[n] - original[n / 8]));
  return largest;
}

template <class Law>
class NightlySymmetry : public Symmetry<Law> {};
TYPED_TEST_SUITE(NightlySymmetry, EveryLaw, LawName);

// T28: a packing and its eight copies in a cell twice as long: each copy of a force is the force, the stress
// is that of one; a thousand steps later they are copies still.
TYPED_TEST(NightlySymmetry, CopiesOfAPackingStayCopies) {
  const Packing start = even(squeezed(1e-3));
  for (const auto& [steps, tolerance] : {std::pair{0, 1e-13}, {1, 1e-13}, {1000, 1e-9}}) {
    const Packing one = after(this->model, start, steps);
    const Packing eight = after(this->model, test::doubled(start), steps);
    ASSERT_EQ(eight.contacts.size(), 8 * one.contacts.size());
    EXPECT_LT(largest_deviation(one.velocity, eight.velocity), tolerance);
    EXPECT_LT(largest_deviation(one.spin, eight.spin), tolerance);
    EXPECT_LT(largest_deviation(one.force, eight.force), tolerance);
    EXPECT_LT(largest_deviation(one.torque, eight.torque), tolerance);
    const Eigen::Matrix3d stress = one.stress.total() / one.cell.volume();
    EXPECT_LT((eight.stress.total() / eight.cell.volume() - stress).norm(), tolerance * stress.norm());
  }
}

}  // namespace
}  // namespace furnas
