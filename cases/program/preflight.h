#pragma once

#include <string>

#include "cases/program/memory_limit.h"
#include "io/case.h"

namespace furnas {

/// Estimates and checks of a case before it runs.
struct Preflight {
  std::string report;   ///< lines for the user
  std::string refusal;  ///< why the case must not run; empty if it may
  std::string remark;   ///< a remark that a run prints first, also part of the report; may be empty
};

/// Computes sizes, time scales, memory and expected time of a case without running it. Reads a start.file or
/// a list of diameters.
Preflight check_case(const Case& c, const MemoryLimit& limit = memory_limit());

/// Approximate number of particle-steps per second on one core (docs/results/performance.md: 16e6 for equal
/// spheres).
inline constexpr double pace_of_a_core = 1.5e7;

/// Peak memory of a run with this number of particles, in bytes, reached when the particles are in contact.
double expected_memory(double particles, const Case& c);

}  // namespace furnas
