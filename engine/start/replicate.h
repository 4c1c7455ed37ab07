#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Number of repetitions of a cell along each of its edges, 1 or more.
using Times = std::array<std::int32_t, 3>;

/// Number of copies of the cell in all.
inline std::size_t copies_of(const Times& times) {
  return static_cast<std::size_t>(times[0]) * static_cast<std::size_t>(times[1]) *
         static_cast<std::size_t>(times[2]);
}

/// A list whose elements are computed when they are read.
template <class T>
class Computed {
 public:
  using value_type = T;  // NOLINT(readability-identifier-naming): as the containers of C++ name it

  Computed(std::size_t count, std::function<T(std::size_t)> element)
      : count_(count), element_(std::move(element)) {}
  std::size_t size() const { return count_; }
  T operator[](std::size_t k) const { return element_(k); }

 private:
  std::size_t count_;
  std::function<T(std::size_t)> element_;
};

/// The same infinite packing described by a larger cell, which consists of times[a] old cells along edge a. A
/// replica has the members of a Packing. It stores none of them for each particle except the type numbers of
/// a file, so it may be larger than the memory of the machine. The original packing must outlive the replica.
///
/// Particle k of copy c has the index c N + k, where N is the number of particles and copies are counted
/// along the first edge first; contacts are numbered in the same way. Fractions are divided as integers, so a
/// position changes by at most 2^-64 of the new edge. Therefore contacts stay, recomputed forces agree to
/// rounding, and each contact keeps its force and history. Sums (stress times volume, ledger) grow with the
/// volume.
class Replica {
 public:
  /// Throws InputError if one of `times` is below 1, or for more than most_particles particles.
  Replica(const Packing& from, const Times& times);
  Replica(const Replica&) = delete;
  Replica& operator=(const Replica&) = delete;

  std::size_t size() const { return radius.size(); }
  Vec3<double> position(std::size_t k) const { return cell.edges * in_unit_cell(fraction[k]); }

  /// The order that the engine chooses; computing it takes 60 bytes per particle. Empty if the original
  /// packing has no order, as a start.
  std::vector<std::uint32_t> memory_order() const;

 private:
  Contact moved(std::size_t k) const;
  const Packing& from_;
  const Times times_;

  template <class T>
  Computed<T> repeated(const std::vector<T>& once) const;

 public:
  const std::int64_t step;
  const double time;
  const Cell cell;
  const Stress stress;
  const Ledger ledger;
  const Computed<Species> species;
  const Computed<double> radius, mass;
  const Computed<Fraction> fraction;
  const Computed<Image> image;
  const Computed<Vec3<double>> velocity, spin, force, torque;
  const Computed<Contact> contacts;
  const Labels labels;
};

/// The replica as a packing. If the original has an `order`, the new packing gets the order that the engine
/// chooses, and continues with its contacts. If it has none, the new packing is a start, too.
Packing replicate(const Packing& packing, const Times& times);

}  // namespace furnas
