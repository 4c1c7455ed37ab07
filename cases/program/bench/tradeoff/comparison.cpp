#include "cases/program/bench/tradeoff/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace furnas {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The results of the samples of an arm, as lists.
struct ArmSamples {
  std::vector<double> phi, wall, core, steps, evaluations;
};

ComparedArm arm_of(const std::string& case_name, const std::string& arm_name, const SampleTable& table,
                   ArmSamples& lists) {
  ComparedArm arm;
  arm.arm = arm_name;
  for (const SampleRow& row : table.rows) {
    if (row.values[0] != case_name || row.values[1] != arm_name) continue;
    arm.count(row);
    if (std::isfinite(row.density())) lists.phi.push_back(row.density());
    if (row.verdict == "unfinished" || row.verdict == "failed") continue;
    lists.wall.push_back(row.wall_seconds);
    if (std::isfinite(row.cpu_seconds)) lists.core.push_back(row.cpu_seconds);
    lists.steps.push_back(static_cast<double>(row.steps));
    lists.evaluations.push_back(static_cast<double>(row.evaluations));
  }
  if (arm.unfinished == arm.samples) arm.standing = Standing::unfinished;
  if (!lists.wall.empty()) arm.wall_seconds = spread_of(lists.wall);
  if (!lists.core.empty()) arm.core_seconds = spread_of(lists.core);
  arm.steps = lists.steps.empty() ? unknown : spread_of(lists.steps).median;
  arm.evaluations = lists.evaluations.empty() ? unknown : spread_of(lists.evaluations).median;
  if (!lists.phi.empty()) arm.phi = mean_interval(lists.phi);
  return arm;
}

/// Sets the difference of an arm to the reference, its standing, and the samples needed to decide.
void judge(ComparedArm& arm, const MeanInterval& difference, const MeanInterval& of_reference,
           double margin) {
  arm.difference = difference;
  arm.standing = standing_of(difference, margin);
  if (arm.standing != Standing::undecided || !std::isfinite(difference.half_width)) return;
  // The present samples do not decide, because the interval of few samples is wider than in the formula. So
  // at least one more is needed.
  arm.to_decide =
      std::max(samples_to_decide(arm.phi->deviation, of_reference.deviation, difference.mean, margin),
               std::max(arm.phi->samples, of_reference.samples) + 1);
}

/// The straight line through the samples of the arms that change the pressure alone, at p_a = 0; empty for
/// fewer than two pressures.
std::optional<ComparedArm> extrapolation(const TradeoffCase& c, const std::vector<ComparedArm>& arms,
                                         const std::vector<ArmSamples>& lists) {
  std::vector<double> pressures, phi;
  ComparedArm zero;
  zero.arm = extrapolated_arm;
  Spread wall, core;
  std::size_t pressed = 0;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    if (!c.arms[k].pressure_alone || lists[k].phi.empty() || !arms[k].core_seconds) continue;
    ++pressed;
    pressures.insert(pressures.end(), lists[k].phi.size(), c.arms[k].c.compaction.pressure.front());
    phi.insert(phi.end(), lists[k].phi.begin(), lists[k].phi.end());
    const auto add = [](Spread& sum, const Spread& more) {
      sum = {sum.median + more.median, sum.low + more.low, sum.high + more.high};
    };
    add(wall, *arms[k].wall_seconds), add(core, *arms[k].core_seconds);
    zero.samples += arms[k].samples, zero.jammed += arms[k].jammed, zero.settled += arms[k].settled;
    zero.budget += arms[k].budget, zero.diverged += arms[k].diverged, zero.failed += arms[k].failed;
    zero.unfinished += arms[k].unfinished;
    zero.steps += arms[k].steps, zero.evaluations += arms[k].evaluations;
  }
  if (pressed < 2) return {};
  zero.wall_seconds = wall, zero.core_seconds = core;
  zero.phi = value_at_zero(pressures, phi);
  return zero;
}

void judge_all(ComparedCase& c, const std::vector<ArmSamples>& lists, const ArmSamples& reference) {
  const MeanInterval of_reference = mean_interval(reference.phi);
  for (std::size_t k = 0; k < c.arms.size(); ++k) {
    ComparedArm& arm = c.arms[k];
    if (arm.arm == c.reference) {
      arm.standing = Standing::reference;
    } else if (arm.phi && k < lists.size()) {
      judge(arm, difference_interval(lists[k].phi, reference.phi), of_reference, c.margin);
    } else if (arm.phi) {  // the extrapolation; its samples are not those of the reference
      MeanInterval d{arm.phi->samples + of_reference.samples, arm.phi->mean - of_reference.mean, 0, 0};
      d.half_width = std::hypot(arm.phi->half_width, of_reference.half_width);
      judge(arm, d, of_reference, c.margin);
      arm.to_decide.reset();  // the formula is for two arms
    }
  }
}

std::string text_of_standing(const ComparedArm& arm) {
  if (arm.to_decide) return fmt::format("undecided, {} samples would decide", *arm.to_decide);
  return to_string(arm.standing);
}

std::string real(double x) { return std::isfinite(x) ? fmt::format("{:.6g}", x) : ""; }
std::string fine(double x) { return std::isfinite(x) ? fmt::format("{:.8g}", x) : ""; }

void add_spread(std::vector<std::string>& cells, const std::optional<Spread>& spread) {
  for (const double Spread::*part : {&Spread::median, &Spread::low, &Spread::high})
    cells.push_back(spread ? real((*spread).*part) : "");
}

}  // namespace

