#include "engine/protocol/protocol.h"

#include <cmath>
#include <numeric>
#include <string>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/stability.h"

namespace furnas {

AnyLaw law_of(const Protocol& p) {
  const bool legacy = p.law == HookeHistory::name;
  if (!legacy && p.law != HookeSynchronized::name)
    throw InputError("\"" + std::string(p.law) + "\" is no contact law; allowed: " + HookeSynchronized::name +
                     ", " + HookeHistory::name);
  if (p.contact.friction == 0) {
    if (legacy) return Frictionless<true>{p.contact};
    return Frictionless<false>{p.contact};
  }
  if (legacy) return HookeHistory{p.contact};
  return HookeSynchronized{p.contact};
}

int backbone_threshold(const AnyLaw& law) { return has_friction(law) ? 2 : 4; }

Touch<double> equal_pair(double diameter) {
  const double mass = sphere_mass(diameter / 2);
  return resting_touch(diameter / 2, diameter / 2, reduced_mass(mass, mass), 0);
}

std::optional<double> time_step_of(const Protocol& p) {
  if (p.time_step_absolute) return p.time_step_absolute;
  const auto unit = collision_time(law_of(p), equal_pair(1));
  if (!unit) return {};
  return p.time_step * *unit;
}

double cell_inertia(double beta, double mass, double sphere_volume) {
  constexpr double reference_fraction = 0.64;
  const double length = std::cbrt(sphere_volume / reference_fraction);
  return beta * mass * length * length / 12;
}

Model model_of(const Protocol& p, const Packing& start) {
  const auto step = time_step_of(p);
  if (!step)
    throw InputError(
        "compaction.time_step: no collision time, the contact of two small spheres is overdamped");
  const double mass = std::accumulate(start.mass.begin(), start.mass.end(), 0.0);
  return {.law = law_of(p),
          .precision = p.precision,
          .barostat = {.freedom = p.cell,
                       .pressure = p.pressures.front(),
                       .inertia =
                           p.inertia_absolute.value_or(cell_inertia(p.inertia, mass, start.sphere_volume())),
                       .drag = p.drag,
                       .legacy = p.law == HookeHistory::name},
          .time_step = *step,
          .affine_velocity = p.affine_velocity,
          .skin = p.skin};
}

}  // namespace furnas
