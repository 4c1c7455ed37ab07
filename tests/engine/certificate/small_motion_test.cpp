#include "engine/certificate/small_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/certificate/statics.h"
#include "engine/certificate/stiffness.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using Eigen::VectorXd;

constexpr double friction = 0.3;
constexpr double kt = 0.7;

/// A pair of unlike spheres with random places, turned any way, whose friction has this share of its limit.
Packing random_pair(test::Dice& dice, double share) {
  const double a = dice.between(0.4, 1.2);
  const double b = dice.between(0.4, 1.2);
  const double overlap = dice.between(0.01, 0.05);
  const Vec3<double> n = dice.direction();
  Packing p = packing_of({10, 11, 12, 0.5, -1, 2},
                         {{.position = {4, 4, 5}, .radius = a},
                          {.position = Vec3<double>{4, 4, 5} + (a + b - overlap) * n, .radius = b}});
  Vec3<double> across = cross(n, dice.direction());
  Contact c;
  c.i = 1, c.j = 0;
  c.history = (share * friction * overlap / kt / norm(across)) * across;
  p.contacts = {c};
  return p;
}

/// A pair and the law that holds it.
struct Pair {
  Springs springs;
  CellMotion cell;
  ContactNetwork network;
  Backbone backbone;
  SmallMotion small;

  Pair(const Packing& p, const AnyLaw& law, const CellMotion& motion)
      : springs{.law = law},
        cell(motion),
        network(contact_network(p, springs)),
        backbone(find_backbone(network, p.species, {0, 0})),
        small(network, backbone, motion) {}

  const StaticContact& contact() const { return network.contacts.at(0); }
};

Vec3<double> three_of(const VectorXd& v, std::uint32_t k, Eigen::Index from) {
  const Eigen::Index at = 6 * k + from;
  return {v[at], v[at + 1], v[at + 2]};
}

Triangle strain_of(const Pair& pair, const VectorXd& z) {
  const Strain e = pair.small.strains() * z.tail(pair.small.strains().cols());
  return {e[0], e[1], e[2], e[5], e[4], e[3]};
}

/// What the law answers when the pair has made the motion z in one step of length 1 and then moves with the
/// rates w.
template <class Law>
struct Answer {
  Touch<double> touch;
  Reaction<double> reaction;

  Answer(const Pair& pair, const Law& law, const VectorXd& z, const VectorXd& w) {
    const StaticContact& c = pair.contact();
    const auto between = [&](const VectorXd& v) { return three_of(v, c.i, 0) - three_of(v, c.j, 0); };
    const Vec3<double> drift = between(z) + strain_of(pair, z) * c.branch;
    touch.branch = c.branch + drift;
    touch.distance = norm(touch.branch);
    touch.radius_i = pair.network.radius[c.i];
    touch.radius_j = pair.network.radius[c.j];
    touch.overlap = touch.radius_i + touch.radius_j - touch.distance;
    touch.reduced_mass = reduced_mass(pair.network.mass[c.i], pair.network.mass[c.j]);
    touch.time_step = 1;
    touch.drift = drift;
    const auto seen = [&](const VectorXd& v) {
      RelativeMotion<double> m{between(v), three_of(v, c.i, 3) * (1 / touch.radius_i),
                               three_of(v, c.j, 3) * (1 / touch.radius_j)};
      if (pair.cell.affine_velocity) m.velocity += strain_of(pair, v) * touch.branch;
      return m;
    };
    touch.midway = seen(z);
    touch.now = seen(w);
    Vec3<double> history = (-1 / kt) * c.tangential_force;
    reaction = law(touch, history);
  }

  bool slides() const {
    const Vec3<double> n = (1 / touch.distance) * touch.branch;
    const double push = dot(reaction.force, n);
    return norm(reaction.force - push * n) > (1 - 1e-13) * friction * push;
  }

  /// The forces on all unknowns.
  VectorXd forces(const Pair& pair) const {
    const StaticContact& c = pair.contact();
    const Vec3<double>& f = reaction.force;
    const Vec3<double> couple = cross((1 / touch.distance) * touch.branch, f);
    VectorXd q = VectorXd::Zero(pair.small.unknowns());
    const auto put = [&](std::uint32_t k, Eigen::Index from, const Vec3<double>& v) {
      q.segment<3>(6 * k + from) += Eigen::Vector3d(v.x, v.y, v.z);
    };
    put(c.i, 0, f);
    put(c.j, 0, -f);
    put(c.i, 3, (-(touch.radius_i - reaction.shortening) / touch.radius_i) * couple);
    put(c.j, 3, (-(touch.radius_j - reaction.shortening) / touch.radius_j) * couple);
    const Vec3<double>& r = touch.branch;
    Strain driven;
    driven << r.x * f.x, r.y * f.y, r.z * f.z, r.y * f.x, r.z * f.x, r.z * f.y;
    if (pair.cell.legacy) driven.tail<3>() << r.x * f.y, r.x * f.z, r.y * f.z;
    q.tail(pair.small.strains().cols()) = pair.small.strains().transpose() * driven;
    return q;
  }
};

VectorXd random_vector(test::Dice& dice, Eigen::Index size) {
  VectorXd v(size);
  for (auto& x : v) x = dice.between(-1, 1);
  return v;
}

