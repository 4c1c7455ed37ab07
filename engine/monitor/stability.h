#pragma once

#include <optional>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// t_c, half a period of the damped oscillation of a pair along its normal: pi (k_n/m_eff -
/// gamma_n^2/4)^(-1/2); empty if the pair is overdamped [time].
std::optional<double> collision_time(const AnyLaw& law, const Touch<double>& pair);

/// Restitution of a head-on collision of a pair with linear springs, exp(-gamma_n t_c/2); 0 if it is
/// overdamped.
double restitution(const AnyLaw& law, const Touch<double>& pair);

/// Largest frequency of the undamped springs of a lone pair [1/time].
double pair_frequency(const AnyLaw& law, const Touch<double>& pair);

/// The time step up to which velocity Verlet is stable for a pair, or for a sphere in sticking contact with
/// several equal spheres, dashpots included [time]. The fastest mode of x'' = -K x - C x' changes its sign in
/// each step. It grows beyond K dt^2 + 4 C dt = 4 if the dashpots use velocities predicted for the end of the
/// step, and beyond K dt^2 + 2 C dt = 4 if they use those of its middle (docs/theory/integrator.md). K and C
/// are row sums (Gershgorin), upper bounds except for a pair: each contact adds 2 k_n/m and 2 gamma_n m_eff/m
/// along the normals, and with friction, with rotations in units of 0.4 R, 7 k_t/m and 7 gamma_t m_eff/m
/// across them.
double largest_stable_step(const AnyLaw& law, const Touch<double>& pair, int contacts = 1);

/// The same as if the dashpots of any law used the velocities of the middle of the step. The automatic time
/// step is that of eight contacts (docs/developer/decisions/length-of-a-step.md).
double largest_stable_step_of_midway(const AnyLaw& law, const Touch<double>& pair, int contacts);

/// Upper bound of the largest frequency of a packing's springs, times the time step. Explicit integration of
/// undamped springs is stable below 2. The row sum of M^-1 K bounds its eigenvalues (Gershgorin): with
/// rotations in units of 0.4 R a contact adds max(2 k_n, 7 k_t)/m, exact for two equal spheres that stick.
double stiffest_step(const Packing& packing, const Model& model);

}  // namespace furnas
