#include "io/case_schema.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace furnas {
namespace {

constexpr double many_steps = 1e12;

Range from_to(double least, double most) { return {.least = least, .most = most}; }
Range above_to(double least, double most) { return {.least = least, .most = most, .above_least = true}; }
Range from_below(double least, double most) { return {.least = least, .most = most, .below_most = true}; }

/// A key that cannot be empty and has no rival key; most keys are such.
Key plain(std::string_view table, std::string_view name, std::string_view unit,
          std::variant<std::monostate, Range, Choices> allowed, std::string_view doc, Field (*field)(Case&)) {
  return {table, name, unit, std::move(allowed), {}, {}, doc, field};
}

/// A key whose value "auto" leaves the choice to the program.
Key automatic(std::string_view table, std::string_view name, std::string_view unit, Range allowed,
              std::string_view doc, Field (*field)(Case&)) {
  return {table, name, unit, allowed, "auto", {}, doc, field};
}

/// A key that sets the same quantity as `rival` in another unit; a case gives one of the two.
Key either(std::string_view table, std::string_view name, std::string_view rival, std::string_view unit,
           Range allowed, std::string_view doc, Field (*field)(Case&)) {
  return {table, name, unit, allowed, {}, rival, doc, field};
}

std::vector<Key> whole_case() {
  return {plain("", "preset", "", Choices{"none", "paper", "reference", "fast"},
                "values of the keys that are left out; none: the defaults; paper: the paper's protocol; "
                "reference: the most careful settings; fast: the fewest steps",
                [](Case& c) -> Field { return &c.preset; })};
}

std::vector<Key> mixture_and_start() {
  return {
      plain("mixture", "size_ratio", "", from_to(1, 100),
            "alpha, diameter of the large spheres over that of the small ones; the smallest spheres in the "
            "packing have the diameter d_s = 1",
            [](Case& c) -> Field { return &c.mixture.size_ratio; }),
      plain("mixture", "small_fraction", "", from_below(0, 1),
            "share of the small spheres in the volume of all spheres, f_s; 0: all spheres are large",
            [](Case& c) -> Field { return &c.mixture.small_fraction; }),
      plain("mixture", "large", "", from_to(1, 1e7),
            "number of large spheres N_l; the small ones follow, N_s = N_l alpha^3 f_s/(1 - f_s)",
            [](Case& c) -> Field { return &c.mixture.large; }),
      plain("mixture", "diameters", "", std::monostate{},
            "file with a list of diameters, one a line, in any unit, instead of the three keys above; the "
            "sizes may be any, and the smallest diameter becomes d_s",
            [](Case& c) -> Field { return &c.mixture.diameters; }),
      plain("mixture", "start_fraction", "", above_to(0, 0.3),
            "packing fraction of the random start; beyond 0.3 random insertion finds no more room",
            [](Case& c) -> Field { return &c.mixture.start_fraction; }),
      plain("mixture", "seed", "", from_to(0, 1e15),
            "number that selects the random start; the same seed gives the same start, bit by bit",
            [](Case& c) -> Field { return &c.mixture.seed; }),
      plain("start", "file", "", std::monostate{},
            "start from this packing instead of [mixture]: a checkpoint, VTP, extended XYZ, LAMMPS data or "
            "dump",
            [](Case& c) -> Field { return &c.start.file; }),
  };
}

std::vector<Key> contact() {
  return {
      plain(
          "contact", "law", "", Choices{"hooke_synchronized", "hooke_history"},
          "contact law; hooke_synchronized is of second order in the time step; hooke_history repeats the "
          "scheme of the paper and of LAMMPS, in which small spheres that roll between large ones can stick",
          [](Case& c) -> Field { return &c.contact.law; }),
      plain("contact", "friction", "", from_to(0, 1e30),
            "Coulomb's coefficient mu; 0: no spin and no tangential forces; 1e30: contacts never slide",
            [](Case& c) -> Field { return &c.contact.friction; }),
      plain("contact", "tangential_stiffness", "k_n", from_to(0, 10),
            "k_t/k_n; above 10 the tangential spring, not the normal one, would set the time step",
            [](Case& c) -> Field { return &c.contact.tangential_stiffness; }),
      plain("contact", "normal_damping", "1/time", from_to(0, 100),
            "gamma_n; the damping force is m_eff gamma_n times the normal velocity",
            [](Case& c) -> Field { return &c.contact.normal_damping; }),
      plain("contact", "tangential_damping", "1/time", from_to(0, 100),
            "gamma_t; the damping force is m_eff gamma_t times the slip velocity",
            [](Case& c) -> Field { return &c.contact.tangential_damping; }),
      plain("contact", "attraction", "", std::monostate{},
            "true: the normal dashpot may pull while a contact opens, as in the paper; false: the normal "
            "force is never negative",
            [](Case& c) -> Field { return &c.contact.attraction; }),
      plain("contact", "winding", "", std::monostate{},
            "true: damping may stretch the spring of a sliding contact beyond Coulomb's limit, as in the "
            "paper; false: the slider is in series with spring and dashpot",
            [](Case& c) -> Field { return &c.contact.winding; }),
      plain("contact", "velocity", "", Choices{"peculiar", "total"},
            "relative velocity in the contact law: with the affine flow of the cell (total) or without it "
            "(peculiar)",
            [](Case& c) -> Field { return &c.contact.velocity; }),
  };
}

std::vector<Key> compaction() {
  return {
      plain("compaction", "pressure", "k_n/d_s", above_to(0, 0.1),
            "applied pressure p_a, or a list of pressures at which the packing comes to rest in turn, or "
            "settles if stop.phi_error is set; beyond 0.1 overlaps are no longer small",
            [](Case& c) -> Field { return &c.compaction.pressure; }),
      plain("compaction", "cell", "", Choices{"triclinic", "orthorhombic", "cubic", "fixed"},
            "what may change: edges and angles (triclinic), edges (orthorhombic), the volume alone (cubic), "
            "nothing (fixed)",
            [](Case& c) -> Field { return &c.compaction.cell; }),
      either("compaction", "inertia", "inertia_absolute", "M L_ref^2/12", above_to(0, 1e6),
             "inertia of the cell, beta; a light cell oscillates, a heavy cell rebounds",
             [](Case& c) -> Field { return &c.compaction.inertia; }),
      either("compaction", "inertia_absolute", "inertia", "rho d_s^5", above_to(0, 1e30),
             "inertia W of the cell itself; replaces the key inertia",
             [](Case& c) -> Field { return &c.compaction.inertia_absolute; }),
      either("compaction", "cell_damping", "drag", "", from_to(0, 1000),
             "drag on the strain rate of the cell over (p_a V/W)^(1/2), V being the volume of the dense "
             "cell; 2 is critical, from 4 on the pressure exceeds p_a by at most 1 %",
             [](Case& c) -> Field { return &c.compaction.cell_damping; }),
      either("compaction", "drag", "cell_damping", "1/time", from_to(0, 1000),
             "drag of the cell itself, instead of cell_damping: the strain rate of the cell decays as "
             "exp(-drag t)",
             [](Case& c) -> Field { return &c.compaction.drag; }),
      {"compaction", "time_step", "t_c", above_to(0, 0.2), "auto", "time_step_absolute",
       "time step; auto: chosen by the program, 0.063 with friction and the default constants, 0.1 without "
       "friction",
       [](Case& c) -> Field { return &c.compaction.time_step; }},
      either("compaction", "time_step_absolute", "time_step", "time", above_to(0, 1000),
             "time step in absolute units; replaces the key time_step",
             [](Case& c) -> Field { return &c.compaction.time_step_absolute; }),
      plain(
          "compaction", "mass_exponent", "", from_to(0, 3),
          "the mass of a sphere grows with this power of its diameter; 3: solid spheres, or the masses of a "
          "start file; below 3 large spheres are light, runs are shorter, and packings with friction are "
          "less dense",
          [](Case& c) -> Field { return &c.compaction.mass_exponent; }),
  };
}

std::vector<Key> stop() {
  return {
      plain("stop", "criterion", "", Choices{"rest", "paper"},
            "rest: all of the conditions below; paper: the kinetic energy per particle alone",
            [](Case& c) -> Field { return &c.stop.criterion; }),
      plain("stop", "stress_error", "", above_to(0, 1),
            "largest deviation of a stress component from the applied one, over p_a",
            [](Case& c) -> Field { return &c.stop.stress_error; }),
      plain("stop", "force_imbalance", "", above_to(0, 1),
            "mean net force on the backbone over the mean contact force",
            [](Case& c) -> Field { return &c.stop.force_imbalance; }),
      plain("stop", "kinetic_energy", "k_n d_s^2", above_to(0, 1),
            "kinetic energy per particle of the backbone (rest) or of all particles (paper)",
            [](Case& c) -> Field { return &c.stop.kinetic_energy; }),
      plain("stop", "strain_drift", "", above_to(0, 1), "largest strain of the cell in 2000 t_c",
            [](Case& c) -> Field { return &c.stop.strain_drift; }),
      plain("stop", "window", "t_c", above_to(0, 1e9),
            "time over which all conditions must hold without a break",
            [](Case& c) -> Field { return &c.stop.window; }),
      plain("stop", "stilling", "", from_to(0, 1e9),
            "all motion is set to zero near the end, once force_imbalance and strain_drift are within this "
            "factor of their limits; a larger factor saves steps and makes mixtures less dense; 0: never",
            [](Case& c) -> Field { return &c.stop.stilling; }),
      plain("stop", "stilling_energy", "", from_to(0, 1e30),
            "further condition for setting all motion to zero: the kinetic energy of the backbone is within "
            "this factor of its limit, or the forces balance",
            [](Case& c) -> Field { return &c.stop.stilling_energy; }),
      plain("stop", "growth", "", from_to(1, 1e30),
            "motion is not set to zero while the kinetic energy of the backbone grows by more than this "
            "factor in half a window, because an unstable packing must be left to move",
            [](Case& c) -> Field { return &c.stop.growth; }),
      plain("stop", "phi_error", "", from_to(0, 1),
            "a run that does not come to rest ends as settled once the possible further change of phi is "
            "bounded below this number; 0: never",
            [](Case& c) -> Field { return &c.stop.phi_error; }),
      plain("stop", "final_quenches", "", from_to(0, 1000),
            "number of times that all motion is set to zero, 2 t_c apart, when the packing is at rest and "
            "before "
            "it counts as jammed; 20 take out the hits of rattlers, which a certificate counts as contacts",
            [](Case& c) -> Field { return &c.stop.final_quenches; }),
      plain("stop", "minimizer", "", std::monostate{},
            "true: without friction, the forces are balanced at the end by minimizing the enthalpy; false: "
            "by time steps alone",
            [](Case& c) -> Field { return &c.stop.minimizer; }),
      plain("stop", "steps", "steps", from_to(0, many_steps),
            "largest number of steps; a run that ends by this limit is not called jammed",
            [](Case& c) -> Field { return &c.stop.steps; }),
  };
}

std::vector<Key> compute() {
  return {
      plain("compute", "precision", "", Choices{"mixed", "double"},
            "mixed: forces and velocities have single precision, positions, overlaps and sums double",
            [](Case& c) -> Field { return &c.compute.precision; }),
      automatic("compute", "threads", "", from_to(1, 1024),
                "number of threads; the result has the same bits for any number",
                [](Case& c) -> Field { return &c.compute.threads; }),
      automatic("compute", "skin", "d_s", from_to(0, 10),
                "margin of the neighbour list; changes the speed, not the result",
                [](Case& c) -> Field { return &c.compute.skin; }),
  };
}

std::vector<Key> output() {
  return {
      plain("output", "history_every", "steps", from_to(1, many_steps),
            "interval between two rows of history.csv",
            [](Case& c) -> Field { return &c.output.history_every; }),
      plain("output", "snapshot_every", "steps", from_to(0, many_steps),
            "interval between two frames of frames.pvd, which are then equally spaced in time; the first "
            "frame is the start; 0: none",
            [](Case& c) -> Field { return &c.output.snapshot_every; }),
      plain("output", "snapshot_phi", "", from_to(0, 1),
            "a frame is written when phi first exceeds each multiple of this number, for example 0.01; a "
            "film then shows the compaction in equal steps of phi; 0: none",
            [](Case& c) -> Field { return &c.output.snapshot_phi; }),
      plain("output", "checkpoint_minutes", "minutes", above_to(0, 1e5),
            "wall time between two checkpoints; a stopped run resumes from the last one",
            [](Case& c) -> Field { return &c.output.checkpoint_minutes; }),
      plain("output", "picture", "", Choices{"fig1a", "none"}, "style of the picture of the final packing",
            [](Case& c) -> Field { return &c.output.picture; }),
      plain("output", "picture_size", "pixels", from_to(16, 8192), "edge of the square picture",
            [](Case& c) -> Field { return &c.output.picture_size; }),
      plain("output", "background", "", Choices{"white", "transparent"}, "background of the picture",
            [](Case& c) -> Field { return &c.output.background; }),
  };
}

}  // namespace

