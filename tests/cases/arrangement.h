#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "engine/state/packing.h"
#include "io/case.h"
#include "tests/engine/support/property.h"

namespace furnas::test {

/// A coordinate near a quarter of the cell; simplest on its face.
struct Coordinate {
  int quarter{};          ///< 0 ... 3
  std::int64_t offset{};  ///< [2^-64 of the cell]
};

/// Whole numbers, so that they shrink: a sphere as a property draws it.
struct DrawnSphere {
  Coordinate x, y, z;
  int growth{};                   ///< its diameter is 1 + growth/100 [d_s]
  std::array<int, 3> velocity{};  ///< [1/1000 d_s/time]
};

/// Spheres in a cell with the settings of a case, as a property draws them. Every number has a simplest
/// value, 0, and RapidCheck shrinks towards it: fewer spheres, of equal size, at rest, on faces of a cube.
struct Arrangement {
  std::vector<DrawnSphere> spheres;
  int tightness{};             ///< the cell is 3 - tightness/100 of the largest diameter wide
  std::array<int, 3> tilts{};  ///< yz, xz, xy [1/100 of the edge]
  int skin{};                  ///< of the neighbour list [1/100 d_s]
  int friction{};              ///< [1/10]
  int steps{};                 ///< to take before looking
};

std::ostream& operator<<(std::ostream& out, const Arrangement& arrangement);

/// What to draw.
struct Drawing {
  int most_spheres = 14;
  int largest_growth = 3900;  ///< up to a size ratio of 40
  int most_steps = 1;         ///< below this
  bool apart =
      false;  ///< centres at least a fifth of the sum of the radii apart, so that normals are defined
};

/// An arrangement, within a property.
Arrangement any_arrangement(const Drawing& drawing);

/// The packing that it means. Spheres that would share a centre are left out, or with `apart` come too near.
Packing packing_of(const Arrangement& arrangement, bool apart);

/// The case that runs it, from a start in `file`, in a cell that does not move.
Case case_of(const Arrangement& arrangement, const std::string& file);

/// Whether `property` holds for so many arrangements. It says what is wrong by throwing or by an RC_ASSERT.
/// If it fails, the smallest arrangement found is written to `folder`, as case.toml and start.extxyz, and the
/// answer says how to run it.
::testing::AssertionResult holds_for_arrangements(int cases, const Drawing& drawing,
                                                  const std::string& folder,
                                                  const std::function<void(const Arrangement&)>& property);

/// A folder for failures that stays: in the directory of temporary files, by the name of the running test.
std::string folder_of_failure();

}  // namespace furnas::test
