#include "cases/program/bench/panels/groove_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/trials/groove.h"
#include "engine/trials/wedge.h"

namespace furnas {
namespace {

constexpr double groove_friction = 0.5, wedge_friction = 0.2;

template <class Law>
GrooveError error_at(const Groove& groove, double step, double reference) {
  const double dt = step * usual_collision_time();
  const Descent descent = descend<Law>(groove, dt);
  const WedgedSphere wedge{groove.size_ratio, wedge_friction};
  const double held = threshold_of(wedge, model_of<Law>({.friction = wedge_friction}, dt)).middle();
  GrooveError error{Law::name, groove.size_ratio,    step,
                    {},        descent.largest_load, (held - wedge.threshold()) / WedgedSphere::degree};
  if (descent.escaped) error.late = *descent.escaped / reference - 1;
  return error;
}

}  // namespace

std::vector<GrooveError> groove_errors(Effort effort) {
  const bool full = effort == Effort::full;
  const std::vector<double> ratios = full ? std::vector<double>{2, 5, 10, 20, 40} : std::vector<double>{10};
  const std::vector<double> steps =
      full ? std::vector<double>{0.02, 0.04, 0.063, 0.1} : std::vector<double>{0.02, 0.063};
  std::vector<GrooveError> errors;
  for (const double ratio : ratios) {
    const Groove groove{ratio, 1e-5, groove_friction};
    const Descent reference =
        descend<HookeSynchronized>(groove, steps.front() * usual_collision_time() / (full ? 16 : 2));
    if (!reference.escaped) throw std::runtime_error(fmt::format("size ratio {}: no escape at all", ratio));
    for (const double step : steps) {
      errors.push_back(error_at<HookeSynchronized>(groove, step, *reference.escaped));
      errors.push_back(error_at<HookeHistory>(groove, step, *reference.escaped));
    }
  }
  return errors;
}

PanelResult panel_of(const std::vector<GrooveError>& errors) {
  Table table({"law", "size_ratio", "time_step", "escape_late", "largest_load", "wedge_degrees_off"});
  Chart chart;
  chart.x.title = "size ratio α";
  chart.y.title = "escape from the groove: |late| (1: it sticks)";
  chart.x.logarithmic = chart.y.logarithmic = true;
  for (const GrooveError& e : errors) {
    table.row({e.law, panel_cell(e.size_ratio), panel_cell(e.step), e.late ? panel_cell(*e.late) : "stuck",
               panel_cell(e.load), panel_cell(e.wedge)});
    const bool legacy = e.law == HookeHistory::name;
    Series fresh{fmt::format("{}, {} t_c", legacy ? "hooke history" : "hooke synchronized", e.step)};
    fresh.colour = series_colours[(chart.series.size() / 2) % series_colours.size()];
    fresh.line = legacy ? LineStyle::dashed : LineStyle::solid;
    fresh.marker = legacy ? Marker::square : Marker::circle;
    Series& s = series_named(chart, fresh);
    s.x.push_back(e.size_ratio);
    s.y.push_back(e.late ? std::abs(*e.late) : 1);
  }
  return {table, chart};
}

}  // namespace furnas
