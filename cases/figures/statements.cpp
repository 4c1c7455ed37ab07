#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/figures/report.h"

namespace furnas {
namespace {

std::string text_of(const MeanInterval& m) {
  return m.samples > 1 ? fmt::format("{:.4f} ± {:.4f}", m.mean, m.half_width) : fmt::format("{:.4f}", m.mean);
}

double reach_of(const MeanInterval& m) { return std::isfinite(m.half_width) ? m.half_width : 0; }

Finding finding(bool holds) { return holds ? Finding::reproduced : Finding::not_reproduced; }

/// A number of the paper: ours may differ by our interval and by what finite samples shift it.
void compare(Statement& s, const MeanInterval& ours, double paper, double tolerance) {
  s.ours = text_of(ours);
  s.n = std::to_string(ours.samples);
  s.finding = finding(std::abs(ours.mean - paper) <= tolerance + reach_of(ours));
}

Statement begin(std::string what, std::string paper, std::string rule) {
  return {std::move(what), std::move(paper), "-", "0", Finding::not_reachable, std::move(rule)};
}

Statement mono(const Study& study, double mu, double paper, double tolerance) {
  Statement s = begin(fmt::format("equal spheres, μ = {}: φ_mono", mu), fmt::format("{}", paper),
                      fmt::format("within the interval and {} (1000 spheres)", tolerance));
  if (const Point* point = study.mono_at(mu)) compare(s, *point->mean_phi_J, paper, tolerance);
  return s;
}

Statement point(const Study& study, double alpha, double mu, double f, double paper) {
  constexpr double tolerance = 0.01, near = 0.0051;
  Statement s = begin(fmt::format("α = {}, μ = {}, f_s = {}: φ_J", alpha, mu, f), fmt::format("{}", paper),
                      fmt::format("within the interval and {}", tolerance));
  const Curve* curve = study.curve(alpha, mu);
  if (curve == nullptr) return s;
  for (const Point& p : curve->points)
    if (std::abs(p.small_fraction - f) < near) compare(s, *p.mean_phi_J, paper, tolerance);
  return s;
}

/// φ_max and f_max of a size ratio, with the model's.
struct Highest {
  double friction;
  CurveMaximum maximum;
  std::optional<FurnasInterval> model;
};

std::vector<Highest> maxima_at(const Study& study, double alpha) {
  std::vector<Highest> all;
  for (const double mu : study.frictions())
    if (const Curve* curve = study.curve(alpha, mu))
      if (const auto m = maximum_of(*curve)) all.push_back({mu, *m, study.model(mu)});
  return all;
}

double largest_ratio(const Study& study) {
  const auto ratios = study.size_ratios();
  return ratios.empty() ? 0 : ratios.back();
}

void append(std::string& text, const std::string& more) { text += (text.empty() ? "" : "; ") + more; }

Statement near_model(const Study& study) {
  constexpr double alpha = 20, share = 0.02;
  Statement s = begin("α = 20: φ_max within 2 % of the model for all μ", "2 %",
                      "each friction within 2 % and the interval, at α = 20 or more");
  std::string text;
  std::size_t n = 0;
  bool holds = true, any = false;
  const double largest = largest_ratio(study);
  for (const Highest& h : maxima_at(study, largest)) {
    if (!h.model) continue;
    any = true;
    const double model = h.model->middle().phi_max(), ours = h.maximum.phi_max.mean;
    append(text, fmt::format("α = {}, μ = {}: {:+.1f} % ({} against {:.4f})", largest, h.friction,
                             100 * (ours / model - 1), text_of(h.maximum.phi_max), model));
    n += h.maximum.phi_max.samples;
    holds &= std::abs(ours - model) <= share * model + reach_of(h.maximum.phi_max);
  }
  if (!any) return s;
  s.ours = text;
  s.n = std::to_string(n);
  if (largest >= alpha) s.finding = finding(holds);
  return s;
}

Statement small_ratio(const Study& study) {
  Statement s = begin("α = 2: φ_max far below the model, well above equal spheres", "figure 3a",
                      "between φ_mono and the model, apart from both by more than the intervals");
  std::string text;
  std::size_t n = 0;
  bool holds = true, any = false;
  for (const Highest& h : maxima_at(study, 2)) {
    if (!h.model) continue;
    any = true;
    const MeanInterval& ours = h.maximum.phi_max;
    append(text, fmt::format("μ = {}: {:.4f} < {} < {:.4f}", h.friction, h.model->middle().mono,
                             text_of(ours), h.model->middle().phi_max()));
    n += ours.samples;
    holds &= ours.mean - reach_of(ours) > h.model->phi(0).high &&
             ours.mean + reach_of(ours) < h.model->phi_max().low;
  }
  if (!any) return s;
  s.ours = text;
  s.n = std::to_string(n);
  s.finding = finding(holds);
  return s;
}

Statement f_max_rises(const Study& study) {
  constexpr double most = 0.03;
  Statement s = begin("f_max rises with μ, by up to 0.03", "0.03",
                      "the rise at the largest α is positive and at most 0.03, within its interval");
  const auto maxima = maxima_at(study, largest_ratio(study));
  if (maxima.size() < 2) return s;
  const CurveMaximum &low = maxima.front().maximum, &high = maxima.back().maximum;
  const double rise = high.f_max - low.f_max;
  const double reach =
      std::hypot((high.f_max_high - high.f_max_low) / 2, (low.f_max_high - low.f_max_low) / 2);
  s.ours = fmt::format(
      "α = {}: {:.3f} ({:.3f} to {:.3f}) at μ = {}, {:.3f} ({:.3f} to {:.3f}) at μ = {}: {:+.3f} ± {:.3f}",
      largest_ratio(study), low.f_max, low.f_max_low, low.f_max_high, maxima.front().friction, high.f_max,
      high.f_max_low, high.f_max_high, maxima.back().friction, rise, reach);
  s.n = std::to_string(low.phi_max.samples + high.phi_max.samples);
  s.finding = finding(rise + reach > 0 && rise - reach <= most);
  if (reach > most) s.finding = Finding::not_reachable;  // it could not be seen
  return s;
}

/// The least and the largest of some shares.
struct Shares {
  double low = 2, high = -1;
  bool any() const { return low <= high; }
  void add(double share) {
    low = std::min(low, share);
    high = std::max(high, share);
  }
  void add(const Shares& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  std::string text() const { return any() ? fmt::format("{:.3f} to {:.3f}", low, high) : "no point"; }
};

/// The share of rattlers among the small spheres left and right of f_max, by the usual threshold.
Statement rattlers(const Study& study) {
  constexpr double alpha = 20;
  Statement s =
      begin("α = 20: nearly all small spheres rattle below f_max, then a sharp fall to 0 (μ = 0) … 0.22",
            "1, then 0 … 0.22", "above 0.9 below f_max, below 0.25 above it, at α = 20 or more");
  std::string text;
  std::size_t n = 0;
  const double largest = largest_ratio(study);
  Shares below, above;
  for (const double mu : study.frictions()) {
    const Curve* curve = study.curve(largest, mu);
    const auto model = study.model(mu);
    if (curve == nullptr || !model) continue;
    const std::size_t threshold = mu > 0 ? 1 : 2;  // of z_min 2, 3, 4
    Shares left, right;
    for (const Point& p : curve->points) {
      const auto& share = p.small_rattlers[threshold];
      if (!share) continue;
      n += share->samples;
      if (p.small_fraction < model->f_max().low - 0.02) left.add(share->mean);
      if (p.small_fraction > model->f_max().high + 0.02) right.add(share->mean);
    }
    append(text, fmt::format("μ = {}: {} below f_max, {} above", mu, left.text(), right.text()));
    below.add(left);
    above.add(right);
  }
  const bool any = below.any() || above.any();
  const bool holds = below.any() && above.any() && below.low > 0.9 && above.high < 0.25;
  if (!any) return s;
  s.ours = fmt::format("α = {}: {}", largest, text);
  s.n = std::to_string(n);
  if (largest >= alpha) s.finding = finding(holds);
  return s;
}

Statement friction_lowers(const Study& study) {
  Statement s =
      begin("friction lowers φ_J everywhere", "figures 2a, 2b",
            "no point where the larger friction is denser by more than its interval, and lower on average");
  const auto frictions = study.frictions();
  if (frictions.size() < 2) return s;
  std::size_t lower = 0, points = 0, n = 0;
  double sum = 0;
  bool holds = true;
  for (const double ratio : study.size_ratios()) {
    const Curve *smooth = study.curve(ratio, frictions.front()),
                *rough = study.curve(ratio, frictions.back());
    if (smooth == nullptr || rough == nullptr) continue;
    for (const Point& a : smooth->points)
      for (const Point& b : rough->points) {
        if (a.small_fraction != b.small_fraction) continue;
        const MeanInterval d = difference_interval(b.phi_J, a.phi_J);
        ++points;
        n += d.samples;
        sum += d.mean;
        lower += d.mean < 0;
        holds &= d.mean - reach_of(d) <= 0;
      }
  }
  if (points == 0) return s;
  s.ours = fmt::format("lower at {} of {} points, by {:.4f} on average (μ = {} against {})", lower, points,
                       -sum / static_cast<double>(points), frictions.back(), frictions.front());
  s.n = std::to_string(n);
  s.finding = finding(holds && sum < 0);
  return s;
}

Statement rises_and_falls(const Study& study) {
  Statement s =
      begin("φ_J(f_s) rises to a maximum and falls again", "figures 2a, 2b",
            "the highest point of each curve lies above both of its ends by more than the intervals");
  std::string text;
  std::size_t n = 0;
  bool holds = true, any = false;
  for (const Curve& curve : study.curves) {
    const auto m = maximum_of(curve);
    if (!m) continue;
    any = true;
    const auto above = [&](const Point& end) {
      return m->phi_max.mean - end.mean_phi_J->mean >
             std::hypot(reach_of(m->phi_max), reach_of(*end.mean_phi_J));
    };
    const bool shown = above(curve.points.front()) && above(curve.points.back());
    if (!shown) append(text, fmt::format("α = {}, μ = {}: not shown", curve.size_ratio(), curve.friction()));
    for (const Point& p : curve.points) n += p.jammed;
    holds &= shown;
  }
  if (!any) return s;
  s.ours = text.empty() ? "each curve" : text;
  s.n = std::to_string(n);
  s.finding = finding(holds);
  return s;
}

}  // namespace

std::vector<Statement> statements_of(const Study& study) {
  // The tolerances are what samples of 1000 spheres have been seen to differ by from larger ones.
  return {mono(study, 0, 0.638, 0.008),
          mono(study, 0.3, 0.588, 0.0125),
          rises_and_falls(study),
          friction_lowers(study),
          point(study, 20, 0, 0.265, 0.869),
          point(study, 40, 0, 0.265, 0.857),
          point(study, 20, 0.3, 0.29, 0.823),
          point(study, 40, 0.3, 0.292, 0.830),
          near_model(study),
          small_ratio(study),
          f_max_rises(study),
          rattlers(study)};
}

}  // namespace furnas
