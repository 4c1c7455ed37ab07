#include "cases/program/bench/panels/collision_panel.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/trials/collision.h"

namespace furnas {
namespace {

constexpr double small_radius = 0.5;

/// A kind of collision: initial velocities, and the quantity to measure.
struct CollisionKind {
  const char* quantity;
  double friction;
  double normal_speed, tangential_speed;
  double expected;
  double (*found)(const Rebound& rebound);  ///< in units of the normal speed 1
};

/// Speeds are so small that overlaps and rotations of the normal are negligible.
std::array<CollisionKind, 4> collision_kinds() {
  const double damping = HookeConstants{}.normal_damping;
  const double mass = reduced_mass_of(small_radius, small_radius);
  const HeadOn head_on{damping, mass};
  const double impulse = 0.05 * mass * head_on.absolute_impulse();  // for friction 0.05 and a unit speed
  return {
      {{"restitution", 0.3, 1e-3, 0, head_on.restitution(), [](const Rebound& r) { return r.normal / 1e-3; }},
       {"slip stuck", 1e30, 1e-5, 1e-5, Sticking::of(damping, mass).slip(head_on.duration()),
        [](const Rebound& r) { return r.slip / 1e-5; }},
       {"slip sliding", 0.05, 1e-4, 1e-4, 1 - 3.5 * impulse / mass,
        [](const Rebound& r) { return r.slip / 1e-4; }},
       {"spin sliding", 0.05, 1e-4, 1e-4, small_radius * impulse / inertia_of(small_radius),
        [](const Rebound& r) { return r.spin_i / 1e-4; }}}};
}

CollisionError error_of(const CollisionKind& kind, Model model) {
  CollisionError error{{}, {}, {}, kind.quantity, kind.expected, 0, 0};
  const std::vector<Rebound> all =
      rebounds(model, kind.normal_speed, kind.tangential_speed, small_radius, small_radius);
  for (const Rebound& r : all) {
    const double off = kind.found(r) / kind.expected - 1;
    error.mean += off / static_cast<double>(all.size());
    error.rms += off * off / static_cast<double>(all.size());
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

}  // namespace

std::vector<CollisionError> collision_errors(Effort effort) {
  const std::vector<double> divisions = effort == Effort::full
                                            ? std::vector<double>{12, 25, 50, 100, 200, 400, 800}
                                            : std::vector<double>{25, 50, 100};
  std::vector<CollisionError> errors;
  for (const CollisionKind& kind : collision_kinds())
    for (const bool legacy : {false, true})
      for (const Precision precision : {Precision::full, Precision::mixed})
        for (const double steps : divisions) {
          const HookeConstants constants{.friction = kind.friction};
          const double step = usual_collision_time() / steps;
          Model model =
              legacy ? model_of<HookeHistory>(constants, step) : model_of<HookeSynchronized>(constants, step);
          model.precision = precision;
          CollisionError error = error_of(kind, model);
          error.law = legacy ? HookeHistory::name : HookeSynchronized::name;
          error.precision = name_of(precision);
          error.steps = steps;
          errors.push_back(error);
        }
  return errors;
}

PanelResult panel_of(const std::vector<CollisionError>& errors) {
  Table table({"law", "precision", "steps_per_collision", "quantity", "expected", "mean_error", "rms_error"});
  Chart chart;
  chart.x.title = "steps in a collision, t_c/dt";
  chart.y.title = "rms error over phases of entry and exit";
  chart.x.logarithmic = chart.y.logarithmic = true;
  for (const CollisionError& e : errors) {
    table.row({e.law, e.precision, panel_cell(e.steps), e.quantity, fmt::format("{:.8g}", e.expected),
               panel_cell(e.mean), panel_cell(e.rms)});
    if (e.precision != "double") continue;
    const bool legacy = e.law == HookeHistory::name;
    const std::string name = e.quantity + (legacy ? ", hooke history" : "");
    if (chart.series.empty() || chart.series.back().name != name) {
      Series s{name};
      s.colour = series_colours[(chart.series.size() / 2) % series_colours.size()];
      s.line = legacy ? LineStyle::dashed : LineStyle::solid;
      s.marker = legacy ? Marker::square : Marker::circle;
      chart.series.push_back(s);
    }
    chart.series.back().x.push_back(e.steps);
    chart.series.back().y.push_back(e.rms);
  }
  return {table, chart};
}

}  // namespace furnas
