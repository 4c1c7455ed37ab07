#include "io/case_protocol.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/energy.h"
#include "engine/start/gas.h"
#include "engine/state/shorter_edges.h"
#include "io/diameters_file.h"
#include "io/formats.h"

namespace furnas {
namespace {

CellFreedom freedom_of(const std::string& cell) {
  if (cell == "triclinic") return CellFreedom::triclinic;
  if (cell == "orthorhombic") return CellFreedom::orthorhombic;
  if (cell == "cubic") return CellFreedom::cubic;
  return CellFreedom::fixed;
}

RestCriteria rest_of(const Case::Stop& stop) {
  return {.kinetic_energy_alone = stop.criterion == "paper",
          .stress_error = stop.stress_error,
          .force_imbalance = stop.force_imbalance,
          .kinetic_energy = stop.kinetic_energy,
          .strain_drift = stop.strain_drift,
          .window = stop.window,
          .stilling = stop.stilling,
          .stilling_energy = stop.stilling_energy,
          .growth = stop.growth,
          .phi_error = stop.phi_error,
          .final_quenches = stop.final_quenches};
}

}  // namespace

Mixture mixture_of(const Case& c) {
  return {.size_ratio = c.mixture.size_ratio,
          .small_fraction = c.mixture.small_fraction,
          .large = c.mixture.large,
          .start_fraction = c.mixture.start_fraction,
          .seed = static_cast<std::uint64_t>(c.mixture.seed)};
}

Protocol protocol_of(const Case& c) {
  return {.law = c.contact.law,
          .contact = {.tangential_stiffness = c.contact.tangential_stiffness,
                      .normal_damping = c.contact.normal_damping,
                      .tangential_damping = c.contact.tangential_damping,
                      .friction = c.contact.friction,
                      .attraction = c.contact.attraction,
                      .winding = c.contact.winding},
          .affine_velocity = c.contact.velocity == "total",
          .pressures = c.compaction.pressure,
          .cell = freedom_of(c.compaction.cell),
          .inertia = c.compaction.inertia,
          .inertia_absolute = c.compaction.inertia_absolute,
          .cell_damping = c.compaction.cell_damping,
          .drag = c.compaction.drag,
          .time_step = c.compaction.time_step,
          .time_step_absolute = c.compaction.time_step_absolute,
          .rest = rest_of(c.stop),
          .minimizer = c.stop.minimizer,
          .steps = c.stop.steps,
          .precision = c.compute.precision == "mixed" ? Precision::mixed : Precision::full,
          .skin = c.compute.skin};
}

namespace {

/// The random start of a list of diameters.
Packing listed_start(const Case::Mixture& mixture) {
  std::vector<double> radii = read_diameters(mixture.diameters).diameters;
  double volume = 0;
  for (double& r : radii) volume += sphere_volume(r *= 0.5);
  constexpr double least_width = 2;  // as for a mixture: io/case_check.cpp
  if (dense_width(volume) < least_width)
    throw InputError(
        fmt::format("mixture.diameters = \"{}\": {} spheres make a cell only {:.1f} smallest "
                    "diameters wide when dense, too narrow to jam; allowed: at least 2, so list more spheres",
                    mixture.diameters, radii.size(), dense_width(volume)));
  return dilute_gas(
      radii, {.start_fraction = mixture.start_fraction, .seed = static_cast<std::uint64_t>(mixture.seed)});
}

/// Takes out the mean velocity, if there is more of it than rounding. A bath would take it for pressure.
void stop_drift(Packing& packing) {
  Vec3<double> momentum{};
  double mass = 0, motion = 0;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    momentum += packing.mass[k] * packing.velocity[k];
    mass += packing.mass[k];
    motion += packing.mass[k] * dot(packing.velocity[k], packing.velocity[k]);
  }
  const Vec3<double> mean = momentum * (1 / mass);
  constexpr double rounding = 1e-9;
  if (!(mass * dot(mean, mean) > rounding * motion)) return;
  for (Vec3<double>& velocity : packing.velocity) velocity -= mean;
}

/// The packing of start.file, in which steps, time and energy are counted anew.
Packing read_start(const Case& c) {
  Packing packing = read_packing(c.start.file);
  stop_drift(packing);
  constexpr double strong_tilt =
      10;  // a run shortens edges beyond 0.55, but its first list needs a thick cell
  shorten_edges(packing, strong_tilt);
  packing.step = 0;
  packing.time = 0;
  packing.labels.origin = {};  // positions in a run are relative to the corner of the cell
  packing.labels.turned = false;
  return packing;
}

}  // namespace

Packing start_of(const Case& c) {
  Packing packing = !c.start.file.empty()          ? read_start(c)
                    : !c.mixture.diameters.empty() ? listed_start(c.mixture)
                                                   : dilute_start(mixture_of(c));
  constexpr double of_solid_spheres = 3;
  if (c.compaction.mass_exponent != of_solid_spheres) set_masses(packing, c.compaction.mass_exponent);
  if (!packing.order.empty()) {  // with an order the simulation keeps forces and ledger
    const ContactWork last = packing.ledger.last;
    packing.ledger = {};
    packing.ledger.initial = energy(packing, law_of(protocol_of(c))).total();
    packing.ledger.last = last;
  }
  return packing;
}

int backbone_threshold_of(const Case& c) { return backbone_threshold(law_of(protocol_of(c))); }

Model model_of(const Case& c, const Packing& start) { return model_of(protocol_of(c), start); }

}  // namespace furnas
