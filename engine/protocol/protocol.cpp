#include "engine/protocol/protocol.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/stability.h"

namespace furnas {
namespace {

constexpr double reference_fraction = 0.64;  // of a dense packing

}  // namespace

void validate(const Protocol& p) {
  const auto refuse = [](const std::string& name, double value, const char* allowed) {
    throw InputError("protocol: " + name + " is " + std::to_string(value) + "; allowed: finite and " +
                     allowed);
  };
  const auto above_zero = [&](const std::string& name, double value) {
    if (!(std::isfinite(value) && value > 0)) refuse(name, value, "above 0");
  };
  const auto not_negative = [&](const std::string& name, double value) {
    if (!(std::isfinite(value) && value >= 0)) refuse(name, value, "at least 0");
  };
  if (p.pressures.empty()) throw InputError("a protocol needs at least one pressure");
  for (const double pressure : p.pressures) above_zero("a pressure", pressure);
  above_zero("inertia", p.inertia);
  above_zero("inertia_absolute", p.inertia_absolute.value_or(1));
  above_zero("time_step", p.time_step.value_or(1));
  above_zero("time_step_absolute", p.time_step_absolute.value_or(1));
  not_negative("skin", p.skin.value_or(0));
  above_zero("rest.window", p.rest.window);
  not_negative("cell_damping", p.cell_damping);
  not_negative("drag", p.drag.value_or(0));
  not_negative("contact.friction", p.contact.friction);
  not_negative("contact.tangential_stiffness", p.contact.tangential_stiffness);
  not_negative("contact.normal_damping", p.contact.normal_damping);
  not_negative("contact.tangential_damping", p.contact.tangential_damping);
}

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

double time_unit_of(const Protocol& p) {
  const AnyLaw law = law_of(p);
  const Touch<double> pair = equal_pair(1);
  const double undamped = std::numbers::pi / std::sqrt(stiffness_of(law, pair).normal / pair.reduced_mass);
  return collision_time(law, pair).value_or(undamped);
}

TimeStep chosen_time_step(const Protocol& p, double smallest) {
  if (p.time_step_absolute) return {*p.time_step_absolute, "compaction.time_step_absolute"};
  if (p.time_step) return {*p.time_step * time_unit_of(p), "compaction.time_step"};
  const AnyLaw law = law_of(p);
  const bool friction = has_friction(law);
  const Touch<double> pair = equal_pair(smallest);
  // Overdamped spheres do not collide in any time; the other rule then sets the step.
  const double of_collision =
      (friction ? 0.08 : 0.1) * collision_time(law, pair).value_or(std::numeric_limits<double>::infinity());
  constexpr int contacts = 8;  // docs/developer/decisions/length-of-a-step.md
  return std::min<TimeStep>({{of_collision, friction ? "auto: 0.08 of a collision of two small spheres"
                                                     : "auto: a tenth of a collision of two small spheres"},
                             {largest_stable_step_of_midway(law, pair, contacts),
                              friction ? "auto: the rule for a small sphere that sticks to eight others"
                                       : "auto: the rule for a small sphere that touches eight others"}},
                            [](const TimeStep& a, const TimeStep& b) { return a.length < b.length; });
}

double time_step_of(const Protocol& p, double smallest) { return chosen_time_step(p, smallest).length; }

double relative_time_step(const Protocol& p, double smallest) {
  return time_step_of(p, smallest) / time_unit_of(p);
}

double smallest_diameter(const Packing& p) {
  if (p.radius.empty()) throw InputError("the packing has no particles");
  return 2 * *std::min_element(p.radius.begin(), p.radius.end());
}

double smallest_kept_diameter(const Protocol& p, const Packing& start) {
  return 2 * kept_radius(p.precision, smallest_diameter(start) / 2);
}

double dense_width(double sphere_volume) { return std::cbrt(sphere_volume / reference_fraction); }

double dense_thickness(double sphere_volume) {
  constexpr double of_a_cube = 0.94;
  return of_a_cube * dense_width(sphere_volume);
}

double cell_inertia(double beta, double mass, double sphere_volume) {
  const double length = dense_width(sphere_volume);
  return beta * mass * length * length / 12;
}

std::vector<Barostat> baths_of(const Protocol& p, const Packing& start) {
  validate(p);
  const double mass = std::accumulate(start.mass.begin(), start.mass.end(), 0.0);
  // Uses the rounded radii of the simulation, because a run resumed from a checkpoint knows no others.
  double cubes = 0;
  for (const double radius : start.radius) {
    const double kept = kept_radius(p.precision, radius);
    cubes += kept * kept * kept;
  }
  const double volume = cubes * sphere_volume(1);
  const double inertia = p.inertia_absolute.value_or(cell_inertia(p.inertia, mass, volume));
  std::vector<Barostat> baths;
  for (const double pressure : p.pressures) {
    const double rate = std::sqrt(pressure * volume / reference_fraction / inertia);
    baths.push_back({.freedom = p.cell,
                     .pressure = pressure,
                     .inertia = inertia,
                     .drag = p.drag.value_or(p.cell_damping * rate),
                     .legacy = p.law == HookeHistory::name});
  }
  return baths;
}

Model model_of(const Protocol& p, const Packing& start) {
  return {.law = law_of(p),
          .precision = p.precision,
          .barostat = baths_of(p, start).front(),
          .time_step = time_step_of(p, smallest_kept_diameter(p, start)),
          .affine_velocity = p.affine_velocity,
          .skin = p.skin};
}

}  // namespace furnas
