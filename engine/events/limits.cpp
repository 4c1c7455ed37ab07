#include "engine/events/limits.h"

#include <cmath>
#include <string>

namespace furnas {
namespace {

bool is_finite(const Measures& m) {
  const Triangle& h = m.cell.edges;
  const Triangle& e = m.cell.rate;
  return std::isfinite(m.kinetic_energy + m.mean_force + m.pressure) &&
         std::isfinite(h.xx + h.yy + h.zz + h.yz + h.xz + h.xy) &&
         std::isfinite(e.xx + e.yy + e.zz + e.yz + e.xz + e.xy);
}

}  // namespace

std::optional<Verdict> Budget::fire(Observation& now) {
  if (now.step() < last_step_) return {};
  return Verdict::budget;
}

bool Diverged::due(Observation& now) { return !reason(now.measures()).empty(); }

std::string Diverged::reason(const Measures& m) {
  if (!is_finite(m)) return "a number of the state is not finite at step " + std::to_string(m.step);
  if (m.phi > 1)
    return "the spheres fill " + std::to_string(m.phi) + " of the cell at step " + std::to_string(m.step) +
           "; the pressure is too high for their stiffness";
  return {};
}

}  // namespace furnas
