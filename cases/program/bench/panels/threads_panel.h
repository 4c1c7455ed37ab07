#pragma once

#include <cstdint>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// The speed of a number of threads on one packing.
struct ThreadsRow {
  int threads{};
  std::size_t particles{};
  Spread rate;           ///< million particle-steps a second
  Spread speed_up;       ///< rate over the median rate of one thread
  std::uint64_t hash{};  ///< of the state at the end: the same for all
};

/// Rows of the panel `threads`. Throws std::runtime_error if the final states differ.
std::vector<ThreadsRow> thread_rows(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<ThreadsRow>& rows);

}  // namespace furnas
