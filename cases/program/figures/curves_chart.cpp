#include "cases/program/figures/curves_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "cases/program/figures/figures.h"
#include "cases/program/figures/study.h"
#include "cases/program/sweep/points.h"

namespace furnas {
namespace {

constexpr std::array curve_markers{Marker::circle, Marker::square, Marker::diamond, Marker::triangle,
                                   Marker::wedge};
constexpr std::array line_styles{LineStyle::solid, LineStyle::dashed, LineStyle::dotted};

/// The settings that equal spheres must share with a mixture, so that the model of the mixture can use their
/// phi.
using Rules = std::vector<std::string>;

class CurvesChart {
 public:
  CurvesChart(const std::vector<CurveOfSamples>& curves, const CurvesSubject& subject,
              std::vector<std::string>& remarks)
      : curves_(curves), subject_(subject), remarks_(remarks) {}

  Chart draw() {
    begin_axes();
    std::vector<Series> measured;
    for (std::size_t n = 0; n < curves_.size(); ++n) measured.push_back(series_of(n));
    if (subject_.y.name == "phi_J") add_models();
    chart_.series.insert(chart_.series.end(), measured.begin(), measured.end());
    if (thin_ > 0) {
      chart_.series.push_back(open_symbol());
      remarks_.push_back(
          fmt::format("{} of {} points, drawn with open symbols, are of cells thinner than {} largest "
                      "diameters, which do not represent large packings; more large spheres (mixture.large) "
                      "make them thicker",
                      thin_, points_, least_thickness));
    }
    if (chart_.series.size() == 1) chart_.series.front().name.clear();
    explain_bars(chart_);
    return std::move(chart_);
  }

 private:
  const SampleRow& row(std::size_t k) const { return subject_.all.table.rows[k]; }

  static const std::string& value_in(const Gathered& all, std::size_t k, const std::string& key) {
    const auto& keys = all.table.keys;
    const auto place = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
    return all.table.rows[k].values[place];
  }
  const std::string& value(std::size_t k, const std::string& key) const {
    return value_in(subject_.all, k, key);
  }

  void begin_axes() {
    chart_.x.title = title_of_key(subject_.x);
    chart_.y.title = subject_.y.title;
    double low = HUGE_VAL, high = -HUGE_VAL;
    std::set<double> places;
    for (const CurveOfSamples& curve : curves_)
      for (const auto& [x, rows] : curve.points) {
        low = std::min(low, x), high = std::max(high, x);
        places.insert(x);
      }
    constexpr double wide = 30;
    chart_.x.logarithmic = places.size() > 2 && low > 0 && high / low > wide;
    if (places.size() > 1) {  // keeps points off the frame
      constexpr double margin = 0.05;
      const double room = margin * (high - low), factor = std::pow(high / low, margin);
      chart_.x.low = chart_.x.logarithmic ? low / factor : low - room;
      chart_.x.high = chart_.x.logarithmic ? high * factor : high + room;
    }
    chart_.title = title();
  }

  /// The most important keys, as far as they have one value in all samples.
  std::string title() const {
    std::string text;
    for (const char* key : {"mixture.size_ratio", fraction_key, "contact.friction", "compaction.pressure"}) {
      const auto& keys = subject_.all.table.keys;
      if (std::find(keys.begin(), keys.end(), key) == keys.end() || key == subject_.x) continue;
      std::set<std::string> values;
      for (std::size_t k = 0; k < subject_.all.runs.size(); ++k) values.insert(value(k, key));
      const bool equal_spheres = key == std::string_view("mixture.size_ratio") && *values.begin() == "1";
      if (values.size() == 1 && equal_spheres) {
        text = "equal spheres";
        continue;
      }
      if (text == "equal spheres" && key == std::string_view(fraction_key)) continue;
      if (values.size() == 1 && !values.begin()->empty())
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", symbol_of_key(key), *values.begin());
    }
    return text;
  }

  std::string name_of(const CurveOfSamples& curve) const {
    std::string name;
    for (std::size_t k = 0; k < subject_.by.size(); ++k)
      name += fmt::format("{}{} = {}", k == 0 ? "" : ", ", symbol_of_key(subject_.by[k]),
                          curve.values[k].empty() ? "unknown" : curve.values[k]);
    return name.empty() ? "measured" : name;
  }

  /// The means over the samples of a point.
  static Point point_of(const Gathered& all, const std::vector<std::size_t>& rows) {
    SampleTable table;
    for (const std::size_t k : rows) {
      table.rows.push_back(all.table.rows[k]);
      table.rows.back().values.clear();
    }
    return points_of(table).front();
  }

  std::optional<MeanInterval> mean_of(const std::vector<std::size_t>& rows, const Point& point) const {
    if (subject_.y.name == "phi_J") return point.mean_phi_J;  // includes the bounds of settled samples
    std::vector<double> values;
    for (const std::size_t k : rows)
      if (const auto value = subject_.y.of(row(k), subject_.all.runs[k])) values.push_back(*value);
    if (values.empty()) return {};
    return mean_interval(values);
  }

  Series series_of(std::size_t n) {
    const CurveOfSamples& curve = curves_[n];
    Series s{name_of(curve)};
    s.colour = series_colours[n % series_colours.size()];
    s.marker = curve_markers[n % curve_markers.size()];
    for (const auto& [x, rows] : curve.points) {
      const Point point = point_of(subject_.all, rows);
      const auto mean = mean_of(rows, point);
      if (!mean) continue;
      const bool known = std::isfinite(mean->half_width);
      s.x.push_back(x);
      s.y.push_back(mean->mean);
      s.bars.push_back(known ? Bar{mean->mean - std::max(mean->low(), subject_.y.least),
                                   std::min(mean->high(), subject_.y.most) - mean->mean}
                             : Bar{});
      s.open.push_back(point.too_thin());
      thin_ += point.too_thin() ? 1 : 0;
      ++points_;
    }
    return s;
  }

