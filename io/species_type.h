#pragma once

#include <algorithm>
#include <string_view>

#include "engine/state/packing.h"

namespace furnas {

/// The type of a species in files of LAMMPS.
inline int type_of(Species species) { return species == Species::large ? 1 : 2; }

/// How many types a packing has in files of LAMMPS.
inline int type_count(const Packing& packing) {
  return std::find(packing.species.begin(), packing.species.end(), Species::small) == packing.species.end()
             ? 1
             : 2;
}

/// The name of a species in files.
inline std::string_view name_of(Species species) { return species == Species::large ? "large" : "small"; }

}  // namespace furnas
