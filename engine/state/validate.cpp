#include "engine/state/validate.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "engine/base/require.h"

namespace furnas {
namespace {

std::string name(const Packing& p, std::size_t k) { return "particle " + std::to_string(p.id(k)); }

bool finite(const Ledger& l) {
  return std::isfinite(l.initial + l.cell_work + l.losses.total() + l.quenched + l.last.losses.total()) &&
         finite(l.last.push);
}

std::string flaw_of_cell(const Packing& p) {
  const Triangle& h = p.cell.edges;
  if (!finite(h) || !finite(p.cell.rate)) return "an edge of the cell or its rate is not finite";
  if (!(h.xx > 0 && h.yy > 0 && h.zz > 0 && h.determinant() > 0) || !std::isfinite(h.determinant()))
    return "the cell has no volume: its edges must be above zero along the diagonal";
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
  if (p.size() == 0) return "the packing has no particles";
  if (std::string flaw = flaw_of_cell(p); !flaw.empty()) return flaw;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (std::string flaw = flaw_of_particle(p, k); !flaw.empty()) return flaw;
  return {};
}

std::string flaw_of_contact(const Packing& p, const Contact& c) {
  if (c.i >= p.size() || c.j >= p.size()) return "a contact names a particle that is not there";
  if (finite(c.force) && finite(c.history) && finite(c.branch) && std::isfinite(c.overlap)) return {};
  return "the force, the history or the overlap of the contact of particles " + std::to_string(p.id(c.i)) +
         " and " + std::to_string(p.id(c.j)) + " is not finite";
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
  const auto is_finite = [](const Contact& c) { return finite(c.history); };
  if (flaw.empty() && !std::all_of(p.contacts.begin(), p.contacts.end(), is_finite))
    flaw = "a tangential history is not finite";
  if (flaw.empty()) flaw = common_centre(p);
  if (!flaw.empty()) throw InputError(source.empty() ? flaw : source + ": " + flaw);
}

}  // namespace furnas
