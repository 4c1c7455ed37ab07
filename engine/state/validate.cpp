#include "engine/state/validate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/require.h"
#include "engine/state/shorter_edges.h"

namespace furnas {
namespace {

std::string name(const Packing& p, std::size_t k) { return "particle " + std::to_string(p.id(k)); }

bool finite(const Ledger& l) {
  return std::isfinite(l.initial + l.cell_work + l.losses.total() + l.quenched + l.last.losses.total()) &&
         finite(l.last.push);
}

std::string flaw_of_lengths(const Packing& p) {
  const std::size_t n = p.size();
  if (n == 0) return "the packing has no particles";
  const std::pair<const char*, std::size_t> lengths[] = {
      {"species", p.species.size()},   {"masses", p.mass.size()},         {"positions", p.fraction.size()},
      {"images", p.image.size()},      {"velocities", p.velocity.size()}, {"spins", p.spin.size()},
      {"forces", p.force.size()},      {"torques", p.torque.size()},      {"ids", p.labels.id.size()},
      {"types", p.labels.type.size()}, {"places", p.order.size()}};
  const std::string_view optional[] = {"ids", "types", "places"};
  for (const auto& [what, length] : lengths) {
    if (length == n) continue;
    if (length == 0 && std::find(std::begin(optional), std::end(optional), what) != std::end(optional))
      continue;
    return "the packing has " + std::to_string(n) + " radii and " + std::to_string(length) + " " + what;
  }
  return {};
}

std::string flaw_of_cell(const Packing& p) {
  const Triangle& h = p.cell.edges;
  if (!finite(h) || !finite(p.cell.rate)) return "an edge of the cell or its rate is not finite";
  if (!(h.xx > 0 && h.yy > 0 && h.zz > 0 && h.determinant() > 0) || !std::isfinite(h.determinant()))
    return "the cell has no volume: its edges must be above zero along the diagonal";
  if (is_tilted(h, most_tilt)) return "a tilt of the cell is larger than 1e6 edges";
  if (!p.stress.contacts.allFinite() || !p.stress.motion.allFinite())
    return "a component of the stress is not finite";
  if (!finite(p.ledger)) return "a sum of the energy ledger is not finite";
  return std::isfinite(p.time) ? "" : "the time is not finite";
}

std::string flaw_of_particle(const Packing& p, std::size_t k) {
  if (!(p.radius[k] > 0) || !(p.mass[k] > 0) || !std::isfinite(p.radius[k] + p.mass[k]))
    return name(p, k) + " has radius " + std::to_string(p.radius[k]) + " and mass " +
           std::to_string(p.mass[k]) + "; both must be above zero and finite";
  const std::pair<const char*, const Vec3<double>&> values[] = {
      {"velocity", p.velocity[k]}, {"spin", p.spin[k]}, {"force", p.force[k]}, {"torque", p.torque[k]}};
  for (const auto& [what, value] : values)
    if (!finite(value)) return "the " + std::string(what) + " of " + name(p, k) + " is not finite";
  return {};
}

std::string flaw_of_spheres(const Packing& p) {
  if (std::string flaw = flaw_of_lengths(p); !flaw.empty()) return flaw;
  if (std::string flaw = flaw_of_cell(p); !flaw.empty()) return flaw;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (std::string flaw = flaw_of_particle(p, k); !flaw.empty()) return flaw;
  return {};
}

/// A sentence about a contact of a particle that is not there; empty if both are there.
std::string flaw_of_ends(const Packing& p, const Contact& c) {
  if (c.i < p.size() && c.j < p.size()) return {};
  return "a contact is of particle " + std::to_string(std::max(c.i, c.j) + 1) + ", and there are " +
         std::to_string(p.size()) + " particles";
}

std::string flaw_of_histories(const Packing& p) {
  for (const Contact& c : p.contacts) {
    if (std::string flaw = flaw_of_ends(p, c); !flaw.empty()) return flaw;
    if (!finite(c.history)) return "a tangential history is not finite";
  }
  return {};
}

std::string flaw_of_contact(const Packing& p, const Contact& c) {
  if (std::string flaw = flaw_of_ends(p, c); !flaw.empty()) return flaw;
  if (finite(c.force) && finite(c.history) && finite(c.branch) && std::isfinite(c.overlap)) return {};
  return "the force, the history or the overlap of the contact of particles " + std::to_string(p.id(c.i)) +
         " and " + std::to_string(p.id(c.j)) + " is not finite";
}

/// A sentence about an order in memory that does not name every particle once; empty if it does.
std::string flaw_of_order(const Packing& p) {
  std::vector<bool> named(p.size());
  for (const std::uint32_t k : p.order) {
    if (k >= p.size()) return "the order in memory names a particle that is not there";
    if (named[k]) return "the order in memory names " + name(p, k) + " twice";
    named[k] = true;
  }
  return {};
}

/// A sentence about two particles with the same centre; empty if there are none.
std::string common_centre(const Packing& p) {
  std::vector<std::uint32_t> order(p.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto key = [&](std::uint32_t k) {
    const Fraction& s = p.fraction[k];
    return std::tuple(s.x, s.y, s.z, k);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t n = 1; n < order.size(); ++n)
    if (p.fraction[order[n - 1]] == p.fraction[order[n]])
      return name(p, order[n - 1]) + " and " + name(p, order[n]) + " have the same centre";
  return {};
}

}  // namespace

std::string flaw_of(const Packing& p) {
  if (std::string flaw = flaw_of_spheres(p); !flaw.empty()) return flaw;
  for (const Contact& c : p.contacts)
    if (std::string flaw = flaw_of_contact(p, c); !flaw.empty()) return flaw;
  return {};
}

void validate(const Packing& p, const std::string& source) {
  std::string flaw = flaw_of_spheres(p);
  if (flaw.empty()) flaw = flaw_of_histories(p);
  if (flaw.empty()) flaw = flaw_of_order(p);
  if (flaw.empty()) flaw = common_centre(p);
  if (!flaw.empty()) throw InputError(source.empty() ? flaw : source + ": " + flaw);
}

}  // namespace furnas
