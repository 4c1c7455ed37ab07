#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/events/at_rest.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How a gas of spheres is compressed until it jams: all parameters of a run except its spheres. The defaults
/// are those of a case file; docs/reference/case-file.md gives the range of each.
struct Protocol {
  /// Name of the contact law. With a friction of 0 the corresponding law without spin and history is used.
  std::string law = HookeSynchronized::name;
  HookeConstants contact{.friction = 0.3};
  bool affine_velocity = true;  ///< relative velocities in contacts include the cell's flow

  std::vector<double> pressures{1e-4};        ///< p_a, one after the other [k_n/d_s]
  CellFreedom cell = CellFreedom::triclinic;  ///< which deformations the cell may make
  double inertia = 1;                         ///< beta, W in units of M L_ref^2/12
  std::optional<double> inertia_absolute{};   ///< W itself, instead of `inertia` [rho d_s^5]
  double cell_damping = 4;            ///< c, drag of the cell in units of (p_a V/W)^(1/2); 2 is critical
  std::optional<double> drag{};       ///< g, the drag itself, instead of `cell_damping` [1/time]
  std::optional<double> time_step{};  ///< [t_c]; chosen by the program if absent
  std::optional<double> time_step_absolute{};  ///< instead of `time_step` [time]

  RestCriteria rest{};    ///< when the packing counts as jammed
  bool minimizer = true;  ///< without friction, minimizes the enthalpy once the packing has found its basin
  std::int64_t steps = 10'000'000;  ///< the cap on the steps of the run

  Precision precision = Precision::mixed;
  std::optional<double> skin{};  ///< of the neighbour list; chosen by the program if absent [d_s]
};

/// Throws InputError with name and value of a number that cannot be used. The ranges are wider than those of
/// a case file: this refuses only what has no meaning, as a pressure of 0.
void validate(const Protocol& protocol);

/// The contact law with its constants. Throws InputError if no law has this name.
AnyLaw law_of(const Protocol& protocol);

/// z_min: live contacts below which a particle is no part of the backbone. 4 without friction (d + 1); 2
/// with, because a bridge of two contacts carries force.
int backbone_threshold(const AnyLaw& law);

/// Two spheres of this diameter [d_s] that just touch.
Touch<double> equal_pair(double diameter);

/// t_c, the unit of the times in a protocol: the collision time of two spheres of diameter d_s; of the
/// undamped pair if the pair is overdamped [time].
double time_unit_of(const Protocol& protocol);

/// A time step, and what sets it.
struct TimeStep {
  double length = 0;      ///< [time]
  std::string_view rule;  ///< a key of the case file, or one of the rules of an automatic step
};

/// The time step of a protocol. If the program chooses it, the step follows from a pair of the smallest
/// spheres, of diameter `smallest` [d_s]. It is 0.1 of their collision time (0.08 with friction), but at most
/// that of the rule for a sphere in (sticking) contact with eight others of its size
/// (docs/developer/decisions/length-of-a-step.md).
TimeStep chosen_time_step(const Protocol& protocol, double smallest = 1);

/// The length of that step [time].
double time_step_of(const Protocol& protocol, double smallest = 1);

/// The same in units of t_c.
double relative_time_step(const Protocol& protocol, double smallest = 1);

/// Diameter of the smallest sphere [d_s].
double smallest_diameter(const Packing& packing);

/// The same, rounded as a simulation of this start rounds its radii [d_s].
double smallest_kept_diameter(const Protocol& protocol, const Packing& start);

/// Edge of the cube that spheres of this volume fill to 0.64 [d_s].
double dense_width(double sphere_volume);

/// Estimate of the least distance between opposite faces of the dense cell [d_s]. Final cells are no cubes;
/// this distance is 3 to 8 % smaller than the edge of the cube (docs/guide/how-sure.md).
double dense_thickness(double sphere_volume);

/// W = beta M L_ref^2/12 with L_ref^3 = V_s/0.64, where M and V_s are mass and volume of all spheres [rho
/// d_s^5]. For beta = 1 it is the inertia of a cube of the packing itself.
double cell_inertia(double beta, double mass, double sphere_volume);

/// The bath at each pressure of the protocol, for the spheres of `start`. The drag is c (p_a V/W)^(1/2),
/// where V is the volume of a cell that the spheres fill to 0.64. Throws InputError if the protocol is not
/// valid.
std::vector<Barostat> baths_of(const Protocol& protocol, const Packing& start);

/// What is simulated when `start` is compressed: the law and its constants, the bath at the first pressure,
/// the time step. Throws InputError if the protocol is not valid.
Model model_of(const Protocol& protocol, const Packing& start);

}  // namespace furnas
