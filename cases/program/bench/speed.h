#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/bench/force_error.h"
#include "cases/program/bench/packings.h"
#include "cases/program/table.h"

namespace furnas {

/// A setting with which each packing is measured.
struct Variant {
  std::string precision;  ///< compute.precision
  int threads{};
};

/// The measurement to do on each packing.
struct SpeedOrder {
  std::string law = "hooke_synchronized";
  double friction = 0.3;
  std::vector<Variant> variants;  ///< each repeat runs all of them in turn
  int repeats = 5;
  double seconds = 1;      ///< wall time of a repeat of the first variant; used when `steps` is 0
  std::int64_t steps = 0;  ///< of a repeat
};

/// The speed of one variant on one packing, and its error.
struct SpeedRow {
  std::string packing;
  std::size_t particles{};
  double friction{};
  Variant variant;
  std::int64_t steps{};                                ///< of a repeat
  Spread rate;                                         ///< million particle-steps a second
  double pairs{};                                      ///< candidate pairs per particle
  double inner{};                                      ///< pairs of the inner list, which most steps check
  double contacts{};                                   ///< contacts per particle
  std::int64_t rebuilds{};                             ///< neighbour lists built in a repeat
  double memory{};                                     ///< growth of the process, in bytes per particle
  double moved{};                                      ///< bytes that a particle-step moves, estimated
  ForceError error;                                    ///< of the forces at the start
  std::uint64_t hash{};                                ///< of the state after a repeat
  std::vector<std::pair<std::string, double>> shares;  ///< of the time of a step, phase by phase
};

/// Runs each variant `repeats` times from the same packing, all variants in turn, with complete steps: bath,
/// list and histories. Then runs each once more with a clock at each phase. Every repeat of a precision must
/// end in the same state for any number of threads; otherwise throws std::runtime_error.
std::vector<SpeedRow> measure_speed(const std::string& name, const Packing& packing, const SpeedOrder& order);

/// The rows as a table to read. `bandwidth` [bytes/s], measured with each variant's threads, gives the upper
/// bound that is printed beside the rate.
Table speed_table(const std::vector<SpeedRow>& rows, const std::vector<double>& bandwidth);

/// The same with all digits and the shares of the phases.
Table speed_csv(const std::vector<SpeedRow>& rows, const std::vector<double>& bandwidth);

/// Shares of the phases, one line for each row.
std::string phase_lines(const std::vector<SpeedRow>& rows);

}  // namespace furnas
