#include "cases/program/bench/force_error.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "engine/certificate/overlaps.h"
#include "engine/simulation.h"

namespace furnas {
namespace {

using Long = long double;
using Far = Vec3<Long>;

Far wide(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// A contact from either calculation; i is the particle with the larger index.
struct PairForce {
  std::uint32_t i, j;  ///< j <= i
  Far branch;          ///< from j to i [d_s]
  Far force;           ///< on i [k_n d_s]
};

PairForce seen_from_later(PairForce t) { return t.i >= t.j ? t : PairForce{t.j, t.i, -t.branch, -t.force}; }

void sort_by_pair(std::vector<PairForce>& forces) {
  std::sort(forces.begin(), forces.end(),
            [](const PairForce& a, const PairForce& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
}

/// The parameters of a law that determine the force of a fresh contact (one without history).
struct FreshLaw {
  HookeConstants constants;
  bool spins, legacy;

  explicit FreshLaw(const AnyLaw& law)
      : constants(constants_of(law)), spins(has_friction(law)), legacy(!arms_meet(law)) {}

  /// Force on i of a contact without history. In the legacy law, as in LAMMPS, a fresh contact beyond the
  /// Coulomb limit has no tangential force.
  Far force(const Packing& p, const PairForce& t) const {
    const Long distance = norm(t.branch);
    const Long radius_i = p.radius[t.i], radius_j = p.radius[t.j];
    const Long mass_i = p.mass[t.i], mass_j = p.mass[t.j];
    const Long overlap = radius_i + radius_j - distance;
    const Long mass = mass_i * mass_j / (mass_i + mass_j);
    const Far normal = t.branch * (1 / distance);
    const Far velocity = wide(p.velocity[t.i]) - wide(p.velocity[t.j]);
    const Long approach = dot(velocity, normal);
    Long f_n = overlap - mass * Long(constants.normal_damping) * approach;
    if (!constants.attraction) f_n = std::max(f_n, Long(0));
    if (!spins) return f_n * normal;
    const Long shortening = legacy ? 0 : overlap / 2;
    const Far turning =
        (radius_i - shortening) * wide(p.spin[t.i]) + (radius_j - shortening) * wide(p.spin[t.j]);
    const Far slip = velocity - approach * normal - cross(turning, normal);
    Far f_t = (-mass * Long(constants.tangential_damping)) * slip;
    const Long size = norm(f_t);
    const Long limit = Long(constants.friction) * std::abs(f_n);
    if (size > limit) f_t *= legacy ? 0 : limit / size;
    return f_n * normal + f_t;
  }
};

/// s_i - s_j - cells along one edge; the integers carry the nearest difference exactly.
Long difference(std::uint64_t i, std::uint64_t j, std::int64_t cells) {
  const Long scale = 1 / static_cast<Long>(two_to_64);
  const Long nearest = static_cast<Long>(static_cast<std::int64_t>(i - j)) * scale;
  const Long about = static_cast<Long>(i) * scale - static_cast<Long>(j) * scale - static_cast<Long>(cells);
  return nearest + std::round(about - nearest);
}

std::vector<PairForce> exact_forces(const Packing& p, const FreshLaw& law) {
  const Triangle& h = p.cell.edges;
  std::vector<PairForce> forces;
  for (const Overlap& o : find_overlaps(p)) {
    const Fraction &a = p.fraction[o.i], &b = p.fraction[o.j];
    const Far d{difference(a.x, b.x, o.cells[0]), difference(a.y, b.y, o.cells[1]),
                difference(a.z, b.z, o.cells[2])};
    PairForce t{o.i,
                o.j,
                {Long(h.xx) * d.x + Long(h.xy) * d.y + Long(h.xz) * d.z, Long(h.yy) * d.y + Long(h.yz) * d.z,
                 Long(h.zz) * d.z},
                {}};
    t.force = law.force(p, t);
    forces.push_back(seen_from_later(t));
  }
  sort_by_pair(forces);
  return forces;
}

std::vector<PairForce> forces_of(const std::vector<Contact>& contacts) {
  std::vector<PairForce> forces;
  forces.reserve(contacts.size());
  for (const Contact& c : contacts)
    forces.push_back(seen_from_later({c.i, c.j, wide(c.branch), wide(c.force)}));
  sort_by_pair(forces);
  return forces;
}

/// Adds up the force differences of contacts of the same image of the same pair.
class Comparison {
 public:
  void compare(const Packing& p, const std::vector<PairForce>& exact, const std::vector<PairForce>& found) {
    error_.contacts = exact.size();
    auto first = found.begin();
    for (const PairForce& e : exact) {
      while (first != found.end() && std::tie(first->i, first->j) < std::tie(e.i, e.j)) ++first;
      const Long near = Long(0.1) * (Long(p.radius[e.i]) + Long(p.radius[e.j]));
      auto same = first;
      while (same != found.end() && same->i == e.i && same->j == e.j && !take(e, *same, near)) ++same;
      if (same == found.end() || same->i != e.i || same->j != e.j) ++error_.missed;
    }
    error_.spurious = found.size() - (error_.contacts - error_.missed);
  }

  ForceError result(const std::vector<PairForce>& exact) {
    Long sum = 0;
    for (const PairForce& e : exact) sum += norm(e.force);
    if (shares_.empty() || sum == 0) return error_;
    const auto middle = shares_.begin() + static_cast<std::ptrdiff_t>(shares_.size() / 2);
    std::nth_element(shares_.begin(), middle, shares_.end());
    error_.median = *middle;
    error_.largest = static_cast<double>(largest_ / (sum / static_cast<Long>(exact.size())));
    return error_;
  }

 private:
  bool take(const PairForce& exact, const PairForce& found, Long near) {
    Far force = found.force;
    if (norm(exact.branch - found.branch) > near) {
      // The contact of a sphere with its own image may have either of two opposite branches.
      if (exact.i != exact.j || norm(exact.branch + found.branch) > near) return false;
      force = -force;
    }
    const Long difference = norm(force - exact.force);
    largest_ = std::max(largest_, difference);
    if (const Long size = norm(exact.force); size > 0)
      shares_.push_back(static_cast<double>(difference / size));
    return true;
  }

  ForceError error_;
  std::vector<double> shares_;
  Long largest_ = 0;
};

}  // namespace

ForceError force_error(const AnyLaw& law, const Packing& packing, const std::vector<Contact>& contacts) {
  const std::vector<PairForce> exact = exact_forces(packing, FreshLaw(law));
  const std::vector<PairForce> found = forces_of(contacts);
  Comparison comparison;
  comparison.compare(packing, exact, found);
  return comparison.result(exact);
}

ForceError force_error(const Model& model, const Packing& packing, int threads) {
  Packing start = packing;
  start.order.clear();  // so that the forces are computed from the positions
  start.contacts.clear();
  const auto simulation = make_simulation(model, start, threads);
  return force_error(model.law, packing, simulation->packing().contacts);
}

}  // namespace furnas
