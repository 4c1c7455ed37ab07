#pragma once

#include <cstdint>
#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// A 64-bit hash of all that decides how a packing moves on: step, cell and its rate, positions, peculiar
/// velocities, spins, and the contacts with their tangential history. Two runs agree bit by bit if theirs
/// agree.
///
/// Neither the order of particles in memory nor the order of the contacts, nor which of its two particles a
/// contact names first, has an effect; nor has what is computed anew from the state (force, stress).
std::uint64_t state_hash(const Packing& packing);

/// A hash as 16 hexadecimal digits.
std::string hex(std::uint64_t hash);

}  // namespace furnas