std::span<const Key> case_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const auto& keys_of_table :
         {whole_case(), mixture_and_start(), contact(), compaction(), stop(), compute(), output()})
      all.insert(all.end(), keys_of_table.begin(), keys_of_table.end());
    return all;
  }();
  return keys;
}

bool Range::contains(double value) const {
  return std::isfinite(value) && (above_least ? value > least : value >= least) &&
         (below_most ? value < most : value <= most);
}

std::string Key::path() const {
  return table.empty() ? std::string(name) : std::string(table) + "." + std::string(name);
}

std::vector<std::string_view> case_tables() {
  std::vector<std::string_view> tables;
  for (const Key& key : case_keys())
    if (!key.table.empty() && (tables.empty() || tables.back() != key.table)) tables.push_back(key.table);
  return tables;
}

bool changes_no_bit(const Key& key) {
  constexpr std::string_view paths[] = {"stop.steps",
                                        "stop.phi_error",
                                        "compute.threads",
                                        "compute.skin",
                                        "output.checkpoint_minutes",
                                        "output.picture",
                                        "output.picture_size",
                                        "output.background"};
  return std::find(std::begin(paths), std::end(paths), key.path()) != std::end(paths);
}

const Key* find_key(std::string_view table, std::string_view name) {
  for (const Key& key : case_keys())
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

const Key* find_key(std::string_view path) {
  for (const Key& key : case_keys())
    if (key.path() == path) return &key;
  return nullptr;
}

void reset(const Key& key, Case& c) {
  Case defaults;
  std::visit([&](auto* field) { *field = *std::get<decltype(field)>(key.field(defaults)); }, key.field(c));
}

}  // namespace furnas
