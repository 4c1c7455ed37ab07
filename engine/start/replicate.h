#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// How often a cell is repeated along each of its edges, 1 or more.
using Times = std::array<std::int32_t, 3>;

inline std::size_t copies_of(const Times& times) {
  return static_cast<std::size_t>(times[0]) * static_cast<std::size_t>(times[1]) *
         static_cast<std::size_t>(times[2]);
}

/// A list that is worked out element by element when it is asked for.
template <class T>
class Computed {
 public:
  using value_type = T;

  Computed(std::size_t count, std::function<T(std::size_t)> element)
      : count_(count), element_(std::move(element)) {}
  std::size_t size() const { return count_; }
  T operator[](std::size_t k) const { return element_(k); }

 private:
  std::size_t count_;
  std::function<T(std::size_t)> element_;
};

/// The same infinite packing described by a larger cell: times[a] cells along edge a make the new one. It has
/// the parts of a Packing but no memory for them, so that it may be larger than the machine; the packing that
/// it repeats must outlive it.
///
/// Particle k of copy c has the index c N + k, copies counted along the first edge first; so have contacts.
/// Fractions are divided as the integers they are, so a place moves by at most 2^-64 of the new edge:
/// contacts stay, forces agree to rounding, and each contact keeps its force and history. Sums (stress times
/// volume, ledger) grow with the volume.
class Replica {
 public:
  /// Throws InputError for times below 1 and for more particles than 32 bits can count.
  Replica(const Packing& from, const Times& times);
  Replica(const Replica&) = delete;
  Replica& operator=(const Replica&) = delete;

  std::size_t size() const { return radius.size(); }
  Vec3<double> position(std::size_t k) const { return cell.edges * in_unit_cell(fraction[k]); }

  /// The order that the engine chooses; it takes 60 bytes a particle. Empty if the packing has none, as a
  /// start.
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

/// The same as a packing. One with an `order` goes on with its contacts in the order that the engine chooses
/// for the new one; one without stays a start.
Packing replicate(const Packing& packing, const Times& times);

}  // namespace furnas