/// How the forces of the law change, at first, along a motion; of the two ways along it the one in which the
/// contact stays as it is, sticking or sliding.
template <class Law>
void compare_with_law(const Law& law, std::uint64_t seed, double share, CellFreedom freedom, bool affine) {
  test::Dice dice(seed);
  CellMotion cell{.freedom = freedom, .affine_velocity = affine};
  cell.pressure = 0;  // of the contacts alone
  cell.legacy = !Law::synchronized;
  const Pair pair(random_pair(dice, share), law, cell);
  ASSERT_EQ(pair.contact().sliding, share == 1.0);
  VectorXd z = random_vector(dice, pair.small.unknowns());
  // The legacy law has one velocity for both.
  VectorXd w = Law::synchronized ? random_vector(dice, pair.small.unknowns()) : z;
  constexpr double h = 2e-7;
  if (share == 1.0 && !Answer<Law>(pair, law, h * z, h * w).slides()) z = -z, w = -w;
  const auto at = [&](double x) {
    const Answer<Law> answer(pair, law, x * z, x * w);
    EXPECT_EQ(answer.slides(), share == 1.0);
    return answer.forces(pair);
  };
  // Second order: a slip of 3 h over a spring of 2e-3, squared, is 1e-7; rounding over the step 2e-8.
  const VectorXd change = (4 * at(h / 2) - at(h) - 3 * at(0)) / h;
  const VectorXd expected = -(pair.small.stiffness() * z + pair.small.damping() * w);
  EXPECT_LT((change - expected).norm(), 1e-7 * expected.norm()) << seed;
}

// Against the laws that the engine integrates: forces, torques and what drives the cell, of contacts that
// stick and contacts that slide.
TEST(SmallMotion, IsWhatTheLawsAnswer) {
  const HookeConstants constants{.tangential_stiffness = kt, .tangential_damping = 0.4, .friction = friction};
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const double share : {0.5, 1.0})
      for (const bool affine : {false, true})
        for (const CellFreedom freedom :
             {CellFreedom::triclinic, CellFreedom::orthorhombic, CellFreedom::cubic, CellFreedom::fixed}) {
          compare_with_law(HookeSynchronized{constants}, seed, share, freedom, affine);
          compare_with_law(HookeHistory{constants}, seed, share, freedom, affine);
        }
}

// Without a history of its own that slides, and with the cell's flow seen, the stiffness is that of the
// energy. In a crystal, which is in balance, the prestress is in it, too.
TEST(SmallMotion, OfWhatSticksIsThatOfTheEnergy) {
  const Packing crystal = face_centred(0.98, 2);
  for (const double mu : {0.0, 0.5}) {
    const ContactNetwork network = contact_network(crystal, {.law = HookeSynchronized{{.friction = mu}}});
    const Backbone backbone = find_backbone(network, crystal.species, {0, 0});
    const double pressure = static_stress(network).trace() / 3;
    const SmallMotion small(network, backbone, {.pressure = pressure, .affine_velocity = true});
    const Stiffness stiffness(network, backbone, pressure);
    test::Dice dice(3);
    const VectorXd z = random_vector(dice, small.unknowns());
    const Stiffness::Motion force =
        stiffness.times({z.head(stiffness.unknowns()), small.strains() * z.tail<6>()});
    VectorXd expected(z.size());
    expected << force.particles, small.strains().transpose() * force.strain;
    EXPECT_LT((small.stiffness() * z - expected).norm(), 1e-12 * expected.norm()) << mu;
  }
}

// The bath answers to a change of volume with -p, each edge alike.
TEST(SmallMotion, OfTheBathIsThatOfTheVolume) {
  const Packing crystal = simple_cubic(0.98, 2);
  const ContactNetwork network = contact_network(crystal, {});
  const Backbone backbone = find_backbone(network, crystal.species, {0, 0});
  const auto stiffness = [&](double pressure) {
    return Eigen::MatrixXd(SmallMotion(network, backbone, {.pressure = pressure}).stiffness());
  };
  const SmallMotion small(network, backbone, {});
  const Eigen::MatrixXd of_bath = stiffness(0.3) - stiffness(0.1);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(small.unknowns(), small.unknowns());
  const double unit = small.strains()(0, 0);
  expected.bottomRightCorner<6, 6>().topLeftCorner<3, 3>().setConstant(0.2 * network.volume * unit * unit);
  EXPECT_LT((of_bath - expected).norm(), 1e-14);
}

// Moved as a whole a packing feels nothing; what is left of a motion has its centre at rest.
TEST(SmallMotion, KnowsNoPlace) {
  const Packing& packing = jammed();
  const ContactNetwork network = contact_network(packing, {.law = HookeSynchronized{{.friction = 0.3}}});
  const Backbone backbone = find_backbone(network, packing.species, {0, 2, true});
  const SmallMotion small(network, backbone, {});
  VectorXd whole = VectorXd::Zero(small.unknowns());
  for (Eigen::Index k = 0; k < small.particles(); ++k) whole.segment<3>(6 * k) << 1, 2, 3;
  EXPECT_LT((small.stiffness() * whole).norm(), 1e-12);
  EXPECT_LT((small.damping() * whole).norm(), 1e-12);
  small.hold_centre(whole);
  EXPECT_LT(whole.norm(), 1e-13);
  test::Dice dice(4);
  VectorXd force = small.stiffness() * random_vector(dice, small.unknowns());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(force(Eigen::seqN(axis, small.particles(), 6)).sum(), 0, 1e-11);
}

}  // namespace
}  // namespace furnas
