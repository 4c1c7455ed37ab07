#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/events/at_rest.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How a gas of spheres is compressed until it jams: all numbers of a run but its spheres. The defaults are
/// those of a case file; docs/reference/case-file.md tells the range of each.
struct Protocol {
  /// Name of the contact law. With a friction of 0 it stands for the law without spin and history.
  std::string law = HookeSynchronized::name;
  HookeConstants contact{.friction = 0.3};
  bool affine_velocity = true;  ///< contacts feel the cell's flow, too

  std::vector<double> pressures{1e-4};        ///< p_a, one after the other [k_n/d_s]
  CellFreedom cell = CellFreedom::triclinic;  ///< which deformations the cell may make
  double inertia = 1;                         ///< beta, W in units of M L_ref^2/12
  std::optional<double> inertia_absolute{};   ///< W itself, instead of `inertia` [rho d_s^5]
  double cell_damping = 4;                    ///< c, drag of the cell in units of its own rate; 2 is critical
  std::optional<double> drag{};               ///< g, the drag itself, instead of `cell_damping` [1/time]
  std::optional<double> time_step{};          ///< [t_c]; chosen by the program if absent
  std::optional<double> time_step_absolute{};  ///< instead of `time_step` [time]

  RestCriteria rest{};              ///< when the packing counts as jammed
  bool minimizer = true;            ///< without friction, balances the forces once the packing has its basin
  std::int64_t steps = 10'000'000;  ///< the cap on the steps of the run

  Precision precision = Precision::mixed;
  std::optional<double> skin{};  ///< of the neighbour list; chosen by the program if absent [d_s]
};

/// The contact law with its constants. Throws InputError for a name that is no law's.
AnyLaw law_of(const Protocol& protocol);

/// z_min: live contacts below which a particle is no part of the backbone. 4 without friction (d + 1); 2
/// with, because a bridge of two contacts carries force.
int backbone_threshold(const AnyLaw& law);

/// Two spheres of this diameter [d_s] that just touch.
Touch<double> equal_pair(double diameter);

/// t_c, in which a protocol counts its times: the collision time of two spheres of size d_s; of the undamped
/// pair if it is overdamped [time].
double time_unit_of(const Protocol& protocol);

/// The time step [time]. Chosen by the program, it follows from two of the smallest spheres, of this diameter
/// [d_s]: 0.1 of their collision time (0.08 with friction), at most a third of their largest stable step, and
/// at most the step that is stable for a sphere that sticks to eight others of its size
/// (docs/developer/decisions/length-of-a-step.md).
double time_step_of(const Protocol& protocol, double smallest = 1);

/// The same in units of t_c.
double relative_time_step(const Protocol& protocol, double smallest = 1);

/// Diameter of the smallest sphere [d_s].
double smallest_diameter(const Packing& packing);

/// The same as a simulation of this start keeps it.
double smallest_kept_diameter(const Protocol& protocol, const Packing& start);

/// Edge of the cube that spheres of this volume fill to 0.64 [d_s].
double dense_width(double sphere_volume);

/// Least distance between opposite faces of the dense cell, about [d_s]: cells are no cubes, and end 3 to 8 %
/// flatter (docs/guide/how-sure.md).
double dense_thickness(double sphere_volume);

/// W = beta M L_ref^2/12 with L_ref^3 = V_s/0.64: the inertia of a cube of the packing itself, M and V_s
/// being mass and volume of all spheres [rho d_s^5].
double cell_inertia(double beta, double mass, double sphere_volume);

/// The bath at each pressure of the protocol, for a packing of such spheres. The drag is c (p_a V/W)^(1/2), V
/// the volume of a cell that the spheres fill to 0.64.
std::vector<Barostat> baths_of(const Protocol& protocol, const Packing& start);

/// What is simulated when `start` is compressed: the law and its constants, the bath at the first pressure,
/// the time step.
Model model_of(const Protocol& protocol, const Packing& start);

}  // namespace furnas
