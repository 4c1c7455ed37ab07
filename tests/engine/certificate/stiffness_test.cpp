#include "engine/certificate/stiffness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/laws/hooke_history.h"
#include "engine/laws/hooke_synchronized.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using Motion = Stiffness::Motion;

constexpr double pressure = 0.03;

/// A network with the backbone of all its particles.
struct Sample {
  ContactNetwork network;
  Backbone backbone;
  Stiffness stiffness;

  Sample(const Packing& p, const Springs& springs)
      : network(contact_network(p, springs)),
        backbone(find_backbone(network, p.species, {0, 0})),
        stiffness(network, backbone, pressure) {}
};

Motion random_motion(const Stiffness& stiffness, std::uint64_t seed) {
  test::Dice dice(seed);
  Motion motion{Eigen::VectorXd(stiffness.unknowns()), {}};
  for (auto& x : motion.particles) x = dice.between(-1, 1);
  for (auto& x : motion.strain) x = dice.between(-1, 1);
  return motion;
}

double work(const Motion& a, const Motion& b) {
  return a.particles.dot(b.particles) + a.strain.dot(b.strain);
}

Motion plus(Motion a, double by, const Motion& b) {
  a.particles += by * b.particles;
  a.strain += by * b.strain;
  return a;
}

Vec3<double> three(const Eigen::VectorXd& v, std::uint32_t k, Eigen::Index per_particle,
                   Eigen::Index from = 0) {
  const Eigen::Index at = k * per_particle + from;
  return {v[at], v[at + 1], v[at + 2]};
}

/// e x.
Vec3<double> strained(const Strain& e, const Vec3<double>& x) {
  return {e[0] * x.x + e[3] * x.y + e[4] * x.z, e[1] * x.y + e[5] * x.z, e[2] * x.z};
}

/// Branch of a contact after a motion.
Vec3<double> moved(const StaticContact& c, const Motion& m, Eigen::Index per_particle) {
  return c.branch + three(m.particles, c.i, per_particle) - three(m.particles, c.j, per_particle) +
         strained(m.strain, c.branch);
}

/// U + p V of springs without friction after a motion.
double enthalpy(const Sample& sample, const Motion& m) {
  double sum = pressure * sample.network.volume * (1 + m.strain[0]) * (1 + m.strain[1]) * (1 + m.strain[2]);
  for (const StaticContact& c : sample.network.contacts) {
    const double overlap = sample.network.radius[c.i] + sample.network.radius[c.j] - norm(moved(c, m, 3));
    sum += 0.5 * overlap * overlap;
  }
  return sum;
}

TEST(Stiffness, IsTheSecondDerivativeOfTheEnthalpy) {
  const Sample sample(squeezed(0), {});
  for (std::uint64_t seed : {1, 2, 3}) {
    const Motion v = random_motion(sample.stiffness, seed);
    const auto at = [&](double x) { return enthalpy(sample, plus({0 * v.particles, Strain::Zero()}, x, v)); };
    // Fourth order: the step leaves (h/delta)^4; 1e-12 of an energy of 10 over h^2 is rounding.
    constexpr double h = 3e-4;
    const double second = (16 * (at(h) + at(-h)) - (at(2 * h) + at(-2 * h)) - 30 * at(0)) / (12 * h * h);
    const double expected = work(v, sample.stiffness.times(v));
    EXPECT_NEAR(second / expected, 1, 1e-6);
  }
}

/// Work of the forces of the default law, done by `m` on the forces that a motion by x m leaves. The law sees
/// the motion as one step without damping.
template <class Law>
double work_of_law(const Sample& sample, const Motion& m, double x) {
  const Law law{{.tangential_stiffness = 1, .normal_damping = 0, .tangential_damping = 0, .friction = 1e30}};
  double sum = 0;
  const Motion small{x * m.particles, x * m.strain};
  for (const StaticContact& c : sample.network.contacts) {
    Touch<double> t;
    t.branch = moved(c, small, 6);
    t.distance = norm(t.branch);
    t.radius_i = sample.network.radius[c.i];
    t.radius_j = sample.network.radius[c.j];
    t.overlap = t.radius_i + t.radius_j - t.distance;
    t.reduced_mass = 1;
    t.time_step = 1;
    t.drift = t.branch - c.branch;
    t.midway.velocity = t.drift;
    t.midway.spin_i = three(small.particles, c.i, 6, 3) * (1 / t.radius_i);
    t.midway.spin_j = three(small.particles, c.j, 6, 3) * (1 / t.radius_j);
    Vec3<double> history = -c.tangential_force;
    const Reaction<double> reaction = law(t, history);
    const Vec3<double> couple = cross(t.branch * (1 / t.distance), reaction.force);
    sum -= dot(reaction.force, moved(c, m, 6) - c.branch);
    sum += dot(couple, three(m.particles, c.i, 6, 3)) * (t.radius_i - reaction.shortening) / t.radius_i;
    sum += dot(couple, three(m.particles, c.j, 6, 3)) * (t.radius_j - reaction.shortening) / t.radius_j;
  }
  return sum;
}

