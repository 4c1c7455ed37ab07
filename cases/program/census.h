#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/state/species.h"
#include "io/case.h"

namespace furnas {

/// The spheres of a case before it runs.
struct Census {
  /// A sphere that stands for others: of a species, or the smallest and the largest of many sizes.
  struct Kind {
    std::string name;   ///< "large", "small", "largest", "smallest"
    double count{};     ///< that it stands for
    double diameter{};  ///< [d_s]
    double mass{};      ///< of the lightest of them [rho d_s^3]
  };
  std::vector<Kind> kinds;  ///< the smaller one first
  double particles{};
  double volume{};  ///< of the spheres [d_s^3]
  Sizes sizes;      ///< of the spheres
  std::array<double, 2>
      lightest{};  ///< masses of the two lightest spheres; twice the same of a lone one [rho d_s^3]
  std::array<double, 2> density{};  ///< least and largest [rho]
  bool polydisperse{};              ///< one species of many sizes
};

/// Counts a mixture without building it; reads the file of a start. Throws InputError.
Census census_of(const Case& c);

/// Two lines at most that say which spheres there are.
std::string text_of(const Census& census);

/// What is to be said of a start file whose smallest sphere does not have the diameter 1, with the command
/// that rescales it; empty if there is nothing.
std::string refusal_of_units(const Census& census, const Case& c);

}  // namespace furnas
