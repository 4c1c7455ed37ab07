#pragma once

#include <cmath>
#include <string>

#include "cases/program/sweep/sample_table.h"

namespace furnas {

/// A table as of a sweep over the keys of the paper, without rows.
inline SampleTable paper_table() {
  return {{"mixture.size_ratio", "mixture.small_fraction", "contact.friction"}, {}};
}

/// A row as of a sample that has jammed.
inline SampleRow jammed_row(const std::string& size_ratio, const std::string& small_fraction,
                            const std::string& friction, std::int64_t seed, double phi_J) {
  SampleRow row;
  row.values = {size_ratio, small_fraction, friction};
  row.size_ratio = std::stod(size_ratio);
  row.small_fraction = std::stod(small_fraction);
  row.friction = std::stod(friction);
  row.seed = seed;
  row.large = 100;
  row.small = row.small_fraction > 0 ? 1000 : 0;
  row.verdict = "jammed";
  row.reason = "at rest";
  row.phi_J = row.phi = phi_J;
  row.Z = 4;
  row.Z_backbone = 5;
  row.backbone = 90;
  row.large_rattlers = {1, 2, 3};
  row.small_rattlers = {100, 200, 300};
  row.steps = 1000;
  row.wall_seconds = 1.5;
  row.state_hash = "00ff";
  return row;
}

/// The same, of one that has spent its steps.
inline SampleRow spent_row(const std::string& size_ratio, const std::string& small_fraction,
                           const std::string& friction, std::int64_t seed) {
  SampleRow row = jammed_row(size_ratio, small_fraction, friction, seed, 0.5);
  row.verdict = "budget";
  row.reason = "all steps are spent, it waits";
  row.phi_J = std::nan("");
  return row;
}

}  // namespace furnas
