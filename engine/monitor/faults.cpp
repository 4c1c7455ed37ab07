#include "engine/monitor/faults.h"

#include "engine/monitor/stability.h"
#include "engine/state/validate.h"

namespace furnas {
namespace {

std::string names(const Packing& p, const Contact& c) {
  return std::to_string(p.id(c.i)) + " and " + std::to_string(p.id(c.j));
}

std::string at(const Packing& p) { return " at step " + std::to_string(p.step); }

std::string run_through(const Packing& p) {
  for (const Contact& c : p.contacts) {
    const double share = c.overlap / (p.radius[c.i] + p.radius[c.j]);
    if (share > deepest_overlap)
      return "particles " + names(p, c) +
             " have run into each other until their centres nearly coincide (overlap " +
             std::to_string(share) + " of the sum of their radii)" + at(p) + "; press more slowly";
  }
  return {};
}

}  // namespace

std::string fault_of(const Packing& p, const Model& model) {
  if (std::string flaw = flaw_of(p); !flaw.empty()) return flaw + at(p);
  const double phi = p.fraction_filled();
  if (phi > 1)
    return "the spheres fill " + std::to_string(phi) + " of the cell" + at(p) +
           (model.barostat.freedom == CellFreedom::fixed ? "; more than all of it"
                                                         : "; the pressure is too high for their stiffness");
  if (std::string fault = run_through(p); !fault.empty()) return fault;
  constexpr double limit = 2;
  if (const double step = stiffest_step(p, model); step > limit)
    return "the time step is too long for the contacts" + at(p) +
           ": times their stiffest frequency it may reach " + std::to_string(step) +
           ", allowed up to 2; take " + std::to_string(limit / step) + " of it";
  return {};
}

}  // namespace furnas
