#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"
#include "cases/program/table.h"
#include "engine/statistics/statistics.h"
#include "io/tradeoff_file.h"

namespace furnas {

/// What the difference of an arm to the reference, d +- h (95 %), says within a margin M.
enum class Standing {
  reference,   ///< it is the reference itself
  equivalent,  ///< the interval lies within +-M
  different,   ///< the interval leaves out 0 and is not within +-M
  undecided,   ///< neither: more samples decide
  failed,      ///< samples of the arm have ended, and none of them, or none of the reference, has a density
  unfinished   ///< no sample has ended
};

const char* to_string(Standing standing);

/// The standing of a difference within a margin.
Standing standing_of(const MeanInterval& difference, double margin);

/// Samples of each of two arms, which scatter with the deviations a and b, that decide if the difference
/// stays d: n = 4 (a^2 + b^2)/h^2, h = max(M - abs(d), abs(d)), since then the interval d +- 2 ((a^2 +
/// b^2)/n)^(1/2) just lies within +-M, or just leaves out 0.
std::size_t samples_to_decide(double deviation_a, double deviation_b, double difference, double margin);

/// One arm on one case.
struct ComparedArm {
  std::string arm;
  std::vector<std::string> set;  ///< the keys that it changes, as assignments of --set
  Standing standing = Standing::failed;
  std::size_t samples{};  ///< planned
  std::size_t jammed{}, settled{}, budget{}, diverged{}, failed{}, unfinished{};
  std::optional<Spread> wall_seconds, core_seconds;  ///< of those that have ended
  double steps{}, evaluations{};                     ///< medians of the same; NaN without one
  std::optional<MeanInterval> phi;                   ///< of the jammed and settled ones
  std::optional<MeanInterval> difference;            ///< phi - phi of the reference
  std::optional<std::size_t> to_decide;              ///< samples of each arm; of an undecided one

  /// Samples that have ended without a density.
  std::size_t lost() const { return budget + diverged + failed; }
};

/// All arms on one case.
struct ComparedCase {
  std::string name, reference;
  std::vector<std::string> set;  ///< the keys of the case, as assignments of --set
  double margin{};
  std::vector<ComparedArm> arms;

  const ComparedArm* reference_arm() const;
};

/// The name of the arm that stands for the straight line through the arms of pressure alone, at p_a = 0.
inline constexpr const char* extrapolated_arm = "pressure_to_0";

/// Compares the arms of each case by their samples, whose values are the names of case and arm. Where two or
/// more arms change the pressure alone, their extrapolation follows as an arm of its own; its seconds are
/// those of all of them.
std::vector<ComparedCase> compare(const TradeoffFile& tradeoff, const SampleTable& samples);

/// A row for each arm of each case, all digits; `version` is that of furnas.
Table comparison_csv(const std::vector<ComparedCase>& cases, const std::string& version);

/// The same for a person, differences in units of 1e-4.
Table comparison_table(const std::vector<ComparedCase>& cases);

}  // namespace furnas
