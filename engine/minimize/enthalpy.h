#pragma once

#include <cstdint>
#include <vector>

#include "engine/minimize/shift.h"
#include "engine/model.h"
#include "engine/state/packing.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// H = U + p_a V of a packing without friction: U the energy of its contacts, V the volume of its cell. At a
/// minimum of H all forces balance and the stress is that of the bath. The variables of H are the positions
/// and the strains that the cell is free to make; velocities do not enter.
///
/// The object has a place: the reference configuration, from which shifts are measured. Its neighbour list is
/// complete for configurations near the place. Loops run on the threads of Workers::run(), and sums are
/// ordered, so the bits are the same for any number of threads.
class Enthalpy {
 public:
  /// The place is the configuration of `packing`. Throws InputError for a law with friction.
  Enthalpy(const Packing& packing, const AnyLaw& law, const Barostat& bath);

  std::size_t particles() const { return radius_.size(); }

  /// Values at a shift from the place.
  struct Point {
    double value{};          ///< H [k_n d_s^2]
    Shift gradient;          ///< dH/du, minus the net forces [k_n d_s], and dH/de [k_n d_s^2]
    std::size_t contacts{};  ///< pairs that overlap
    double mean_force{};     ///< of the contacts [k_n d_s]

    explicit Point(std::size_t particles = 0) : gradient(particles) {}
  };

  /// Whether the neighbour list is complete at a shift, so that no contact can be missing.
  bool covers(const Shift& shift) const;

  /// Computes the values at a shift for which covers() is true. Costs about as much as the forces of a step.
  void look(const Shift& shift, Point& point);

  /// The inverse of the diagonal second derivatives, without the prestress of the contacts; the same value
  /// for the three components of a particle.
  Shift softness() const;

  /// Makes the shifted configuration the new place, and rebuilds the neighbour list.
  void move(const Shift& shift);

  /// Mean |net force| of all particles on which it is not 0, divided by the mean |F| of the contacts.
  double force_imbalance(const Point& point) const;

  /// Largest |deviation of a stress component from the bath's|/p_a, among the components that can strain the
  /// cell.
  double stress_error(const Point& point) const;

  /// Writes the place into the packing from which the object was made: positions, cell, contacts with their
  /// forces, the sums of these forces, and the stress. All velocities and the cell's rate are set to 0. In
  /// the ledger only the forces of the last step change.
  void put_into(Packing& packing) const;

 private:
  void renew_list();

  AnyLaw law_;
  Barostat bath_;
  std::vector<std::uint32_t> id_;  ///< index in the packing of the n-th particle in memory
  std::vector<double> radius_;     ///< [d_s]
  std::vector<double> mass_;       ///< [rho d_s^3]
  std::vector<Fraction> fraction_;
  std::vector<Image> image_;
  Triangle edges_;  ///< [d_s]

  PairList list_;
  std::vector<Vec3<double>> branch_;  ///< of each row, at the place [d_s]
  std::vector<Vec3<double>> force_;   ///< of each row at the last look(); zero if it does not touch [k_n d_s]
};

}  // namespace furnas
