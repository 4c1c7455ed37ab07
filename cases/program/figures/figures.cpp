#include "cases/program/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/program/table.h"
#include "io/csv.h"
#include "io/history.h"

namespace furnas {
namespace {

constexpr std::array markers{Marker::circle, Marker::square, Marker::diamond, Marker::triangle,
                             Marker::wedge};
constexpr std::array lines{LineStyle::dotted, LineStyle::dashed, LineStyle::solid};

Series measured(std::string name, std::size_t n, LineStyle line = LineStyle::solid) {
  Series s{std::move(name)};
  s.colour = series_colours[n % series_colours.size()];
  s.marker = markers[n % markers.size()];
  s.line = line;
  return s;
}

/// Adds a point. A single sample has no error bar, and a point of a too thin cell has an open symbol.
void add(Series& s, double x, const Interval& y, bool thin = false) {
  s.x.push_back(x);
  s.y.push_back(y.value);
  const bool known = std::isfinite(y.high - y.low);
  s.bars.push_back(known ? Bar{y.value - y.low, y.high - y.value} : Bar{});
  s.open.push_back(thin);
}

void add(Series& s, double x, const MeanInterval& mean, bool thin = false) {
  add(s, x, Interval{mean.mean, mean.low(), mean.high()}, thin);
}

/// Adds an entry for open symbols to the legend, if there are any.
void explain_open(Chart& chart) {
  const auto has_open = [](const Series& s) {
    return std::find(s.open.begin(), s.open.end(), true) != s.open.end();
  };
  if (std::any_of(chart.series.begin(), chart.series.end(), has_open)) chart.series.push_back(open_symbol());
}

/// The model at many f_s.
template <class Value>
Series model_line(std::string name, Value&& value) {
  Series s{std::move(name)};
  s.colour = black;
  for (int k = 0; k <= 500; ++k) {
    const double f = 0.002 * k;
    s.x.push_back(f);
    s.y.push_back(value(f));
  }
  return s;
}

Chart over_fractions(std::string y) {
  Chart chart;
  chart.x.title = "f_s";
  // Bars on the frame would not be seen.
  chart.x.low = -0.02;
  chart.x.high = 1.02;
  chart.y.title = std::move(y);
  return chart;
}

std::string model_name(const FurnasInterval& model) {
  return fmt::format("model, φ_{{mono}} = {:.3f}", model.middle().mono);
}

/// A value at each point of each curve of one friction, and the value of the model.
template <class Value>
Chart curves_chart(const Study& study, double friction, const std::string& y, Value&& value) {
  Chart chart = over_fractions(y);
  if (const auto model = study.model(friction))
    chart.series.push_back(model_line(model_name(*model), [&](double f) {
      return value(MeanInterval{1, model->middle().phi(f), 0, 0}, f).mean;
    }));
  const auto ratios = study.size_ratios();
  for (std::size_t n = 0; n < ratios.size(); ++n) {
    const Curve* curve = study.curve(ratios[n], friction);
    if (curve == nullptr) continue;
    Series s = measured(fmt::format("α = {}", ratios[n]), n);
    for (const Point& p : curve->points)
      add(s, p.small_fraction, value(*p.mean_phi_J, p.small_fraction), p.too_thin());
    chart.series.push_back(std::move(s));
  }
  return chart;
}

void add_curves(const Study& study, std::vector<Figure>& figures) {
  for (const double mu : study.frictions()) {
    Chart chart = curves_chart(study, mu, "φ_J", [](const MeanInterval& phi, double) { return phi; });
    if (const Point* mono = study.mono_at(mu)) {
      // Equal spheres are both ends of the curve: all large at f_s = 0, all small at f_s = 1. Follows the
      // model in the legend.
      Series s = measured("α = 1", 4, LineStyle::none);
      s.colour = black;
      for (const double f : {0.0, 1.0}) add(s, f, *mono->mean_phi_J, mono->too_thin());
      chart.series.insert(chart.series.begin() + 1, std::move(s));
    }
    chart.title = fmt::format("μ = {}", mu);
    figures.push_back(
        {fmt::format("figure_2_friction_{}", mu),
         fmt::format("Packing fraction at jamming against the volume fraction of small spheres, "
                     "friction {}; bars: 95 % intervals of the mean.",
                     mu),
         std::move(chart)});
  }
}

/// The interval is multiplied by d(phi_S)/d(phi).
MeanInterval in_voids(const MeanInterval& phi, double f) {
  MeanInterval m = phi;
  m.mean = fraction_in_voids(phi.mean, f);
  const double room = 1 - phi.mean * (1 - f);
  m.half_width = phi.half_width * f / (room * room);
  return m;
}

MeanInterval of_large(const MeanInterval& phi, double f) {
  MeanInterval m = phi;
  m.mean = fraction_of_large(phi.mean, f);
  m.half_width = phi.half_width * (1 - f);
  return m;
}

void add_parts(const Study& study, std::vector<Figure>& figures) {
  for (const double mu : study.frictions()) {
    Chart large = curves_chart(study, mu, "φ_L = φ_J (1 − f_s)", of_large);
    Chart small = curves_chart(study, mu, "φ_S = f_s φ_J / (1 − φ_L)", in_voids);
    large.y.low = small.y.low = 0;
    large.title = small.title = fmt::format("μ = {}", mu);
    figures.push_back({fmt::format("phi_large_friction_{}", mu),
                       fmt::format("Packing fraction of the large spheres alone, friction {}.", mu),
                       std::move(large)});
    figures.push_back(
        {fmt::format("phi_small_friction_{}", mu),
         fmt::format(
             "Packing fraction of the small spheres in the room that the large ones leave, friction {}.", mu),
         std::move(small)});
  }
}

Chart over_frictions(const Study& study, std::string y) {
  Chart chart;
  chart.x.title = "μ";
  double most = 0.1;
  for (const Point& p : study.points) most = std::max(most, p.friction);
  // Bars on the frame would not be seen.
  chart.x.low = -0.05 * most;
  chart.x.high = 1.05 * most;
  chart.y.title = std::move(y);
  return chart;
}

/// A quantity of the model against friction, for the frictions with a known phi_mono.
Series model_points(const Study& study, std::string name, LineStyle line,
                    Interval (*value)(const FurnasInterval&)) {
  Series s{std::move(name)};
  s.colour = black;
  s.line = line;
  for (const Point& mono : study.mono)
    add(s, mono.friction, value(*study.model(mono.friction)), mono.too_thin());
  return s;
}

void add_maxima(const Study& study, std::vector<Figure>& figures) {
  Chart phi = over_frictions(study, "φ_{max}"), f = over_frictions(study, "f_{max}");
  phi.series.push_back(
      model_points(study, "model", LineStyle::solid, [](const FurnasInterval& m) { return m.phi_max(); }));
  phi.series.push_back(model_points(study, "φ_{mono}", LineStyle::dotted, [](const FurnasInterval& m) {
    return Interval{m.middle().mono, m.phi(0).low, m.phi(0).high};
  }));
  phi.series.back().marker = Marker::wedge;
  f.series.push_back(
      model_points(study, "model", LineStyle::solid, [](const FurnasInterval& m) { return m.f_max(); }));
  const auto ratios = study.size_ratios();
  for (std::size_t n = 0; n < ratios.size(); ++n) {
    Series of_phi = measured(fmt::format("α = {}", ratios[n]), n);
    Series of_f = of_phi;
    for (const double mu : study.frictions()) {
      const Curve* curve = study.curve(ratios[n], mu);
      const auto m = curve ? maximum_of(*curve) : std::nullopt;
      if (!m) continue;
      const bool thin = curve->points[m->place].too_thin();
      add(of_phi, mu, m->phi_max, thin);
      add(of_f, mu, Interval{m->f_max, m->f_max_low, m->f_max_high}, thin);
    }
    if (of_phi.x.empty()) continue;
    phi.series.push_back(std::move(of_phi));
    f.series.push_back(std::move(of_f));
  }
  std::erase_if(phi.series, [](const Series& s) { return s.x.empty(); });
  std::erase_if(f.series, [](const Series& s) { return s.x.empty(); });
  if (!phi.series.empty())
    figures.push_back(
        {"figure_3a_phi_max", "Packing fraction of the densest mixture against friction.", std::move(phi)});
  if (!f.series.empty())
    figures.push_back({"figure_3b_f_max",
                       "Volume fraction of small spheres of the densest mixture against friction.",
                       std::move(f)});
}

/// The interval of a share, cut to 0 ... 1; a single sample has none.
Interval of_share(const MeanInterval& share) {
  if (share.samples < 2) return {share.mean, share.mean, share.mean};
  return {share.mean, std::max(share.low(), 0.0), std::min(share.high(), 1.0)};
}

void add_rattlers(const Study& study, std::vector<Figure>& figures) {
  const auto frictions = study.frictions();
  for (const double ratio : study.size_ratios()) {
    Chart chart = over_fractions("share of rattlers among the small spheres");
    chart.title = fmt::format("α = {}", ratio);
    chart.y.low = 0;
    for (std::size_t k = 0; k < frictions.size(); ++k) {
      const Curve* curve = study.curve(ratio, frictions[k]);
      if (curve == nullptr) continue;
      for (std::size_t n = 0; n < 3; ++n) {
        Series s = measured(fmt::format("μ = {}, fewer than {}", frictions[k], n + 2), k, lines[n]);
        for (const Point& p : curve->points)
          if (const auto& share = p.small_rattlers[n])
            add(s, p.small_fraction, of_share(*share), p.too_thin());
        if (!s.x.empty()) chart.series.push_back(std::move(s));
      }
    }
    figures.push_back({fmt::format("figure_4_rattlers_size_ratio_{}", ratio),
                       fmt::format("Share of rattlers among the small spheres, size ratio {}, for rattlers "
                                   "with fewer than 2, 3 and 4 live contacts.",
                                   ratio),
                       std::move(chart)});
  }
}

void add_history(const Study& study, std::vector<Figure>& figures) {
  if (study.history.empty()) return;
  const auto columns = read_history(study.history, {"Time", "Phi", "Press"});
  Chart chart;
  chart.x.title = "time / (ρ d_s^3/k_n)^{1/2}";
  chart.x.logarithmic = true;
  chart.y.title = "φ and p/p_a";
  chart.y.low = 0;
  chart.y.high = 1.5;
  Series phi{"φ"}, pressure{"p/p_a"};
  phi.colour = blue;
  pressure.colour = vermilion;
  pressure.line = LineStyle::dashed;
  const double applied =
      columns[2].empty() ? 1 : columns[2].back();  // at rest this pressure equals the applied pressure
  for (std::size_t k = 0; k < columns[0].size(); ++k) {
    if (!(columns[0][k] > 0)) continue;
    phi.x.push_back(columns[0][k]);
    phi.y.push_back(columns[1][k]);
    pressure.x.push_back(columns[0][k]);
    pressure.y.push_back(columns[2][k] / applied);
  }
  chart.series = {std::move(pressure), std::move(phi)};
  const auto point = study.history.parent_path().parent_path().filename().string();
  figures.push_back({"figure_1b_history",
                     fmt::format("Packing fraction and pressure against time of one sample ({}).", point),
                     std::move(chart)});
}

}  // namespace

std::vector<Figure> figures_of(const Study& study) {
  std::vector<Figure> figures;
  add_history(study, figures);
  add_curves(study, figures);
  add_maxima(study, figures);
  add_rattlers(study, figures);
  add_parts(study, figures);
  for (Figure& figure : figures) {
    explain_open(figure.chart);
    explain_bars(figure.chart);
  }
  return figures;
}

void explain_bars(Chart& chart) {
  for (const Series& s : chart.series)
    if (std::any_of(s.bars.begin(), s.bars.end(), [](const Bar& b) { return b.below > 0 || b.above > 0; })) {
      chart.title += chart.title.empty() ? "bars: 95 %" : "; bars: 95 %";
      return;
    }
}

Series open_symbol() {
  Series s{"open: cell too thin"};
  s.line = LineStyle::none;
  s.marker = Marker::circle;
  s.x = s.y = {std::nan("")};
  s.open = {true};
  return s;
}

std::string csv(const Chart& chart, const std::string& x, const std::string& y) {
  Table table({"series", x, y, "low", "high", "too_thin"});
  for (const Series& s : chart.series)
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      if (!std::isfinite(s.x[k])) continue;
      const Bar* const bar = s.bars.empty() ? nullptr : &s.bars[k];
      table.row({without_commas(s.name), fmt::format("{:.6g}", s.x[k]), fmt::format("{:.6g}", s.y[k]),
                 bar ? fmt::format("{:.6g}", s.y[k] - bar->below) : "",
                 bar ? fmt::format("{:.6g}", s.y[k] + bar->above) : "",
                 !s.open.empty() && s.open[k] ? "yes" : ""});
    }
  return table.csv();
}

}  // namespace furnas
