#include "cases/program/bench/panels/conservation_panel.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/monitor/energy.h"
#include "engine/simulation.h"
#include "engine/start/mixture.h"
#include "engine/trials/balls.h"

namespace furnas {
namespace {

/// A gas of two sizes under a hundred times the usual pressure of the bath.
struct SqueezedGas {
  Packing start;
  double time;

  explicit SqueezedGas(Effort effort)
      : start(dilute_start({.size_ratio = 3,
                            .small_fraction = 0.7,
                            .large = effort == Effort::full ? 20 : 5,
                            .start_fraction = 0.3,
                            .seed = 5})),
        time(effort == Effort::full ? 60 : 12) {}

  Model model(bool legacy, double step) const {
    const HookeConstants constants{.friction = 0.3};
    Model m;
    m.law = legacy ? AnyLaw(HookeHistory{constants}) : AnyLaw(HookeSynchronized{constants});
    m.barostat.pressure = 1e-2;
    m.barostat.inertia = inertia_of_cell(start);
    m.barostat.legacy = legacy;
    m.time_step = step;
    m.affine_velocity = true;
    return m;
  }
};

/// Spheres in flight, whose kinetic pressure is about the pressure of the bath.
Packing flying_gas(std::int64_t count) {
  Packing p = dilute_start({.large = count, .start_fraction = 0.25, .seed = 2});
  std::mt19937_64 random(2);
  std::normal_distribution<double> speed(0, 0.03);
  for (Vec3<double>& v : p.velocity) v = {speed(random), speed(random), speed(random)};
  const Vec3<double> drift = momentum(p) * (1 / p.sphere_volume());
  for (Vec3<double>& v : p.velocity) v -= drift;
  return p;
}

double momentum_error(const Packing& p) {
  double all = 0;
  for (std::size_t k = 0; k < p.size(); ++k) all += p.mass[k] * norm(p.velocity[k]);
  return norm(momentum(p)) / all;
}

double enthalpy_error(const Packing& start, Precision precision, double step, double time) {
  Model model = model_of<Frictionless<false>>({.normal_damping = 0}, step);
  model.precision = precision;
  model.barostat = {.pressure = 1e-3, .inertia = inertia_of_cell(start)};
  const auto simulation = make_simulation(model, start);
  const double first = kept_enthalpy(simulation->packing(), model.barostat);
  constexpr int looks = 100;
  const auto every = std::max<std::int64_t>(1, std::llround(time / looks / step));
  double square = 0;
  for (int n = 0; n < looks; ++n) {
    simulation->advance(every);
    const double off = kept_enthalpy(simulation->packing(), model.barostat) - first;
    square += off * off / looks;
  }
  return std::sqrt(square) / kinetic_energy(start);
}

}  // namespace

std::vector<ConservationError> conservation_errors(Effort effort) {
  const std::vector<double> steps = effort == Effort::full
                                        ? std::vector<double>{0.005, 0.01, 0.02, 0.04, 0.063, 0.1}
                                        : std::vector<double>{0.01, 0.02, 0.04};
  std::vector<ConservationError> errors;
  const SqueezedGas gas(effort);
  for (const bool legacy : {false, true})
    for (const Precision precision : {Precision::full, Precision::mixed})
      for (const double step : steps) {
        Model model = gas.model(legacy, step * usual_collision_time());
        model.precision = precision;
        const Packing end = after(model, gas.start, std::llround(gas.time / model.time_step));
        const std::string law = legacy ? HookeHistory::name : HookeSynchronized::name;
        const double gap = end.ledger.relative_gap(energy(end, model.law).total());
        errors.push_back({"energy ledger", law, name_of(precision), step, std::abs(gap)});
        errors.push_back({"momentum", law, name_of(precision), step, momentum_error(end)});
      }
  const Packing free = flying_gas(effort == Effort::full ? 200 : 60);
  for (const Precision precision : {Precision::full, Precision::mixed})
    for (const double step : steps)
      errors.push_back({"enthalpy", "frictionless", name_of(precision), step,
                        enthalpy_error(free, precision, step * usual_collision_time(),
                                       effort == Effort::full ? 400 : 60)});
  return errors;
}

PanelResult panel_of(const std::vector<ConservationError>& errors) {
  Table table({"quantity", "law", "precision", "time_step", "error"});
  Chart chart;
  chart.x.title = "time step/t_c";
  chart.y.title = "error, relative";
  chart.x.logarithmic = chart.y.logarithmic = true;
  for (const ConservationError& e : errors) {
    table.row({e.quantity, e.law, e.precision, panel_cell(e.step), panel_cell(e.error)});
    const bool legacy = e.law == HookeHistory::name;
    if (legacy && (e.precision == "mixed" || e.quantity == "momentum")) continue;
    Series fresh{e.quantity + ", " + (legacy ? "hooke history" : e.precision)};
    fresh.colour = series_colours[e.quantity == "momentum" ? 1 : e.quantity == "enthalpy" ? 2 : 0];
    fresh.line = legacy ? LineStyle::dotted : e.precision == "mixed" ? LineStyle::dashed : LineStyle::solid;
    fresh.marker = legacy ? Marker::square : e.precision == "mixed" ? Marker::diamond : Marker::circle;
    Series& s = series_named(chart, fresh);
    s.x.push_back(e.step);
    s.y.push_back(e.error);
  }
  return {table, chart};
}

}  // namespace furnas
