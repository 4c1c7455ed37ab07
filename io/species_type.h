#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Largest number of a type that a file may have; LAMMPS files name every type up to the largest.
constexpr std::int32_t most_types = 1'000'000;

/// The default type of a species in files.
inline std::int32_t type_of(Species species) { return species == Species::large ? 1 : 2; }

/// The default name of a species in files.
inline std::string_view name_of(Species species) { return species == Species::large ? "large" : "small"; }

/// The type of particle k in files.
inline std::int32_t type_of(const Packing& p, std::size_t k) {
  return p.labels.type.empty() ? type_of(p.species[k]) : p.labels.type[k];
}

/// How many types a packing has in files of LAMMPS, which number them without gaps.
std::int32_t type_count(const Packing& packing);

/// The name of a type in files: the name that the start file gave it, or its number there, or else the name
/// of its species ("sphere" in a polydisperse packing). May read all radii: for the names of all spheres,
/// names_of_types.
std::string name_of_type(const Packing& packing, std::int32_t type);

/// The names of the types 1, 2, ... up to the largest of a packing.
std::vector<std::string> names_of_types(const Packing& packing);

/// The chemical element for the type of particle k, in files that need one: the type's name if that is an
/// element; for the types 1 and 2 silver for large and gold for small spheres; for further types other
/// elements.
std::string_view element_of(const Packing& packing, std::size_t k);

}  // namespace furnas