// The second-order work with friction that sticks, prestress and turning friction included, against the law
// that the engine integrates. Only this test compares the two.
template <class Law>
void expect_stiffness_of_the_law() {
  Packing packing = squeezed(0);
  for (Contact& c : packing.contacts) c.history *= 100;  // as large as overlaps, so that its turning counts
  const Sample sample(packing,
                      {.law = Law{{.tangential_stiffness = 1, .friction = 0.3}}, .at_limit = -1e300});
  ASSERT_EQ(sample.stiffness.bridges(), 0) << "their spin is held besides";
  for (std::uint64_t seed : {4, 5, 6}) {
    const Motion v = random_motion(sample.stiffness, seed);
    constexpr double h = 1e-6;
    const double answer = (work_of_law<Law>(sample, v, h) - work_of_law<Law>(sample, v, -h)) / (2 * h);
    Strain volume = Strain::Zero();
    volume.head<3>().setConstant(v.strain.head<3>().sum());
    volume.head<3>() -= v.strain.head<3>();
    const double of_volume = pressure * sample.network.volume * v.strain.dot(volume);
    const double expected = work(v, sample.stiffness.times(v)) - of_volume;
    // The turning of friction is 1e-3 of the answer: it must be right, too. Rounding over the step leaves
    // 1e-9.
    EXPECT_NEAR(answer / expected, 1, 1e-8) << Law::name;
  }
}

TEST(Stiffness, IsWhatTheLawAnswersToASmallMotion) {
  expect_stiffness_of_the_law<HookeSynchronized>();
  expect_stiffness_of_the_law<HookeHistory>();
}

// A contact at the Coulomb limit gives way along its friction and holds across it; below the limit it holds
// both ways. The normal force pushes the spheres aside with F_n/r either way.
TEST(Stiffness, OfAContactThatSlidesIsAcrossItsFriction) {
  constexpr double r = 0.99;
  constexpr double kt = 0.7;
  for (const double share : {0.5, 1.0}) {
    Packing pair = packing_of(cube(10), {{.position = {5, 5, 5}}, {.position = {5 + r, 5, 5}}});
    Contact c;
    c.i = 1, c.j = 0;
    c.history = {0, share * 0.3 * (1 - r) / kt, 0};
    pair.contacts = {c};
    const Sample sample(pair, {.law = HookeSynchronized{{.tangential_stiffness = kt, .friction = 0.3}}});
    ASSERT_EQ(sample.network.contacts.at(0).sliding, share == 1.0);
    const auto cost = [&](Eigen::Index axis) {
      Motion m{Eigen::VectorXd::Unit(12, axis), Strain::Zero()};
      return work(m, sample.stiffness.times(m));
    };
    EXPECT_NEAR(cost(0), 1, 1e-14);
    EXPECT_NEAR(cost(1), (share == 1.0 ? 0 : kt) - (1 - r) / r, 1e-14) << share;
    EXPECT_NEAR(cost(2), kt - (1 - r) / r, 1e-14) << share;
  }
}

// Two spheres that press on each other and on nothing else lack all of their force f, and with friction their
// torque arm F_t: each contact's force is in doubt by 2 (|f| + arm F_t/R). A force F along the normal makes
// -F/r of a step across it, a force across the normal as much of a step in both directions.
TEST(Stiffness, IsInDoubtByWhatItsSpheresLack) {
  constexpr double r = 0.99;
  constexpr double push = 1 - r;
  for (const double friction : {0.0, 0.3}) {
    Packing pair = packing_of(cube(10), {{.position = {5, 5, 5}}, {.position = {5 + r, 5, 5}}});
    const double across = friction * push / 2;
    Contact c;
    c.i = 1, c.j = 0;
    c.history = {0, across, 0};
    pair.contacts = {c};
    const Sample sample(pair, {.law = HookeSynchronized{{.friction = friction}}});
    const double lacking = 2 * (std::hypot(push, across) + r / 2 * across / 0.5);
    const double expected = lacking * (friction > 0 ? std::sqrt(2) : 1) / r;
    const Eigen::Index of_second = sample.stiffness.per_particle();
    Motion step{Eigen::VectorXd::Zero(sample.stiffness.unknowns()), Strain::Zero()};
    step.particles[of_second] = 1;
    EXPECT_NEAR(sample.stiffness.doubt(step), 0, 1e-16) << "no force turns";
    step.particles[of_second + 1] = 1;
    // Places in a cell of 10 are known to 1e-15, which is 1e-13 of the overlap.
    EXPECT_NEAR(sample.stiffness.doubt(step) / expected, 1, 1e-12);
    step.particles *= 2;
    EXPECT_NEAR(sample.stiffness.doubt(step) / expected, 4, 1e-12);
  }
}

