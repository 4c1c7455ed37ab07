#include "cases/program/run/scenario.h"

#include <cmath>

#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/formats.h"

namespace furnas {
namespace {

AnyLaw law_of(const Case& c) {
  const HookeConstants constants{c.contact.tangential_stiffness, c.contact.normal_damping,
                                 c.contact.tangential_damping,   c.contact.friction,
                                 c.contact.attraction,           c.contact.winding};
  const bool legacy = c.contact.law == HookeHistory::name;
  if (c.contact.friction == 0) {
    if (legacy) return Frictionless<true>{constants};
    return Frictionless<false>{constants};
  }
  if (legacy) return HookeHistory{constants};
  return HookeSynchronized{constants};
}

CellFreedom freedom_of(const Case& c) {
  if (c.compaction.cell == "triclinic") return CellFreedom::triclinic;
  if (c.compaction.cell == "orthorhombic") return CellFreedom::orthorhombic;
  if (c.compaction.cell == "cubic") return CellFreedom::cubic;
  return CellFreedom::fixed;
}

/// W = beta M L_ref^2/12: the inertia of a block of the packing itself at a packing fraction of 0.64.
double inertia_of(const Case& c, const Packing& packing) {
  if (c.compaction.inertia_absolute) return *c.compaction.inertia_absolute;
  constexpr double reference_fraction = 0.64;
  double mass = 0;
  for (double m : packing.mass) mass += m;
  const double length = std::cbrt(packing.sphere_volume() / reference_fraction);
  return c.compaction.inertia * mass * length * length / 12;
}

}  // namespace

Mixture mixture_of(const Case& c) {
  return {c.mixture.size_ratio, c.mixture.small_fraction, c.mixture.large, c.mixture.start_fraction,
          static_cast<std::uint64_t>(c.mixture.seed)};
}

Packing start_of(const Case& c) {
  if (c.start.file.empty()) return dilute_start(mixture_of(c));
  Packing packing = read_packing(c.start.file);
  packing.step = 0;  // the clock of a run begins with it
  packing.time = 0;
  return packing;
}

Model model_of(const Case& c, const Packing& packing) {
  Model model;
  model.law = law_of(c);
  model.barostat.freedom = freedom_of(c);
  model.barostat.pressure = c.compaction.pressure.front();
  model.barostat.inertia = inertia_of(c, packing);
  model.barostat.drag = c.compaction.drag;
  model.barostat.legacy = c.contact.law == HookeHistory::name;
  const auto step = time_step(c);
  if (!step)
    throw InputError(
        "compaction.time_step: no collision time, the contact of two small spheres is overdamped");
  model.time_step = *step;
  model.precision = c.compute.precision == "mixed" ? Precision::mixed : Precision::full;
  model.affine_velocity = c.contact.velocity == "total";
  model.skin = c.compute.skin;
  return model;
}

RestCriteria rest_criteria_of(const Case& c) {
  RestCriteria rest;
  rest.kinetic_energy_alone = c.stop.criterion == "paper";
  rest.stress_error = c.stop.stress_error;
  rest.force_imbalance = c.stop.force_imbalance;
  rest.kinetic_energy = c.stop.kinetic_energy;
  rest.strain_drift = c.stop.strain_drift;
  rest.window = c.stop.window;
  return rest;
}

const char* remark_on_thickness(double diameters) {
  return diameters < 3 ? ": too thin to stand for a large packing" : "";
}

int backbone_threshold_of(const Case& c) { return c.contact.friction == 0 ? 4 : 2; }

}  // namespace furnas
