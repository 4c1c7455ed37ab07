#include "cases/program/bench/panels/panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <ostream>

#include "cases/program/bench/panels/collision_panel.h"
#include "cases/program/bench/panels/conservation_panel.h"
#include "cases/program/bench/panels/contact_panel.h"
#include "cases/program/bench/panels/groove_panel.h"
#include "cases/program/bench/panels/threads_panel.h"
#include "cases/program/bench/panels/trajectory_panel.h"
#include "cases/program/chart_files.h"
#include "cases/program/run/run_folder.h"
#include "engine/protocol/protocol.h"
#include "io/atomic_file.h"

namespace furnas {

std::span<const Panel> panels() {
  static const std::array all{
      Panel{"collision", "error of restitution, slip and spin after an impact, by time step and law",
            [](Effort effort) { return panel_of(collision_errors(effort)); }},
      Panel{"contact", "error of an enduring contact: decay, frequency, shear modulus",
            [](Effort effort) { return panel_of(contact_errors(effort)); }},
      Panel{"groove", "a small sphere between two large ones: when it rolls out, at which angle it is held",
            [](Effort effort) { return panel_of(groove_errors(effort)); }},
      Panel{"conservation", "errors of energy, enthalpy and momentum in a packing in motion",
            [](Effort effort) { return panel_of(conservation_errors(effort)); }},
      Panel{"trajectory", "how long positions stay within 1e-3 d_s of those of a far shorter step",
            [](Effort effort) { return panel_of(trajectory_errors(effort)); }},
      Panel{"threads", "the speed of several threads, which must all give the same bits",
            [](Effort effort) { return panel_of(thread_rows(effort)); }},
  };
  return all;
}

void show_panel(const std::string& name, const PanelResult& result, const std::filesystem::path& folder,
                Console console) {
  make_folder(folder);
  write_file(folder / (name + ".csv"), result.table.csv());
  const std::vector<std::string> charts = write_chart(result.chart, folder, name, console);
  console.out << result.table.aligned()
              << fmt::format("files  {}: {}.csv {}\n", folder.string(), name, fmt::join(charts, " "));
}

std::string panel_cell(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

Series& series_named(Chart& chart, const Series& fresh) {
  for (Series& s : chart.series)
    if (s.name == fresh.name) return s;
  return chart.series.emplace_back(fresh);
}

const char* name_of(Precision precision) { return precision == Precision::full ? "double" : "mixed"; }

double usual_collision_time() { return time_unit_of(Protocol{}); }

}  // namespace furnas
