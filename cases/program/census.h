#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/state/species.h"
#include "io/case.h"

namespace furnas {

/// The spheres of a case before it runs.
struct Census {
  /// A sphere that represents others: one for each species, or the smallest and the largest of many sizes.
  struct Kind {
    std::string name;   ///< "large", "small", "largest", "smallest"
    double count{};     ///< spheres that it represents
    double diameter{};  ///< [d_s]
    double mass{};      ///< of the lightest of these spheres [rho d_s^3]
  };
  std::vector<Kind> kinds;  ///< the smaller one first
  double particles{};
  double volume{};  ///< of the spheres [d_s^3]
  Sizes sizes;      ///< of the spheres
  std::array<double, 2>
      lightest{};  ///< masses of the two lightest spheres; a single sphere counts as two [rho d_s^3]
  std::array<double, 2> density{};  ///< least and largest [rho]
  bool polydisperse{};              ///< one species of many sizes
};

/// Counts the spheres of a mixture without creating them; of a start.file it reads the file. Throws
/// InputError.
Census census_of(const Case& c);

/// At most two lines that describe the spheres.
std::string text_of(const Census& census);

/// The refusal of a start file whose smallest sphere does not have the diameter 1, with the command that
/// rescales it; empty if there is nothing to refuse.
std::string refusal_of_units(const Census& census, const Case& c);

}  // namespace furnas
