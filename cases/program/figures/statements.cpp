#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/program/figures/reach.h"
#include "cases/program/figures/report.h"

namespace furnas {
namespace {

std::string text_of(const MeanInterval& m) {
  return m.samples > 1 ? fmt::format("{:.4f} ± {:.4f}", m.mean, m.half_width) : fmt::format("{:.4f}", m.mean);
}

/// phi_J of a point; one or two samples have the interval of the pooled scatter.
std::string text_of(const Point& point, const Reach& reach) {
  return reach.pools(point)
             ? fmt::format("{:.4f} ± {:.4f} by pooled scatter", point.mean_phi_J->mean, reach.of_phi_J(point))
             : text_of(*point.mean_phi_J);
}

/// Whether a value, known +- reach, is positive; decided only where the whole interval has one sign.
Agreement positive(double value, double reach) {
  if (value - reach > 0) return Agreement::reproduced;
  return value + reach <= 0 ? Agreement::not_reproduced : Agreement::not_reachable;
}

/// Compares a number of the paper with ours. The two may differ by `tolerance`, the effect of finite samples;
/// a larger difference that the interval may explain is not excluded. Where our interval is wider than twice
/// the tolerance, agreement proves nothing, and the result is "not reachable".
Agreement near(double ours, double reach, double paper, double tolerance) {
  const double difference = std::abs(ours - paper);
  if (difference > tolerance + reach) return Agreement::not_reproduced;
  if (reach > 2 * tolerance) return Agreement::not_reachable;
  return difference > tolerance ? Agreement::not_excluded : Agreement::reproduced;
}

/// The agreement of a whole is that of its worst part.
Agreement all_of(const std::vector<Agreement>& parts) {
  for (const Agreement worst : {Agreement::not_reproduced, Agreement::not_reachable, Agreement::not_excluded})
    if (std::find(parts.begin(), parts.end(), worst) != parts.end()) return worst;
  return parts.empty() ? Agreement::not_reachable : Agreement::reproduced;
}

void compare(Statement& s, const Point& ours, const Reach& reach, double paper, double tolerance) {
  s.ours = text_of(ours, reach);
  if (ours.too_thin()) s.ours += fmt::format(" (cells {} largest diameters thick)", thickness_text(ours));
  s.n = std::to_string(ours.phi_J.size());
  s.agreement = near(ours.mean_phi_J->mean, reach.of_phi_J(ours), paper, tolerance);
}

Statement begin(std::string what, std::string paper, std::string rule) {
  return {std::move(what), std::move(paper), "-", "0", Agreement::not_reachable, std::move(rule)};
}

Statement mono(const Study& study, const Reach& reach, double mu, double paper, double tolerance) {
  Statement s = begin(fmt::format("equal spheres, μ = {}: φ_mono", mu), fmt::format("{}", paper),
                      fmt::format("differs by at most {} (1000 spheres)", tolerance));
  if (const Point* point = study.mono_at(mu)) compare(s, *point, reach, paper, tolerance);
  return s;
}

/// `words`: what the paper says of the number, with {} in its place.
Statement point(const Study& study, const Reach& reach, double alpha, double mu, double f, double paper,
                const char* words = "{}") {
  constexpr double tolerance = 0.01, near = 0.0051;
  Statement s =
      begin(fmt::format("α = {}, μ = {}, f_s = {}: φ_J", alpha, mu, f),
            fmt::format(fmt::runtime(words), paper), fmt::format("differs by at most {}", tolerance));
  const Curve* curve = study.curve(alpha, mu);
  if (curve == nullptr) return s;
  const auto off = [f](const Point& p) { return std::abs(p.small_fraction - f); };
  const auto nearest = std::min_element(curve->points.begin(), curve->points.end(),
                                        [&](const Point& a, const Point& b) { return off(a) < off(b); });
  if (nearest != curve->points.end() && off(*nearest) < near) compare(s, *nearest, reach, paper, tolerance);
  return s;
}

/// φ_max and f_max of a size ratio, and the model's values.
struct Highest {
  double friction;
  CurveMaximum maximum;
  std::string phi_max;  ///< with its interval
  double reach;         ///< of phi_max, +-
  std::optional<FurnasInterval> model;
};

/// Leaves out a curve that is highest at one of its ends, because its maximum may lie beyond.
std::vector<Highest> maxima_at(const Study& study, const Reach& reach, double alpha) {
  std::vector<Highest> all;
  for (const double mu : study.frictions()) {
    const Curve* curve = study.curve(alpha, mu);
    const auto m = curve != nullptr ? maximum_of(*curve) : std::nullopt;
    if (!m || !m->inside) continue;
    const Point& p = curve->points[m->place];
    all.push_back({mu, *m, text_of(p, reach), reach.of_phi_J(p), study.model(mu)});
  }
  return all;
}

/// The largest size ratio for which `answers` is true; 0 if there is none.
template <class Answers>
double largest_ratio(const Study& study, Answers&& answers) {
  const auto ratios = study.size_ratios();
  const auto found = std::find_if(ratios.rbegin(), ratios.rend(), answers);
  return found == ratios.rend() ? 0 : *found;
}

void append(std::string& text, const std::string& more) { text += (text.empty() ? "" : "; ") + more; }

Statement near_model(const Study& study, const Reach& reach) {
  constexpr double alpha = 20, share = 0.02;
  Statement s = begin("α = 20: φ_max within 2 % of the model for all μ", "2 %",
                      "differs by at most 2 % for each friction of the sweeps, at α = 20 or more");
  std::string text;
  std::size_t n = 0;
  std::vector<Agreement> parts;
  const double largest =
      largest_ratio(study, [&](double ratio) { return !maxima_at(study, reach, ratio).empty(); });
  for (const Highest& h : maxima_at(study, reach, largest)) {
    if (!h.model) continue;
    const double model = h.model->middle().phi_max(), ours = h.maximum.phi_max.mean;
    append(text, fmt::format("α = {}, μ = {}: {:+.1f} % ({} against {:.4f})", largest, h.friction,
                             100 * (ours / model - 1), h.phi_max, model));
    n += h.maximum.phi_max.samples;
    parts.push_back(near(ours, h.reach, model, share * model));
  }
  if (parts.empty()) return s;
  s.ours = text;
  s.n = std::to_string(n);
  if (parts.size() < study.frictions().size()) parts.push_back(Agreement::not_reachable);
  if (largest >= alpha) s.agreement = all_of(parts);
  return s;
}

Statement small_ratio(const Study& study, const Reach& reach) {
  Statement s = begin("α = 2: φ_max far below the model, well above equal spheres", "figure 3a",
                      "between φ_mono and the model, apart from both by more than the intervals");
  std::string text;
  std::size_t n = 0;
  std::vector<Agreement> parts;
  for (const Highest& h : maxima_at(study, reach, 2)) {
    if (!h.model) continue;
    const MeanInterval& ours = h.maximum.phi_max;
    append(text, fmt::format("μ = {}: {:.4f} < {} < {:.4f}", h.friction, h.model->middle().mono, h.phi_max,
                             h.model->middle().phi_max()));
    n += ours.samples;
    parts.push_back(positive(ours.mean - h.model->phi(0).high, h.reach));
    parts.push_back(positive(h.model->phi_max().low - ours.mean, h.reach));
  }
  if (parts.empty()) return s;
  s.ours = text;
  s.n = std::to_string(n);
  s.agreement = all_of(parts);
  return s;
}

/// Number of finished samples of a curve, to which the maximum is fitted.
std::size_t ended_samples(const Curve& curve) {
  std::size_t n = 0;
  for (const Point& p : curve.points) n += p.jammed + p.settled;
  return n;
}

/// The rise of f_max from the smallest to the largest friction that has a maximum.
struct Rise {
  Highest low, high;
  double value() const { return high.maximum.f_max - low.maximum.f_max; }
  double reach() const {
    const auto half = [](const CurveMaximum& m) { return (m.f_max_high - m.f_max_low) / 2; };
    return std::hypot(half(high.maximum), half(low.maximum));
  }
};

/// None with fewer than two maxima.
std::optional<Rise> rise_at(const Study& study, const Reach& reach, double alpha) {
  const auto maxima = maxima_at(study, reach, alpha);
  if (maxima.size() < 2) return {};
  return Rise{maxima.front(), maxima.back()};
}

Statement f_max_rises(const Study& study, const Reach& reach) {
  constexpr double most = 0.03;
  Statement s = begin("f_max rises with μ, by up to 0.03", "0.03",
                      "the rise at the largest α at which it is known to ±0.03 (else: with two maxima) is "
                      "positive by more than its interval, which reaches below 0.03");
  const auto known_at = [&](double least) {
    return largest_ratio(study, [&](double ratio) {
      const auto rise = rise_at(study, reach, ratio);
      return rise && rise->reach() <= least;
    });
  };
  const double sharp = known_at(most);
  const double alpha = sharp > 0 ? sharp : known_at(std::numeric_limits<double>::infinity());
  const auto rise = rise_at(study, reach, alpha);
  if (!rise) return s;
  const CurveMaximum &low = rise->low.maximum, &high = rise->high.maximum;
  s.ours = fmt::format(
      "α = {}: {:.3f} ({:.3f} to {:.3f}) at μ = {}, {:.3f} ({:.3f} to {:.3f}) at μ = {}: {:+.3f} ± {:.3f}",
      alpha, low.f_max, low.f_max_low, low.f_max_high, rise->low.friction, high.f_max, high.f_max_low,
      high.f_max_high, rise->high.friction, rise->value(), rise->reach());
  s.n = std::to_string(ended_samples(*study.curve(alpha, rise->low.friction)) +
                       ended_samples(*study.curve(alpha, rise->high.friction)));
  s.agreement = rise->value() - rise->reach() > most ? Agreement::not_reproduced
                                                     : positive(rise->value(), rise->reach());
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

/// The share of rattlers among the small spheres of one size ratio, below and above f_max, with the
/// thresholds of the paper.
struct Sides {
  Shares below, above;
  std::string text;
  std::size_t n = 0;
  std::vector<Agreement> parts;
};

Sides sides_of(const Study& study, const Reach& reach, double size_ratio) {
  constexpr double nearly_all = 0.9, few = 0.25;
  Sides sides;
  for (const double mu : study.frictions()) {
    const Curve* curve = study.curve(size_ratio, mu);
    const auto model = study.model(mu);
    if (curve == nullptr || !model) {
      sides.parts.push_back(Agreement::not_reachable);
      continue;
    }
    const std::size_t threshold = mu > 0 ? 0 : 1;  // of z_min 2, 3, 4
    Shares left, right;
    for (const Point& p : curve->points) {
      const auto& share = p.small_rattlers[threshold];
      if (!share) continue;
      const double off = reach.of_small_rattlers(p, threshold);
      sides.n += share->samples;
      if (p.small_fraction < model->f_max().low - 0.02) {
        left.add(share->mean);
        sides.parts.push_back(positive(share->mean - nearly_all, off));
      }
      if (p.small_fraction > model->f_max().high + 0.02) {
        right.add(share->mean);
        sides.parts.push_back(positive(few - share->mean, off));
      }
    }
    if (!left.any() || !right.any()) sides.parts.push_back(Agreement::not_reachable);
    append(sides.text, fmt::format("μ = {}: {} below f_max, {} above", mu, left.text(), right.text()));
    sides.below.add(left);
    sides.above.add(right);
  }
  return sides;
}

Statement rattlers(const Study& study, const Reach& reach) {
  constexpr double alpha = 20;
  Statement s =
      begin("α = 20: nearly all small spheres rattle below f_max, then a sharp fall to 0 (μ = 0) … 0.22",
            "1, then 0 … 0.22",
            "above 0.9 below f_max, below 0.25 above it, for each friction of the sweeps, at α = 20 or more; "
            "rattlers have fewer than 3 live contacts (μ = 0) or 2");
  const double largest = largest_ratio(study, [&](double ratio) {
    const Sides sides = sides_of(study, reach, ratio);
    return sides.below.any() && sides.above.any();
  });
  const Sides sides = sides_of(study, reach, largest);
  if (sides.n == 0) return s;
  s.ours = fmt::format("α = {}: {}", largest, sides.text);
  s.n = std::to_string(sides.n);
  if (largest >= alpha) s.agreement = all_of(sides.parts);
  return s;
}

Statement friction_lowers(const Study& study, const Reach& reach) {
  Statement s =
      begin("friction lowers φ_J everywhere", "figures 2a, 2b",
            "no point where the larger friction is denser by more than its interval, and lower on average");
  const auto frictions = study.frictions();
  if (frictions.size() < 2) return s;
  std::vector<double> falls;  // fall of phi_J at each point
  std::size_t n = 0;
  bool denied = false;
  for (const double ratio : study.size_ratios()) {
    const Curve *smooth = study.curve(ratio, frictions.front()),
                *rough = study.curve(ratio, frictions.back());
    if (smooth == nullptr || rough == nullptr) continue;
    for (const Point& a : smooth->points)
      for (const Point& b : rough->points) {
        if (a.small_fraction != b.small_fraction) continue;
        const MeanInterval fall = difference_interval(a.phi_J, b.phi_J);
        falls.push_back(fall.mean);
        n += fall.samples;
        denied |= fall.mean + std::hypot(reach.of_phi_J(a), reach.of_phi_J(b)) < 0;
      }
  }
  if (falls.empty()) return s;
  const MeanInterval average = mean_interval(falls);
  s.ours = fmt::format("lower at {} of {} points, by {} on average (μ = {} against {})",
                       std::count_if(falls.begin(), falls.end(), [](double fall) { return fall > 0; }),
                       falls.size(), text_of(average), frictions.back(), frictions.front());
  s.n = std::to_string(n);
  s.agreement = denied ? Agreement::not_reproduced : positive(average.mean, average.half_width);
  return s;
}

/// Whether a curve has points on both sides of the model's maximum; true without a model.
bool spans_the_maximum(const Study& study, const Curve& curve) {
  const auto model = study.model(curve.friction());
  return !model || (curve.points.front().small_fraction < model->f_max().low &&
                    curve.points.back().small_fraction > model->f_max().high);
}

/// Whether a point within a curve lies above both ends of the curve. A point above both by more than the
/// intervals decides; without one, the highest point decides.
Agreement has_maximum(const Curve& curve, const Reach& reach) {
  const Point &first = curve.points.front(), &last = curve.points.back();
  const auto above = [&reach](const Point& inner, const Point& end) {
    return positive(inner.mean_phi_J->mean - end.mean_phi_J->mean,
                    std::hypot(reach.of_phi_J(inner), reach.of_phi_J(end)));
  };
  const auto above_the_ends = [&](const Point& inner) {
    return all_of({above(inner, first), above(inner, last)});
  };
  const auto begin = curve.points.begin() + 1, end = curve.points.end() - 1;
  if (std::any_of(begin, end, [&](const Point& p) { return above_the_ends(p) == Agreement::reproduced; }))
    return Agreement::reproduced;
  return above_the_ends(*std::max_element(
      begin, end, [](const Point& a, const Point& b) { return a.mean_phi_J->mean < b.mean_phi_J->mean; }));
}

Statement rises_and_falls(const Study& study, const Reach& reach) {
  Statement s = begin("φ_J(f_s) rises to a maximum and falls again", "figures 2a, 2b",
                      "within each curve that reaches beyond the model's maximum a point lies above both of "
                      "its ends by more than the intervals");
  std::string text;
  std::size_t n = 0;
  std::vector<Agreement> parts;
  for (const Curve& curve : study.curves) {
    if (curve.points.size() < 3 || !spans_the_maximum(study, curve)) continue;
    parts.push_back(has_maximum(curve, reach));
    if (parts.back() != Agreement::reproduced)
      append(text, fmt::format("α = {}, μ = {}: {}", curve.size_ratio(), curve.friction(),
                               parts.back() == Agreement::not_reproduced ? "no maximum" : "cannot be told"));
    n += ended_samples(curve);
  }
  if (parts.empty()) return s;
  s.ours = text.empty() ? fmt::format("each of {} curves", parts.size()) : text;
  s.n = std::to_string(n);
  s.agreement = all_of(parts);
  return s;
}

}  // namespace

std::vector<Statement> statements_of(const Study& study) {
  // Without friction phi_J of 1000 spheres is 0.002 below that of large samples; with friction phi_J depends
  // on the protocol by up to 0.01 (docs/results/verification.md).
  const Study thick = study.without_thin_cells();
  const Reach reach(thick);
  return {mono(study, reach, 0, 0.638, 0.004),
          mono(study, reach, 0.3, 0.588, 0.01),
          rises_and_falls(thick, reach),
          friction_lowers(thick, reach),
          point(study, reach, 20, 0, 0.265, 0.869, "close to the {} of the model"),
          point(study, reach, 40, 0, 0.265, 0.857),
          point(study, reach, 20, 0.3, 0.29, 0.823),
          point(study, reach, 40, 0.3, 0.292, 0.830),
          near_model(thick, reach),
          small_ratio(thick, reach),
          f_max_rises(thick, reach),
          rattlers(thick, reach)};
}

}  // namespace furnas
