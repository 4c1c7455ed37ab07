#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double shear_rate = 0.1;
constexpr double edge = 2;
/// Steps in which the tilt of the cell grows by an edge.
const double steps_a_flip = 1 / (shear_rate * paper_step);

/// A dense gas of soft spheres in a cube that is sheared for ever: nothing can stop the cell's inertia.
/// Spheres of 1.2 still let the longest of the tilts below be searched.
Packing sheared_gas(int count) {
  test::Dice dice(11);
  std::vector<Ball> balls;
  for (int k = 0; k < count; ++k)
    balls.push_back({.position = {dice.between(0, edge), dice.between(0, edge), dice.between(0, edge)},
                     .velocity = dice.vector(0.1),
                     .spin = dice.vector(0.1),
                     .radius = dice.chance(0.3) ? 0.6 : 0.5});
  Packing p = packing_of(cube(edge), balls);
  p.cell.rate.xy = shear_rate;
  return p;
}

template <class Law>
Model sheared(double friction) {
  Model model = model_of<Law>({.friction = friction});
  model.barostat = {.pressure = 0, .inertia = 1e300};
  return model;
}

/// A second implementation: no list, no bins, no flips. Every pair and image is tried in every step; sums and
/// products are those of long doubles. Velocity Verlet of the frictionless law in a cell sheared at a
/// constant rate.
class SlowRun {
 public:
  explicit SlowRun(const Packing& start) : p_(start) {}

  void advance(std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) {
      shear_velocities();
      kick();
      p_.cell.edges.xy += shear_rate * paper_step / 2 * p_.cell.edges.yy;
      for (std::size_t k = 0; k < p_.size(); ++k) {
        const Fraction moved = to_fraction(inverse(p_.cell.edges) * (paper_step * p_.velocity[k]));
        Fraction& s = p_.fraction[k];
        const Fraction now{s.x + moved.x, s.y + moved.y, s.z + moved.z};
        p_.image[k] = crossed(p_.image[k], s, now);
        s = now;
      }
      p_.cell.edges.xy += shear_rate * paper_step / 2 * p_.cell.edges.yy;
      take_forces();
      kick();
      shear_velocities();
    }
  }

  const Packing& packing() const { return p_; }
  const std::map<test::TouchName, test::BruteTouch>& touches() const { return touches_; }

 private:
  void shear_velocities() {  // v_x' = - e_xy v_y over half a step
    for (Vec3<double>& v : p_.velocity) v.x -= shear_rate * paper_step / 2 * v.y;
  }
  void kick() {
    for (std::size_t k = 0; k < p_.size(); ++k) p_.velocity[k] += (paper_step / 2 / p_.mass[k]) * p_.force[k];
  }

  /// Damping sees the velocities that the last forces promise for the end of the step.
  void take_forces() {
    Packing ahead = p_;
    for (std::size_t k = 0; k < p_.size(); ++k)
      ahead.velocity[k] += (paper_step / 2 / p_.mass[k]) * p_.force[k];
    touches_ = test::brute_pairs(p_, 0);
    std::vector<test::Far> sum(p_.size());
    for (const auto& [name, touch] : touches_) {
      const test::Far f = test::brute_force(ahead, {}, false, name, touch);
      sum[name.i] += f;
      sum[name.j] -= f;
    }
    for (std::size_t k = 0; k < p_.size(); ++k)
      p_.force[k] = {double(sum[k].x), double(sum[k].y), double(sum[k].z)};
  }

  Packing p_;
  std::map<test::TouchName, test::BruteTouch> touches_;
};

/// Pairs that touch, how often each: what two descriptions of a lattice have in common.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> pairs_of(const Packing& p) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> pairs;
  for (const Contact& c : p.contacts) ++pairs[std::minmax(c.i, c.j)];
  return pairs;
}
std::map<std::pair<std::uint32_t, std::uint32_t>, int> pairs_of(const SlowRun& run) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> pairs;
  for (const auto& [name, touch] : run.touches()) ++pairs[{name.i, name.j}];
  return pairs;
}

