#pragma once

#include <string>

#include "cases/program/memory_limit.h"
#include "io/case.h"

namespace furnas {

/// What can be said of a case before it runs.
struct Preflight {
  std::string report;   ///< lines for a person
  std::string refusal;  ///< why it must not run; empty if it may
};

/// Works out sizes, time scales, memory and expected time of a case without building its packing.
Preflight check_case(const Case& c, const MemoryLimit& limit = memory_limit());

/// Particle-steps a second that one core makes, about (docs/results/performance.md: 16e6 of equal spheres).
inline constexpr double pace_of_a_core = 1.5e7;

/// What one d_s is in the unit of the case's list of diameters, in a sentence.
std::string unit_of_list(const Case& c);

/// Memory of a run of so many particles at its peak, once they touch, in bytes.
double expected_memory(double particles, const Case& c);

}  // namespace furnas