  static Rules rules_of(const Gathered& all, std::size_t k) {
    Rules rules;
    for (const std::string& key : all.table.keys)
      if (key != "mixture.size_ratio" && key != fraction_key && key != "mixture.large")
        rules.push_back(value_in(all, k, key));
    return rules;
  }

  /// phi_mono for each set of rules, from the largest samples of equal spheres.
  std::map<Rules, FurnasInterval> models() const {
    std::map<Rules, std::vector<std::size_t>> of_rules;
    const auto& equal = subject_.equal;
    const auto size_of = [&](std::size_t k) { return equal.table.rows[k].large; };
    for (std::size_t k = 0; k < equal.runs.size(); ++k) {
      auto& rows = of_rules[rules_of(equal, k)];
      if (!rows.empty() && size_of(rows.front()) < size_of(k)) rows.clear();
      if (rows.empty() || size_of(rows.front()) == size_of(k)) rows.push_back(k);
    }
    std::map<Rules, FurnasInterval> all;
    for (const auto& [rules, rows] : of_rules)
      all.emplace(rules, furnas_model_of(*point_of(equal, rows).mean_phi_J));
    return all;
  }

  void add_models() {
    const auto known = models();
    std::map<Rules, std::vector<std::size_t>> curves_of_rules;  // curves of mixtures
    std::map<Rules, std::size_t> missing;                       // rules without a model, and a row of each
    for (std::size_t n = 0; n < curves_.size(); ++n)
      for (const auto& [x, rows] : curves_[n].points) {
        if (row(rows.front()).size_ratio == 1) continue;
        const Rules rules = rules_of(subject_.all, rows.front());
        auto& of_rules = curves_of_rules[rules];
        if (of_rules.empty() || of_rules.back() != n) of_rules.push_back(n);
        if (!known.contains(rules)) missing.emplace(rules, rows.front());
      }
    if (subject_.x == fraction_key)
      add_lines(known, curves_of_rules);
    else
      add_points(known);
    tell_missing(missing);
  }

  /// The model at many f_s, once for each set of rules.
  void add_lines(const std::map<Rules, FurnasInterval>& known,
                 const std::map<Rules, std::vector<std::size_t>>& curves_of_rules) {
    std::size_t drawn = 0;
    for (const auto& [rules, curves] : curves_of_rules) {
      const auto model = known.find(rules);
      if (model == known.end()) continue;
      const double mono = model->second.middle().mono;
      const bool own = curves.size() == 1 && curves_of_rules.size() > 1;
      Series s{own ? "model, " + name_of(curves_[curves.front()])
                   : fmt::format("model, φ_{{mono}} = {:.3f}", mono)};
      s.colour = own ? series_colours[curves.front() % series_colours.size()] : black;
      s.line = own ? LineStyle::dotted : line_styles[drawn % line_styles.size()];
      for (int k = 0; k <= 500; ++k) {
        s.x.push_back(0.002 * k);
        s.y.push_back(model->second.middle().phi(s.x.back()));
      }
      chart_.series.push_back(std::move(s));
      ++drawn;
    }
    if (drawn > 0) chart_.x.low = -0.02, chart_.x.high = 1.02;
  }

  /// The model at the f_s of each point of each curve.
  void add_points(const std::map<Rules, FurnasInterval>& known) {
    for (std::size_t n = 0; n < curves_.size(); ++n) {
      Series s{curves_.size() == 1 ? "model" : "model, " + name_of(curves_[n])};
      s.colour = series_colours[n % series_colours.size()];
      s.line = LineStyle::dotted;
      for (const auto& [x, rows] : curves_[n].points) {
        const auto model = known.find(rules_of(subject_.all, rows.front()));
        if (model == known.end() || row(rows.front()).size_ratio == 1) continue;
        s.x.push_back(x);
        s.y.push_back(model->second.middle().phi(row(rows.front()).small_fraction));
      }
      if (!s.x.empty()) chart_.series.push_back(std::move(s));
    }
  }

  void tell_missing(const std::map<Rules, std::size_t>& missing) {
    std::set<double> frictions;
    for (const auto& [rules, k] : missing) frictions.insert(row(k).friction);
    if (missing.empty()) return;
    const std::size_t k = missing.begin()->second;
    remarks_.push_back(
        fmt::format("no model at friction {}: it needs phi_mono of equal spheres with the same settings, and "
                    "these sweeps "
                    "have none. To make them{}: {}, and plot that folder too",
                    fmt::join(frictions, ", "), frictions.size() > 1 ? ", for the first" : "",
                    command_for_equal_spheres(subject_.all.sweeps[k], row(k).friction)));
  }

  const std::vector<CurveOfSamples>& curves_;
  const CurvesSubject& subject_;
  std::vector<std::string>& remarks_;
  Chart chart_;
  std::size_t thin_ = 0, points_ = 0;
};

}  // namespace

Chart chart_of(const std::vector<CurveOfSamples>& curves, const CurvesSubject& subject,
               std::vector<std::string>& remarks) {
  return CurvesChart(curves, subject, remarks).draw();
}

}  // namespace furnas
