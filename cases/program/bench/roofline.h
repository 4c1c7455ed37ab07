#pragma once

#include <cstddef>

namespace furnas {

/// What a particle-step must move when nothing of it stays in the cache between two phases.
struct Traffic {
  bool spins = true;  ///< with friction
  double pairs{};     ///< candidate pairs per particle that a step looks at
  bool mixed = true;  ///< precision
};

/// Bytes that a particle-step moves, by counting passes over arrays: the particle's record is read by the
/// forces, and read and written by each of the two kicks (5 passes); its load is written and read; each
/// candidate pair reads its partner's index and its row's index (4 bytes each), writes and reads its row, and
/// reads and writes its history. Partners' records, the list's offsets and rebuilds are left out.
double bytes_per_particle_step(const Traffic& traffic);

/// Bytes a second that a triad a = b + s c moves with so many threads, the best of some passes; counted as
/// STREAM does, 24 bytes an element (McCalpin 1995). Each array has `bytes`.
double triad_bandwidth(int threads, std::size_t bytes);

/// Bytes of an array so large that three of them are well beyond the last cache, as far as the free memory
/// allows.
std::size_t triad_size();

}  // namespace furnas
