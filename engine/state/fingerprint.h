#pragma once

#include <cstdint>
#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// A 64-bit hash of what changes in a run and determines the further motion of a packing: step, cell and its
/// rate, positions, peculiar velocities, spins, and the contacts with their tangential histories. If the
/// hashes of two runs of one start and case agree, the runs agree bit by bit. Radii and masses, which no step
/// changes, are not included.
///
/// The hash does not depend on the order of particles in memory, on the order of the contacts, or on which
/// particle of a contact is named first. Quantities that are computed from the state (force, stress) are not
/// included.
std::uint64_t state_hash(const Packing& packing);

/// A hash as 16 hexadecimal digits.
std::string hex(std::uint64_t hash);

}  // namespace furnas
