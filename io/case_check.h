#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "io/case.h"

namespace furnas {

/// Why keys that are allowed one by one do not go together.
struct Conflict {
  std::string key;      ///< "table.name" of the key to change first
  std::string message;  ///< names the keys, their values and what is allowed
};

/// N_s = N_l alpha^3 f_s/(1 - f_s), rounded; as a real number, so that it cannot overflow.
double small_spheres(const Case::Mixture& mixture);

/// t_c of two small spheres, pi (2 k_n/m_s - gamma_n^2/4)^(-1/2); empty if their contact is overdamped [time]
std::optional<double> collision_time(const Case::Contact& contact);

/// The time step of the case [time]; empty if it is asked for in t_c and there is none.
std::optional<double> time_step(const Case& c);

/// The time step beyond which a lone pair of the smallest spheres is unstable [time].
double largest_stable_time_step(const Case& c);

/// The first conflict between keys, if any.
std::optional<Conflict> find_conflict(const Case& c);

/// Throws InputError if a value is out of its range or keys are in conflict.
void validate(const Case& c);

}  // namespace furnas
