#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// A small sphere between two large ones.
struct GrooveError {
  std::string law;
  double size_ratio{};
  double step{};  ///< [t_c]
  std::optional<double>
      late;        ///< time of escape over that with a far shorter step, minus 1; empty: it sticks
  double load{};   ///< largest contact force over the force on top; correct: at most 1
  double wedge{};  ///< largest angle of a wedge that is held, minus atan mu [degrees]
};

/// Errors in the panel `groove`: grooves with friction 0.5, wedges with friction 0.2.
std::vector<GrooveError> groove_errors(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<GrooveError>& errors);

}  // namespace furnas
