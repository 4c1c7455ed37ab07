#include "cases/program/run/forecast.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace furnas {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t drift = 3;            // index of the criterion; it must be met at the end only
constexpr std::size_t least_looks = 12;     // needed for a trend
constexpr std::size_t most_looks = 400;     // beyond this number every second one is deleted
constexpr double carries = 0.3;             // largest stress error, over p_a, of a packing that carries load
constexpr double parts[] = {0.25, 0.5, 1};  // the trend is taken over each of these parts of the record
constexpr double too_short = 2,
                 too_long = 1.5;  // factors that widen the range; from 15 runs, docs/guide/first-steps.md

}  // namespace

void Forecast::add(std::int64_t step, const RestReport& report) {
  if (!(report.stress_error < carries) && looks_.empty()) return;
  if (report.backbone == 0 && looks_.empty()) return;
  // A criterion with the value 0 is met; its logarithm is minus infinity.
  const auto share = [](double value, double limit) { return std::log10(value / limit); };
  Look look{static_cast<double>(step),
            {share(report.stress_error, limits_.stress_error),
             share(report.force_imbalance, limits_.force_imbalance),
             share(report.kinetic_energy, limits_.kinetic_energy),
             share(report.strain_drift, limits_.strain_drift)}};
  if (report.backbone == 0) look.shares[1] = look.shares[2] = infinite;  // averages over no particle
  if (limits_.kinetic_energy_alone) look.shares = {-infinite, -infinite, look.shares[2], -infinite};
  looks_.push_back(look);
  const bool hold = std::all_of(look.shares.begin(), look.shares.begin() + drift,
                                [](double of_limit) { return of_limit < 0; });
  if (!hold) holds_since_.reset();
  if (hold && !holds_since_) holds_since_ = look.step;
  if (looks_.size() <= most_looks) return;
  for (std::size_t k = 0; 2 * k < looks_.size(); ++k) looks_[k] = looks_[2 * k];
  looks_.resize((looks_.size() + 1) / 2);
}

/// The line of least squares through a criterion over the last part of the record.
std::optional<Forecast::Line> Forecast::line(std::size_t criterion, double part) const {
  const auto count = static_cast<std::size_t>(part * static_cast<double>(looks_.size() - 1)) + 1;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  const double last = looks_.back().step;
  for (std::size_t k = looks_.size() - count; k < looks_.size(); ++k) {
    const double at = looks_[k].step - last, value = looks_[k].shares[criterion];
    if (!std::isfinite(value)) continue;
    ++n, x += at, y += value, xx += at * at, xy += at * value;
  }
  const double spread = n * xx - x * x;
  if (n < 4 || !(spread > 0)) return {};
  const double slope = (n * xy - x * y) / spread;
  return Line{slope, (y - slope * x) / n};
}

/// The rest of the window in which all criteria but the drift must be met.
double Forecast::rest_of_window() const {
  return holds_since_ ? std::max(window_ - (looks_.back().step - *holds_since_), 0.0) : window_;
}

/// Steps left according to the trend over this last part of the record.
double Forecast::steps_left(double part) const {
  double left = rest_of_window();
  for (std::size_t c = 0; c < criteria; ++c) {
    if (looks_.back().shares[c] < 0) continue;
    const std::optional<Line> trend = line(c, part);
    if (!trend) return infinite;
    const double to_limit = trend->slope < 0 ? std::max(trend->end, 0.0) / -trend->slope : infinite;
    left = std::max(left, to_limit + (c == drift ? 0 : window_));
  }
  return left;
}

std::optional<StepsLeft> Forecast::left() const {
  if (looks_.size() < least_looks) return {};
  std::array<double, std::size(parts)> found{};
  std::transform(std::begin(parts), std::end(parts), found.begin(),
                 [&](double part) { return steps_left(part); });
  std::sort(found.begin(), found.end());
  return StepsLeft{may_jump_ ? 0 : found.front() / too_short, found[found.size() / 2],
                   found.back() * too_long};
}

Trend Forecast::trend(std::size_t criterion) const {
  if (looks_.size() < least_looks) return Trend::unknown;
  const std::optional<Line> recent = line(criterion, parts[0]);
  if (!recent) return Trend::unknown;
  constexpr double noticed = 0.1;  // least change to report, in powers of ten per window
  const double change = recent->slope * window_;
  return change < -noticed ? Trend::falls : change > noticed ? Trend::rises : Trend::stands;
}

}  // namespace furnas
