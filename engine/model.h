#pragma once

#include <optional>

#include "engine/laws/any_law.h"
#include "engine/state/cell.h"

namespace furnas {

/// The pressure bath: how the cell responds to the stress (engine/phases/barostat.h).
struct Barostat {
  CellFreedom freedom = CellFreedom::triclinic;
  double pressure = 1e-4;  ///< p_a [k_n/d_s]
  double inertia = 1;      ///< W [rho d_s^5]
  double drag = 0;         ///< g [1/time]; the rate decays as exp(-g t)
  /// Move the cell step for step as `fix nph/sphere` of LAMMPS does: the shear of the cell is driven by the
  /// sum of branch_a force_b over the contacts, a < b. In an upper-triangular cell the transpose, branch_b
  /// force_a, does the work; both agree when all torques balance. The tilts are stretched with the edge
  /// lengths at the start of the step.
  bool legacy = false;
};

/// Number type of the forces and of the velocities, spins and radii of the particles. Positions, differences
/// and overlaps are double in both modes. Sums over up to 256 contacts or particles have the type of the
/// forces; these sums are added up in double.
enum class Precision { mixed, full };

/// The radius [d_s] that a simulation of this precision uses: in its forces, in the packings that it returns,
/// and when a run is resumed. In mixed precision it is the nearest single-precision number.
inline double kept_radius(Precision precision, double radius) {
  return precision == Precision::mixed ? static_cast<float>(radius) : radius;
}

/// The law and the parameters of a simulation. Only bath and time step can change during a run.
struct Model {
  AnyLaw law;
  Precision precision = Precision::full;
  Barostat barostat;
  double time_step = 0.032415;   ///< [time]
  bool affine_velocity = false;  ///< relative velocities in contacts include the cell's flow
  std::optional<double> skin;    ///< fixed skin [d_s]; chosen by the program if absent
};

}  // namespace furnas