/// Runs to step `end` with the event that flips; returns how often it did.
std::int64_t run_with_flips(Simulation& simulation, std::int64_t end) {
  Observation now(simulation, 3);
  Events events;
  events.push_back(std::make_unique<Flip>(100));
  events.push_back(std::make_unique<Budget>(end));
  EXPECT_EQ(compact(now, events), Verdict::budget);
  return static_cast<const Flip&>(*events.front()).count();
}

/// The same lattice in a cell that is tilted by whole edges more.
Packing tilted_by(const Packing& p, double edges) {
  return reskewed(p, static_cast<int>(std::lround(edges)), 0, 0);
}

/// Same contacts, and everything at the same place with the same velocity.
template <class Pairs>
void expect_same_motion(const Packing& flipped, const Packing& tilted, const Pairs& pairs) {
  ASSERT_EQ(pairs_of(flipped), pairs);
  const Packing p = tilted_by(flipped, (tilted.cell.edges.xy - flipped.cell.edges.xy) / edge);
  EXPECT_NEAR(p.cell.edges.xy, tilted.cell.edges.xy, 1e-10);
  double apart = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    apart = std::max(apart, norm(tilted.cell.edges * nearest_difference(p.fraction[k], tilted.fraction[k])));
  EXPECT_LT(apart, 1e-10);
  EXPECT_LT(largest_difference(flipped.velocity, tilted.velocity), 1e-10);
}

constexpr int flips = 100;

/// When flip `n` is past.
std::int64_t step_after_flip(int n) { return static_cast<std::int64_t>((n + 0.2) * steps_a_flip); }

// T42: a run with 100 flips and a second implementation that never flips and searches by brute force,
// without friction. A gas forgets its past within an edge or two of shear, so the second run starts anew from
// the first after each flip, in a cell as tilted as if none had ever been. Measured: 2e-14.
TEST(ShearedRun, IsThatOfABruteForceThatNeverFlips) {
  const auto simulation = make_simulation(sheared<Frictionless<false>>(0), sheared_gas(7));
  simulation->advance(50);  // the random start bursts
  std::int64_t flipped = 0;
  std::size_t contacts = 0;
  for (int n = 1; n <= flips; ++n) {
    const Packing before = simulation->packing();
    SlowRun slow(tilted_by(before, n - 1));
    flipped += run_with_flips(*simulation, step_after_flip(n));
    slow.advance(step_after_flip(n) - before.step);
    const Packing now = simulation->packing();
    contacts += now.contacts.size();
    expect_same_motion(now, slow.packing(), pairs_of(slow));
    if (HasFailure()) FAIL() << "after flip " << n;
    EXPECT_GT(slow.packing().cell.edges.xy, n * edge);
  }
  EXPECT_EQ(flipped, flips);
  EXPECT_GT(contacts, 5u * flips);
}

// T42: with friction, histories and spins, against the engine that leaves out one flip after the other.
TEST(ShearedRun, KeepsHistoriesThroughAHundredFlips) {
  const Model model = sheared<HookeSynchronized>(0.5);
  const auto simulation = make_simulation(model, sheared_gas(9));
  simulation->advance(50);
  std::int64_t flipped = 0;
  std::size_t histories = 0;
  std::size_t images = 0;
  for (int n = 1; n <= flips; ++n) {
    const Packing before = simulation->packing();
    const auto tilting = make_simulation(model, before);
    flipped += run_with_flips(*simulation, step_after_flip(n));
    tilting->advance(step_after_flip(n) - before.step);
    const Packing a = simulation->packing();
    const Packing b = tilting->packing();
    expect_same_motion(a, b, pairs_of(b));
    EXPECT_LT(largest_difference(a.spin, b.spin), 1e-10);
    EXPECT_LT(largest_difference(a.torque, b.torque), 1e-10);
    for (const Contact& c : a.contacts) {
      histories += norm(c.history) > 1e-3;
      images += c.image != decltype(c.image){};
    }
    if (HasFailure()) FAIL() << "after flip " << n;
  }
  EXPECT_EQ(flipped, flips);
  EXPECT_GT(histories, 10u * flips);
  EXPECT_GT(images, 1u * flips);
}

}  // namespace
}  // namespace furnas
