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

/// The result of a run, and how it was reached.
struct Result {
  Verdict verdict = Verdict::budget;
  std::string reason;                      ///< why it ended so, in a sentence
  std::string version;                     ///< of furnas; another version may give other bits
  Measures measures;                       ///< at the end
  RestReport rest;                         ///< state of the criteria of rest at the end
  std::vector<RestingState> reached;       ///< each pressure at which it came to rest or settled
  double phi_bound = RestReport::unknown;  ///< bound on the further change of phi; infinite if not known
  std::int64_t quenches{};                 ///< times that all motion was set to zero (Quench)
  std::int64_t evaluations{};              ///< times that the minimizer computed all forces
  std::int64_t flips{};                    ///< times that tilted edges were replaced by shorter ones
  std::uint64_t state_hash{};              ///< of the final state
  std::int64_t large{}, small{};           ///< particles of each species
  bool polydisperse{};                     ///< spheres of one species differ in size
  Sizes sizes;                             ///< of the spheres
  double mean_diameter{};                  ///< [d_s]
  std::optional<double> listed_unit;       ///< 1 d_s in the unit of mixture.diameters
  double time_step{};                      ///< [time]
  double pressure{};                       ///< of the bath at the end [k_n/d_s]
  double inertia{};                        ///< W [rho d_s^5]
  int threads{};
  double wall_seconds{};      ///< of all processes of the run
  double cpu_seconds{};       ///< CPU time of all their threads together
  std::int64_t steps_here{};  ///< steps of these processes together

  /// Least distance between opposite faces of the cell, in diameters of the largest sphere. A packing of only
  /// a few diameters says little about a large packing.
  double thickness() const;

  /// Millions of particle-steps that this process made in a second; nothing if no time has passed.
  std::optional<double> pace() const;

  /// Whether large and small spheres can be told apart. They cannot where spheres of many sizes form one
  /// species.
  bool has_species() const { return !polydisperse || (large > 0 && small > 0); }

  /// phi_J, which only a jammed packing has.
  std::optional<double> phi_J() const;
};

/// A cell thinner than this number of largest diameters is too thin to represent a large packing: a sphere
/// has images of its own neighbours as neighbours, and may order in layers. From here on no shift of phi_J
/// was measured (docs/developer/decisions/thin-cells.md).
inline constexpr double least_thickness = 2.5;

/// A thickness with one digit; one below least_thickness is rounded down, so that the text is below, too.
std::string thickness_text(double diameters);

/// A remark for the user on a cell of this thickness; empty if it is thick enough.
const char* remark_on_thickness(double diameters);

/// Writes result.json.
void write_result(const Result& result, const Case& c, const std::filesystem::path& path);

}  // namespace furnas
