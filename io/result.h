#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/events/at_rest.h"
#include "engine/state/measures.h"
#include "engine/state/species.h"
#include "io/case.h"

namespace furnas {

/// What a run found, and how.
struct Result {
  Verdict verdict = Verdict::budget;
  std::string reason;                      ///< why it ended so, in a sentence
  std::string version;                     ///< of furnas: another may give other bits
  Measures measures;                       ///< at the end
  RestReport rest;                         ///< how the criteria stood at the end
  std::vector<RestingState> reached;       ///< each pressure at which the packing came to rest
  double phi_bound = RestReport::unknown;  ///< on what phi may still change; infinite if not known
  std::int64_t quenches{};                 ///< times all motion was taken out (Quench)
  std::int64_t evaluations{};              ///< times the minimizer computed all forces
  std::int64_t flips{};                    ///< times the cell was flipped
  std::uint64_t state_hash{};              ///< of the final state
  std::int64_t large{}, small{};           ///< particles of each species
  bool polydisperse{};                     ///< spheres of one species differ in size
  Sizes sizes;                             ///< of the spheres
  double mean_diameter{};                  ///< [d_s]
  std::optional<double> listed_unit;       ///< what 1 d_s is in the unit of mixture.diameters
  double time_step{};                      ///< [time]
  double pressure{};                       ///< of the bath at the end [k_n/d_s]
  double inertia{};                        ///< W [rho d_s^5]
  int threads{};
  double wall_seconds{};      ///< of all processes that had a part in it
  double cpu_seconds{};       ///< that their threads have computed, all together
  std::int64_t steps_here{};  ///< steps that they took

  /// Least distance between opposite faces of the cell, in diameters of the largest sphere. A packing that is
  /// few of them thick says little about a large one.
  double thickness() const;

  /// Whether it means something to be large or small: not where spheres of many sizes are one species.
  bool has_species() const { return !polydisperse || (large > 0 && small > 0); }

  /// phi_J, which only a jammed packing has.
  std::optional<double> phi_J() const;
};

/// Cells of fewer of their largest diameters are too thin: spheres share their neighbours with their own
/// images, and the cell does not stand for a large packing.
inline constexpr double least_thickness = 3;

/// What is to be said of a cell so many of its largest diameters thick.
const char* remark_on_thickness(double diameters);

/// Writes result.json.
void write_result(const Result& result, const Case& c, const std::filesystem::path& path);

}  // namespace furnas
