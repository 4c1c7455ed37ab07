#include "engine/monitor/faults.h"

#include <cmath>
#include <vector>

#include "engine/monitor/stability.h"

namespace furnas {
namespace {

bool finite(const Ledger& l) {
  return std::isfinite(l.initial + l.cell_work + l.losses.total() + l.quenched + l.last.losses.total()) &&
         finite(l.last.push);
}

std::string name(std::size_t k) { return std::to_string(k + 1); }
std::string names(const Contact& c) { return name(c.i) + " and " + name(c.j); }

std::string at(const Packing& p) { return " at step " + std::to_string(p.step); }

std::string not_finite(const Packing& p) {
  if (!finite(p.cell.edges) || !finite(p.cell.rate))
    return "an edge of the cell or its rate is not finite" + at(p);
  if (!p.stress.contacts.allFinite() || !p.stress.motion.allFinite())
    return "a component of the stress is not finite" + at(p);
  if (!finite(p.ledger)) return "a sum of the energy ledger is not finite" + at(p);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::pair<const char*, const Vec3<double>&> values[] = {
        {"velocity", p.velocity[k]}, {"spin", p.spin[k]}, {"force", p.force[k]}, {"torque", p.torque[k]}};
    for (const auto& [what, value] : values)
      if (!finite(value))
        return "the " + std::string(what) + " of particle " + name(k) + " is not finite" + at(p);
  }
  for (const Contact& c : p.contacts)
    if (!finite(c.force) || !finite(c.history) || !finite(c.branch))
      return "the force or the history of the contact of particles " + names(c) + " is not finite" + at(p);
  return {};
}

std::string run_through(const Packing& p) {
  for (const Contact& c : p.contacts) {
    const double share = c.overlap / (p.radius[c.i] + p.radius[c.j]);
    if (share > deepest_overlap)
      return "particles " + names(c) +
             " have run into each other until their centres nearly coincide (overlap " +
             std::to_string(share) + " of the sum of their radii)" + at(p) + "; press more slowly";
  }
  return {};
}

}  // namespace

std::string fault_of(const Packing& p, const Model& model) {
  if (std::string fault = not_finite(p); !fault.empty()) return fault;
  const double phi = p.fraction_filled();
  if (phi > 1)
    return "the spheres fill " + std::to_string(phi) + " of the cell" + at(p) +
           "; the pressure is too high for their stiffness";
  if (std::string fault = run_through(p); !fault.empty()) return fault;
  constexpr double limit = 2;
  if (const double step = stiffest_step(p, model); step > limit)
    return "the time step is too long for the contacts" + at(p) +
           ": times their stiffest frequency it may reach " + std::to_string(step) +
           ", allowed up to 2; take " + std::to_string(limit / step) + " of it";
  return {};
}

}  // namespace furnas