const char* to_string(Standing standing) {
  switch (standing) {
    case Standing::reference:
      return "reference";
    case Standing::equivalent:
      return "equivalent";
    case Standing::different:
      return "different";
    case Standing::undecided:
      return "undecided";
    case Standing::failed:
      return "failed";
    case Standing::unfinished:
      return "unfinished";
  }
  return "";
}

Standing standing_of(const MeanInterval& d, double margin) {
  if (!std::isfinite(d.half_width)) return Standing::undecided;
  if (d.low() >= -margin && d.high() <= margin) return Standing::equivalent;
  return d.low() > 0 || d.high() < 0 ? Standing::different : Standing::undecided;
}

std::size_t samples_to_decide(double a, double b, double difference, double margin) {
  const double h = std::max(margin - std::abs(difference), std::abs(difference));
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(4 * (a * a + b * b) / (h * h))));
}

const ComparedArm* ComparedCase::reference_arm() const {
  const auto found =
      std::find_if(arms.begin(), arms.end(), [&](const ComparedArm& arm) { return arm.arm == reference; });
  return found == arms.end() ? nullptr : &*found;
}

std::vector<ComparedCase> compare(const TradeoffFile& tradeoff, const SampleTable& samples) {
  std::vector<ComparedCase> all;
  for (const TradeoffCase& c : tradeoff.cases) {
    ComparedCase compared{c.name, c.reference, c.set, c.margin, {}};
    std::vector<ArmSamples> lists(c.arms.size());
    std::size_t reference = 0;
    for (std::size_t k = 0; k < c.arms.size(); ++k) {
      compared.arms.push_back(arm_of(c.name, c.arms[k].name, samples, lists[k]));
      compared.arms.back().set = c.arms[k].set;
      if (c.arms[k].name == c.reference) reference = k;
    }
    if (auto zero = extrapolation(c, compared.arms, lists)) compared.arms.push_back(std::move(*zero));
    if (!lists[reference].phi.empty()) judge_all(compared, lists, lists[reference]);
    all.push_back(std::move(compared));
  }
  return all;
}

Table comparison_csv(const std::vector<ComparedCase>& cases, const std::string& version) {
  Table table({"case",
               "arm",
               "reference",
               "margin",
               "standing",
               "samples_to_decide",
               "n",
               "phi",
               "phi_half_width",
               "phi_deviation",
               "difference",
               "difference_half_width",
               "samples",
               "jammed",
               "settled",
               "budget",
               "diverged",
               "failed",
               "unfinished",
               "core_seconds",
               "core_seconds_low",
               "core_seconds_high",
               "wall_seconds",
               "wall_seconds_low",
               "wall_seconds_high",
               "steps",
               "evaluations",
               "case_settings",
               "arm_settings",
               "version"});
  for (const ComparedCase& c : cases)
    for (const ComparedArm& arm : c.arms) {
      std::vector<std::string> cells{c.name,
                                     arm.arm,
                                     c.reference,
                                     real(c.margin),
                                     to_string(arm.standing),
                                     arm.to_decide ? std::to_string(*arm.to_decide) : "",
                                     std::to_string(arm.phi ? arm.phi->samples : 0)};
      const MeanInterval none{0, unknown, unknown, unknown};
      const MeanInterval phi = arm.phi.value_or(none), d = arm.difference.value_or(none);
      for (const double x : {phi.mean, phi.half_width, phi.deviation}) cells.push_back(fine(x));
      for (const double x : {d.mean, d.half_width}) cells.push_back(real(x));
      for (const std::size_t n :
           {arm.samples, arm.jammed, arm.settled, arm.budget, arm.diverged, arm.failed, arm.unfinished})
        cells.push_back(std::to_string(n));
      add_spread(cells, arm.core_seconds);
      add_spread(cells, arm.wall_seconds);
      cells.insert(cells.end(),
                   {real(arm.steps), real(arm.evaluations), fmt::format("{}", fmt::join(c.set, " ")),
                    fmt::format("{}", fmt::join(arm.set, " ")), version});
      table.row(cells);
    }
  return table;
}

Table comparison_table(const std::vector<ComparedCase>& cases) {
  Table table(
      {"case", "arm", "n", "lost", "core s", "steps", "phi", "+-", "difference/1e-4", "+-", "standing"});
  for (const ComparedCase& c : cases)
    for (const ComparedArm& arm : c.arms) {
      const auto optional = [](bool known, double x, int digits) {
        return known && std::isfinite(x) ? fmt::format("{:.{}f}", x, digits) : std::string("-");
      };
      const auto& [phi, d] = std::tie(arm.phi, arm.difference);
      table.row({c.name, arm.arm, std::to_string(phi ? phi->samples : 0), std::to_string(arm.lost()),
                 arm.core_seconds ? fmt::format("{:.3g}", arm.core_seconds->median) : "-",
                 optional(true, arm.steps, 0), optional(phi.has_value(), phi ? phi->mean : 0, 5),
                 optional(phi.has_value(), phi ? phi->half_width : 0, 5),
                 optional(d.has_value(), d ? 1e4 * d->mean : 0, 1),
                 optional(d.has_value(), d ? 1e4 * d->half_width : 0, 1), text_of_standing(arm)});
    }
  return table;
}

}  // namespace furnas
