#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/laws/any_law.h"
#include "engine/state/cell.h"
#include "engine/state/inner_list.h"
#include "engine/state/ledger.h"
#include "engine/state/pair_list.h"
#include "engine/state/records.h"

namespace furnas {

/// Number of particles in one call of Kernels::contacts. The loop is divided into pieces of particles, not of
/// rows, so that the order of the sums does not depend on the skin.
inline constexpr std::size_t contact_piece = 128;

/// What the loop over contacts reads and writes: plain pointers into State.
template <class S>
struct ContactLoop {
  using Real = typename S::Real;

  const typename S::Law* law;
  Triangle edges;    ///< of the cell [d_s]
  Triangle rate;     ///< of the cell [1/time]
  double time_step;  ///< [time]
  bool affine;       ///< relative velocities in contacts include the cell's flow
  const Particle<Real, S::spins>* particles;
  const Load<Real, S::spins>* loads;
  const RowNumber* first;        ///< as in PairList
  const std::uint32_t* partner;  ///< as in PairList
  const Quarter* quarter;        ///< as in PairList; null if all rows mean the nearest image
  std::uint64_t rows_end;        ///< number of rows
  Row<Real, S::spins>* rows;
  Spring<Real>* springs;
  std::uint8_t* touching;
  ContactCount* contacts;
  std::uint8_t* loaded;        ///< as in ContactState
  bool all;                    ///< go through all rows instead of the inner list
  Skin inner_skin;             ///< as in InnerList
  InnerPair* inner;            ///< as in InnerList; null if there is no inner list
  std::uint32_t* inner_count;  ///< as in InnerList
};

/// Sums over the contacts of one piece.
struct ContactSum {
  /// Sum of branch (x) force; x, y and z are the sums of the force times one component of the branch [k_n
  /// d_s^2].
  Vec3<double> x, y, z;
  ContactWork work;

  void operator+=(const ContactSum& b) { x += b.x, y += b.y, z += b.z, work += b.work; }
};

/// Half a step of the cell's drag on velocities: v -> factor (shear (factor v)), where shear maps v to
/// (v_x - xy v_y - xz v_z, v_y - yz v_z, v_z).
struct CellDragStep {
  Vec3<double> factor;
  double yz, xz, xy;
};

/// What half a kick and the drift read and write.
template <class S>
struct DriftLoop {
  using Real = typename S::Real;

  double time_step;  ///< [time]
  CellDragStep drag;
  Triangle to_fraction;        ///< inverse of the cell's edges [1/d_s]
  Triangle list_edges;         ///< of the cell when the list was built [d_s]
  const std::uint8_t* loaded;  ///< as in ContactState
  const Load<Real, S::spins>* loads;
  Particle<Real, S::spins>* particles;
};

/// What the sum over contacts and half a kick read and write.
template <class S>
struct GatherLoop {
  using Real = typename S::Real;

  double time_step;  ///< [time]
  CellDragStep drag;
  const RowNumber* first;           ///< as in PairList
  const RowNumber* incoming_first;  ///< as in PairList
  const RowNumber* incoming;        ///< as in PairList
  std::uint64_t rows_end;           ///< number of rows
  const Row<Real, S::spins>* rows;
  const ContactCount* contacts;
  std::uint8_t* loaded;  ///< as in ContactState
  Load<Real, S::spins>* loads;
  Particle<Real, S::spins>* particles;
};

/// The loops that take nearly all of the time of a step, compiled for one instruction set. Each loop runs
/// over particles [begin, end).
template <class S>
struct Kernels {
  ContactSum (*contacts)(const ContactLoop<S>&, std::size_t begin, std::size_t end);
  double (*drift)(const DriftLoop<S>&, std::size_t begin,
                  std::size_t end);  ///< square of the largest displacement [d_s^2]
  /// Returns the sum of m v (x) v [k_n d_s^2].
  Triangle (*gather)(const GatherLoop<S>&, std::size_t begin, std::size_t end);
};

/// The instruction sets for which kernels are compiled, in order of rising width.
enum class InstructionSet { scalar, avx2, avx512 };

/// Its name: "scalar", "AVX2", "AVX-512".
const char* to_string(InstructionSet set);

/// The instruction set set by choose() or by the environment variable FURNAS_SIMD; otherwise the best one
/// that this processor supports. The bits of a result do not depend on the instruction set. Throws InputError
/// if the variable names no instruction set.
InstructionSet instruction_set();

/// Uses this instruction set from now on, or the best supported one if the processor does not support it.
void choose(InstructionSet set);

/// The kernels of instruction_set().
template <class S>
const Kernels<S>& kernels();

}  // namespace furnas