TEST(Stiffness, AsMatricesIsTheSame) {
  for (double friction : {0.0, 0.3}) {
    const Sample sample(jammed(),
                        {.law = HookeSynchronized{{.tangential_stiffness = 0.8, .friction = friction}}});
    const Stiffness& k = sample.stiffness;
    const Motion v = random_motion(k, 7);
    const Motion force = k.times(v);
    const Eigen::VectorXd particles = k.among_particles().selfadjointView<Eigen::Lower>() * v.particles +
                                      k.particles_by_strain() * v.strain;
    const Strain strain = k.particles_by_strain().transpose() * v.particles + k.among_strains() * v.strain;
    // Sums of ten terms of order one, in another order.
    EXPECT_LT((particles - force.particles).norm(), 1e-13 * force.particles.norm());
    EXPECT_LT((strain - force.strain).norm(), 1e-13 * force.strain.norm());
    EXPECT_NEAR(work(v, k.times(random_motion(k, 8))), work(random_motion(k, 8), force),
                1e-12 * work(v, force));
  }
}

TEST(Stiffness, TranslationCostsNothing) {
  const Sample sample(jammed(), {.law = HookeSynchronized{{.friction = 0.3}}});
  Motion all{Eigen::VectorXd::Zero(sample.stiffness.unknowns()), Strain::Zero()};
  for (Eigen::Index k = 0; k < all.particles.size(); k += 6) all.particles.segment<3>(k) << 1, 2, 3;
  const Motion force = sample.stiffness.times(all);
  EXPECT_LT(force.particles.norm(), 1e-12);
  EXPECT_LT(force.strain.norm(), 1e-11);
}

/// Spheres 0 and 1 with a third that bridges them, off their line, held up by friction alone.
Packing bridge(double angle) {
  constexpr double reach = 0.999;
  const double half = reach * std::cos(angle);
  const double height = reach * std::sin(angle);
  Packing p = packing_of(
      cube(10),
      {{.position = {5 - half, 5, 5}}, {.position = {5 + half, 5, 5}}, {.position = {5, 5 + height, 5}}});
  for (std::uint32_t k : {0u, 1u}) {
    // The force of each contact points along the line through both contact points.
    const double side = k == 0 ? 1 : -1;
    const Vec3<double> normal{side * std::cos(angle), std::sin(angle), 0};
    const Vec3<double> along{side, 0, 0};
    const double push = (1 - reach) / dot(normal, along);
    Contact c;
    c.i = 2, c.j = k;
    c.history = -(push * along - (1 - reach) * normal);
    p.contacts.push_back(c);
  }
  return p;
}

// The sphere in the middle is in balance, and its spin about the line through its contact points is neutral
// to second order, however far it stands off: the turning of normal forces and of friction cancel. The spin
// is held with k_n, which is all that the stiffness answers.
TEST(Stiffness, OfABridgeThatSpinsIsThatOfItsHold) {
  for (double angle : {0.02, 0.1, 0.25}) {
    const Packing p = bridge(angle);
    const Springs springs{.law = HookeSynchronized{{.tangential_stiffness = 1, .friction = 0.3}}};
    const ContactNetwork network = contact_network(p, springs);
    Backbone backbone = find_backbone(network, p.species, {0, 1});
    ASSERT_EQ(backbone.bonds.size(), 2u);
    const Stiffness k(network, backbone, 0);
    ASSERT_EQ(k.bridges(), 1);
    // Spin about x through the contact points at height h/2 below: the centre moves by x cross (h/2) y.
    Motion spin{Eigen::VectorXd::Zero(18), Strain::Zero()};
    const double arm = network.contacts[0].arm_i;
    spin.particles.segment<3>(12) << 0, 0, arm * std::sin(angle);
    spin.particles.segment<3>(15) << 0.5, 0, 0;
    EXPECT_NEAR(work(spin, k.times(spin)), 0.25, 1e-12) << angle;
  }
}

}  // namespace
}  // namespace furnas
