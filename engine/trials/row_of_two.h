#pragma once

#include "engine/trials/balls.h"

namespace furnas {

/// Two equal spheres in a row in a cell so short that they touch on both sides, the second time through the
/// face: a contact that endures. `shift` is how much further than half the cell they are apart [d_s].
struct RowOfTwo {
  static constexpr double radius = 0.5;                         ///< [d_s]
  static constexpr double squeeze = 0.02;                       ///< overlap of both contacts [d_s]
  static constexpr double length = 2 * (2 * radius - squeeze);  ///< of the cell along x [d_s]

  static double reduced_mass() { return reduced_mass_of(radius, radius); }

  /// At rest but for the spin of the first.
  static Packing start(double shift, const Vec3<double>& spin);

  /// Distance beyond half the cell, from the integers so that nothing is lost [d_s].
  static double shift_of(const Packing& packing);

  /// u = u_0 e^(-gamma t) (cos Wt + (gamma/W) sin Wt), W^2 = 2k/m_eff - gamma^2, for u_0 = 1.
  static double shift_at(double time, double damping);
};

/// Rate of decay and angular frequency [1/time] of an oscillation that is followed step by step: those of the
/// recurrence x_{n+1} = a x_n + b x_{n-1} that fits it best.
struct Oscillation {
  double decay{}, frequency{};
};

/// Of at least four places, `time_step` apart; throws ContractError when they do not oscillate.
Oscillation oscillation_of(const std::vector<double>& places, double time_step);

/// The oscillation of the row with a law and time step over so many steps.
Oscillation oscillation_of_row(const Model& model, int steps);

}  // namespace furnas
