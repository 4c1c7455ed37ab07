#pragma once

#include <cstdint>
#include <vector>

#include "engine/minimize/shift.h"
#include "engine/model.h"
#include "engine/state/packing.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// H = U + p_a V of a packing without friction: U the energy of its contacts, V the volume of its cell. H is
/// least where all forces balance and the stress is that of the bath. Its variables are the positions and
/// those strains of the cell that the bath lets happen; motion does not count.
///
/// The object has a place, from which shifts are measured, and a neighbour list that is right near it. Loops
/// run on the threads of Workers::run(), and sums are ordered: the same bits for any number of them.
class Enthalpy {
 public:
  /// Its place is where the packing stands. Throws InputError for a law with friction.
  Enthalpy(const Packing& packing, const AnyLaw& law, const Barostat& bath);

  std::size_t particles() const { return radius_.size(); }

  /// What is found at a shift from the place.
  struct Point {
    double value{};          ///< H [k_n d_s^2]
    Shift gradient;          ///< dH/du, minus the net forces [k_n d_s], and dH/de [k_n d_s^2]
    std::size_t contacts{};  ///< pairs that overlap
    double mean_force{};     ///< of the contacts [k_n d_s]

    explicit Point(std::size_t particles = 0) : gradient(particles) {}
  };

  /// Whether the neighbour list is right at a shift: no contact can be missing.
  bool covers(const Shift& shift) const;

  /// Looks at a covered shift. Costs about as much as the forces of a step.
  void look(const Shift& shift, Point& point);

  /// The inverse of the second derivative by each variable alone, without what the contacts' tension adds;
  /// the same for the three components of a particle.
  Shift softness() const;

  /// Makes a shift the new place, and the neighbour list anew.
  void move(const Shift& shift);

  /// Mean |net force| of the particles that touch any, over the mean |F| of the contacts.
  double force_imbalance(const Point& point) const;

  /// Largest deviation of a stress from the bath's, over p_a, among those that the cell can answer to.
  double stress_error(const Point& point) const;

  /// Puts the place into the packing it was made from: positions, cell, contacts with their forces, their
  /// sums and the stress; nothing moves then. The ledger is left alone, but for the forces of the last step.
  void put_into(Packing& packing) const;

 private:
  void renew_list();
  Triangle allowed(const Triangle& gradient) const;

  AnyLaw law_;
  Barostat bath_;
  std::vector<std::uint32_t> id_;  ///< index in the packing of each place in memory
  std::vector<double> radius_;     ///< [d_s]
  std::vector<double> mass_;       ///< [rho d_s^3]
  std::vector<Fraction> fraction_;
  std::vector<Image> image_;
  Triangle edges_;  ///< [d_s]

  PairList list_;
  std::vector<Vec3<double>> branch_;  ///< of each row, at the place [d_s]
  std::vector<Vec3<double>> force_;  ///< of each row at the last look; zero where it does not touch [k_n d_s]
};

}  // namespace furnas
