#pragma once

#include <string>

#include "cases/program/memory_limit.h"
#include "io/case.h"

namespace furnas {

/// What can be said of a case before it runs.
struct Preflight {
  std::string report;   ///< lines for a person
  std::string refusal;  ///< why it must not run; empty if it may
  std::string remark;   ///< what a run should say first; in the report, too; empty if there is nothing
};

/// Works out sizes, time scales, memory and expected time of a case without building its packing.
Preflight check_case(const Case& c, const MemoryLimit& limit = memory_limit());

/// Particle-steps a second that one core makes, about (docs/results/performance.md: 16e6 of equal spheres).
inline constexpr double pace_of_a_core = 1.5e7;

/// Memory of a run of so many particles at its peak, once they touch, in bytes.
double expected_memory(double particles, const Case& c);

}  // namespace furnas
