#pragma once

#include <optional>

#include "engine/laws/any_law.h"
#include "engine/state/cell.h"

namespace furnas {

/// The pressure bath: how the cell answers to the stress (engine/phases/barostat.h).
struct Barostat {
  CellFreedom freedom = CellFreedom::triclinic;
  double pressure = 1e-4;  ///< p_a [k_n/d_s]
  double inertia = 1;      ///< W [rho d_s^5]
  double drag = 0;         ///< g [1/time]; the rate decays as exp(-g t)
  /// Move the cell step for step as `fix nph/sphere` of LAMMPS does: its shear is driven by branch_a
  /// force_b, a < b, not by the transpose, which does work on an upper-triangular cell (they differ
  /// while torques act), and its tilts are stretched with the lengths of the step's start.
  bool legacy = false;
};

/// Arithmetic of the forces and of what particles carry. Positions, differences, overlaps and the sums of
/// stress and energy are double in both.
enum class Precision { mixed, full };

/// The radius [d_s] that a simulation of this precision computes with, writes into its packings and starts
/// from again: in mixed precision the nearest single-precision number.
inline double kept_radius(Precision precision, double radius) {
  return precision == Precision::mixed ? static_cast<float>(radius) : radius;
}

/// What is simulated: everything that stays the same during a run.
struct Model {
  AnyLaw law;
  Precision precision = Precision::full;
  Barostat barostat;
  double time_step = 0.032415;   ///< [time]
  bool affine_velocity = false;  ///< contacts see the cell's flow too, not the peculiar velocities alone
  std::optional<double> skin;    ///< fixed skin [d_s]; chosen by the program if absent
};

}  // namespace furnas
