#pragma once

#include <cstddef>

namespace furnas {

/// The memory traffic of a particle-step if no data stay in the cache between two phases.
struct Traffic {
  bool spins = true;  ///< true with friction
  double pairs{};     ///< candidate pairs per particle that a step checks
  bool mixed = true;  ///< mixed precision
};

/// Bytes that a particle-step moves, counted as passes over arrays. The particle's record is read by the
/// forces, and read and written by each of the two kicks (5 passes); its load (force and torque) is written
/// and read; each candidate pair reads its partner's index and its row's index (4 bytes each), writes and
/// reads its row, and reads and writes its history. Partners' records, the list's offsets and rebuilds are
/// left out.
double bytes_per_particle_step(const Traffic& traffic);

/// Bytes per second that a triad a = b + s c moves with this number of threads: the best of several passes,
/// counted as in STREAM, 24 bytes per element (McCalpin 1995). Each array has `bytes`.
double triad_bandwidth(int threads, std::size_t bytes);

/// Size in bytes of an array. Three such arrays are much larger than the last-level cache, if the free memory
/// allows it.
std::size_t triad_size();

}  // namespace furnas
