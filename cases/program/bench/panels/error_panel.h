#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/force_error.h"
#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// Errors of the forces of one packing in one precision, relative to long double.
struct ForceErrorRow {
  std::string packing;
  std::size_t particles{};
  double friction{};
  std::string precision;
  ForceError error;
};

/// The panel of force errors. It needs packings as input, so `furnas bench error` makes it.
PanelResult panel_of(const std::vector<ForceErrorRow>& rows);

}  // namespace furnas
