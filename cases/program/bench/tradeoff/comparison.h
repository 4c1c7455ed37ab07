#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"
#include "cases/program/table.h"
#include "engine/statistics/statistics.h"
#include "io/tradeoff_file.h"

namespace furnas {

/// Classifies the difference d +- h (95 %) between an arm and the reference, for a margin M of equivalence.
enum class Standing {
  reference,   ///< the arm is the reference itself
  equivalent,  ///< the interval lies within +-M
  different,   ///< the interval excludes 0 and is not within +-M
  undecided,   ///< neither; more samples are needed
  failed,      ///< samples of the arm have ended, and none of them, or none of the reference, has a density
  unfinished   ///< no sample has ended
};

/// The word for it in tables.
const char* to_string(Standing standing);

/// The standing of a difference for a margin.
Standing standing_of(const MeanInterval& difference, double margin);

/// Number of samples of each of two arms that decides, if the difference stays d and the standard deviations
/// of the samples are a and b: n = 4 (a^2 + b^2)/h^2 with h = max(M - abs(d), abs(d)). With n samples the
/// interval d +- 2 ((a^2 + b^2)/n)^(1/2) just lies within +-M, or just excludes 0.
std::size_t samples_to_decide(double deviation_a, double deviation_b, double difference, double margin);

/// One arm on one case.
struct ComparedArm : VerdictCounts {
  std::string arm;
  std::vector<std::string> set;  ///< the keys that it changes, as assignments of --set
  Standing standing = Standing::failed;
  std::optional<Spread> wall_seconds, core_seconds;  ///< of the samples that have ended
  double steps{}, evaluations{};                     ///< medians over these samples; NaN without one
  std::optional<MeanInterval> phi;                   ///< of the jammed and settled samples
  std::optional<MeanInterval> difference;            ///< phi - phi of the reference
  std::optional<std::size_t> to_decide;  ///< samples of each arm that would decide; only of an undecided arm

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

/// The name of an arm for the extrapolation to p_a = 0: a straight line through the arms that change the
/// pressure alone.
inline constexpr const char* extrapolated_arm = "pressure_to_0";

/// Compares the arms of each case by their samples, whose values are the names of case and arm. Where two or
/// more arms change the pressure alone, their extrapolation to p_a = 0 is added as an arm of its own. Its
/// seconds are the sum over these arms.
std::vector<ComparedCase> compare(const TradeoffFile& tradeoff, const SampleTable& samples);

/// A row for each arm of each case, all digits; `version` is that of furnas.
Table comparison_csv(const std::vector<ComparedCase>& cases, const std::string& version);

/// The same as a table to read, with differences in units of 1e-4.
Table comparison_table(const std::vector<ComparedCase>& cases);

}  // namespace furnas
