#include "cases/program/bench/panels/contact_panel.h"

#include <cmath>

#include "engine/trials/crystal.h"
#include "engine/trials/row_of_two.h"

namespace furnas {
namespace {

/// Spacing in the crystal. The overlap is so small that the closed form, for zero overlap, is accurate to
/// 1e-4.
constexpr double neighbours_apart = 1 - 1e-4;

template <class Law>
ContactError error_at(double steps) {
  const double step = usual_collision_time() / steps;
  const double gamma = HookeConstants{}.normal_damping;
  const double w = std::sqrt(2 / RowOfTwo::reduced_mass() - gamma * gamma);
  // Over about four decay times.
  const Oscillation is = oscillation_of_row(model_of<Law>({}, step), static_cast<int>(8 / step));
  const Model stuck = model_of<Law>({.normal_damping = 0, .tangential_damping = 0, .friction = 1e30}, step);
  const double c44 = -stress_per_strain(stuck, face_centred(neighbours_apart, 1), {0, 0, 0, 1, 0, 0})(1, 2);
  return {Law::name, steps, is.decay / gamma - 1, is.frequency / w - 1,
          c44 / shear_modulus_of_face_centred(neighbours_apart) - 1};
}

}  // namespace

std::vector<ContactError> contact_errors(Effort effort) {
  const std::vector<double> divisions = effort == Effort::full
                                            ? std::vector<double>{12, 25, 50, 100, 200, 400, 800}
                                            : std::vector<double>{25, 50, 100, 200};
  std::vector<ContactError> errors;
  for (const double steps : divisions) errors.push_back(error_at<HookeSynchronized>(steps));
  for (const double steps : divisions) errors.push_back(error_at<HookeHistory>(steps));
  return errors;
}

PanelResult panel_of(const std::vector<ContactError>& errors) {
  Table table({"law", "steps_per_collision", "decay_error", "frequency_error", "c44_error"});
  Chart chart;
  chart.x.title = "steps in a collision, t_c/dt";
  chart.y.title = "|error|, relative";
  chart.x.logarithmic = chart.y.logarithmic = true;
  struct Line {
    const char* name;
    double ContactError::*error;
  };
  const Line lines[] = {{"decay", &ContactError::decay},
                        {"frequency", &ContactError::frequency},
                        {"C_{44} of a crystal", &ContactError::shear}};
  for (const ContactError& e : errors)
    table.row(
        {e.law, panel_cell(e.steps), panel_cell(e.decay), panel_cell(e.frequency), panel_cell(e.shear)});
  for (std::size_t n = 0; n < std::size(lines); ++n)
    for (const bool legacy : {false, true}) {
      Series s{lines[n].name + std::string(legacy ? ", hooke history" : "")};
      s.colour = series_colours[n];
      s.line = legacy ? LineStyle::dashed : LineStyle::solid;
      s.marker = legacy ? Marker::square : Marker::circle;
      for (const ContactError& e : errors)
        if ((e.law == HookeHistory::name) == legacy) {
          s.x.push_back(e.steps);
          s.y.push_back(std::abs(e.*lines[n].error));
        }
      chart.series.push_back(std::move(s));
    }
  return {table, chart};
}

}  // namespace furnas
