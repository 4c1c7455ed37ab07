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
  double step{};               ///< [t_c]
  std::optional<double> late;  ///< escape from the groove/that of a far shorter step - 1; nothing: it sticks
  double load{};               ///< largest force of a contact/that on the top; 1 at most is right
  double wedge{};              ///< angle up to which a wedge is held - atan mu [degrees]
};

/// E3: grooves with friction 0.5, wedges with friction 0.2.
std::vector<GrooveError> groove_errors(Effort effort);

PanelResult panel_of(const std::vector<GrooveError>& errors);

}  // namespace furnas
