#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/state/packing.h"

namespace furnas {

/// How often a cell is repeated along each of its edges, 1 or more.
using Times = std::array<std::int32_t, 3>;

inline std::size_t copies_of(const Times& times) {
  return static_cast<std::size_t>(times[0]) * static_cast<std::size_t>(times[1]) *
         static_cast<std::size_t>(times[2]);
}

/// The same infinite packing described by a larger cell: times[a] cells along edge a make the new one.
///
/// Particle k of copy c has the index c N + k, copies counted along the first edge first. Fractions are
/// divided as the integers they are, so a place moves by at most 2^-64 of the new edge: contacts stay, forces
/// agree to rounding, and each contact keeps its force and history. A packing with an `order` goes on with
/// them in the order that the engine chooses for the new one; one without stays a start. Sums (stress times
/// volume, ledger) grow with the volume. Throws InputError for times below 1 and for more particles than 32
/// bits can count.
Packing replicate(const Packing& packing, const Times& times);

}  // namespace furnas
