#include "cases/program/bench/panels/trajectory_panel.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/simulation.h"
#include "engine/start/mixture.h"
#include "engine/trials/balls.h"

namespace furnas {
namespace {

constexpr double far_apart = 1e-3;  // [d_s]
constexpr double look_every = 0.8;  // [t_c]; a whole multiple of each time step

using Places = std::vector<Vec3<double>>;

Packing colliding_gas(std::int64_t count) {
  Packing p = dilute_start({.large = count, .start_fraction = 0.3, .seed = 3});
  std::mt19937_64 random(3);
  std::normal_distribution<double> speed(0, 0.03);
  for (Vec3<double>& v : p.velocity) v = {speed(random), speed(random), speed(random)};
  return p;
}

/// All positions at each time of comparison.
std::vector<Places> trajectory(const Packing& start, double step, Precision precision, int threads,
                               int looks) {
  Model model = model_of<HookeSynchronized>({.normal_damping = 0, .tangential_damping = 0, .friction = 0.3},
                                            step * usual_collision_time());
  model.precision = precision;
  const auto simulation = make_simulation(model, start, threads);
  std::vector<Places> all;
  for (int n = 0; n < looks; ++n) {
    simulation->advance(std::llround(look_every / step));
    const Packing now = simulation->packing();
    Places places;
    for (std::size_t k = 0; k < now.size(); ++k) places.push_back(now.unwrapped(k));
    all.push_back(std::move(places));
  }
  return all;
}

double distance(const Places& a, const Places& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, norm(a[k] - b[k]));
  return largest;
}

void compare_with(const std::vector<Places>& right, const std::vector<Places>& is, TrajectoryError& error) {
  for (std::size_t n = 0; n < is.size() && !error.ever; ++n) {
    error.parted = look_every * static_cast<double>(n + 1);
    error.ever = distance(is[n], right[n]) > far_apart;
  }
  error.largest = distance(is.back(), right.back());
}

}  // namespace

std::vector<TrajectoryError> trajectory_errors(Effort effort) {
  const bool full = effort == Effort::full;
  const int looks = full ? 500 : 75;
  const Packing start = colliding_gas(full ? 200 : 60);
  const std::vector<double> steps =
      full ? std::vector<double>{0.01, 0.02, 0.04, 0.08} : std::vector<double>{0.02, 0.08};
  const auto right = trajectory(start, steps.front() / 8, Precision::full, 1, looks);
  std::vector<TrajectoryError> errors;
  for (const Precision precision : {Precision::full, Precision::mixed})
    for (const double step : steps) {
      TrajectoryError e{name_of(precision), 1, step, "a short step", 0, false, 0};
      const auto one = trajectory(start, step, precision, 1, looks);
      compare_with(right, one, e);
      errors.push_back(e);
      if (step != 0.02) continue;
      e = {e.precision, 2, step, "1 thread", 0, false, 0};
      compare_with(one, trajectory(start, step, precision, 2, looks), e);
      errors.push_back(e);
    }
  return errors;
}

PanelResult panel_of(const std::vector<TrajectoryError>& errors) {
  Table table({"precision", "threads", "time_step", "against", "parted_after", "ever", "largest_at_end"});
  Chart chart;
  chart.x.title = "time step/t_c";
  chart.y.title = "time until positions are 10^{-3} d_s apart [t_c]";
  chart.x.logarithmic = chart.y.logarithmic = true;
  Series series[] = {{"double"}, {"mixed"}, {"2 threads against 1: never (end of the run)"}};
  for (std::size_t n = 0; n < 3; ++n) {
    series[n].colour = series_colours[n];
    series[n].marker = n == 0 ? Marker::circle : n == 1 ? Marker::diamond : Marker::cross;
    if (n == 2) series[n].line = LineStyle::none;
  }
  for (const TrajectoryError& e : errors) {
    table.row({e.precision, std::to_string(e.threads), panel_cell(e.step), e.against, panel_cell(e.parted),
               e.ever ? "yes" : "no", panel_cell(e.largest)});
    Series& s = series[e.threads > 1 ? 2 : e.precision == "double" ? 0 : 1];
    s.x.push_back(e.step);
    s.y.push_back(e.parted);
  }
  for (Series& s : series) chart.series.push_back(std::move(s));
  return {table, chart};
}

}  // namespace furnas
