#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/table.h"
#include "engine/model.h"
#include "viz/chart.h"

namespace furnas {

/// One comparison of speed or error: a table and a chart.
struct PanelResult {
  Table table;  ///< with all digits
  Chart chart;
};

/// How much work a panel does.
enum class Effort {
  quick,  ///< about a second: enough to check orders of convergence and closed forms
  full    ///< some minutes
};

/// A panel of `furnas bench`.
struct Panel {
  std::string name;  ///< of the subcommand and of the panel's files
  std::string does;
  PanelResult (*make)(Effort effort);
};

/// All panels that need no packing as input.
std::span<const Panel> panels();

/// Writes NAME.csv, NAME.svg and NAME.png into the folder and prints the table. Throws InputError,
/// OutputError.
void show_panel(const std::string& name, const PanelResult& result, const std::filesystem::path& folder,
                Console console);

/// A cell of a table: all significant digits; empty if the number is not known.
std::string panel_cell(double value);

/// The curve of the chart that has the name of `fresh`; `fresh` becomes that curve if there is none yet.
Series& series_named(Chart& chart, const Series& fresh);

/// "mixed" or "double", as in compute.precision.
const char* name_of(Precision precision);

/// The collision time t_c of two small spheres with the default damping [time].
double usual_collision_time();

}  // namespace furnas
