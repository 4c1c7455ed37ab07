#pragma once

#include "engine/trials/balls.h"

namespace furnas {

/// Two equal spheres in a row, in a cell so short that they touch on both sides, the second time through the
/// face. The contacts are lasting. `shift` is the distance of the centres minus half the cell [d_s].
struct RowOfTwo {
  static constexpr double radius = 0.5;                         ///< [d_s]
  static constexpr double squeeze = 0.02;                       ///< overlap of both contacts [d_s]
  static constexpr double length = 2 * (2 * radius - squeeze);  ///< of the cell along x [d_s]

  static double reduced_mass() { return reduced_mass_of(radius, radius); }

  /// At rest except for the spin of the first sphere.
  static Packing start(double shift, const Vec3<double>& spin);

  /// The present shift, computed from the integer fractions to avoid rounding [d_s].
  static double shift_of(const Packing& packing);

  /// The shift at a time: u = u_0 e^(-gamma t) (cos Wt + (gamma/W) sin Wt), W^2 = 2k/m_eff - gamma^2, for u_0
  /// = 1.
  static double shift_at(double time, double damping);
};

/// Rate of decay and angular frequency [1/time] of an oscillation that is recorded at each step. They follow
/// from the recurrence x_{n+1} = a x_n + b x_{n-1} that fits the record best.
struct Oscillation {
  double decay{}, frequency{};
};

/// From at least four positions, `time_step` apart; throws ContractError if they do not oscillate.
Oscillation oscillation_of(const std::vector<double>& places, double time_step);

/// The oscillation of the row with the law and time step of `model`, over `steps` steps.
Oscillation oscillation_of_row(const Model& model, int steps);

}  // namespace furnas
