#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/figures/gather.h"
#include "cases/program/figures/study.h"
#include "cases/program/packing_source.h"
#include "cases/program/table.h"
#include "engine/base/require.h"
#include "engine/statistics/furnas_model.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

struct ModelOptions {
  double mono = 0, half_width = 0, friction = 0, step = 0.05;
  std::vector<std::string> sweeps;
  std::string out;
};

FurnasInterval furnas_model_of(const ModelOptions& o) {
  if (o.sweeps.empty()) {
    if (!(o.mono - o.half_width > 0 && o.mono + o.half_width < 1))
      throw InputError(
          fmt::format("--phi-mono {} --half-width {}: allowed: an interval in (0, 1)", o.mono, o.half_width));
    return {o.mono, o.half_width};
  }
  const Study study = study_of({o.sweeps.begin(), o.sweeps.end()});
  if (const auto model = study.model(o.friction)) return *model;
  std::vector<double> known;
  for (const Point& point : study.mono) known.push_back(point.friction);
  throw InputError(fmt::format(
      "--friction {}: no jammed samples of equal spheres, from which the model follows; allowed: {}. To make "
      "them: {}, then add --sweep {}_mono_{}",
      o.friction, known.empty() ? "none of these sweeps" : fmt::format("{}", fmt::join(known, ", ")),
      command_for_equal_spheres(o.sweeps.front(), o.friction), o.sweeps.front(), o.friction));
}

std::string number(double value) { return fmt::format("{:.5f}", value); }

Table table_of(const FurnasInterval& model, double step) {
  Table table({"f_s", "phi", "low", "high", "phi_L", "phi_S"});
  const auto last = static_cast<int>(1 / step + 1e-9);
  for (int k = 0; k <= last; ++k) {
    const double f = k * step;
    const Interval phi = model.phi(f);
    table.row({fmt::format("{:.4g}", f), number(phi.value), number(phi.low), number(phi.high),
               number(fraction_of_large(phi.value, f)), number(fraction_in_voids(phi.value, f))});
  }
  return table;
}

}  // namespace

Command model_command() {
  auto options = std::make_shared<ModelOptions>();
  Command command;
  command.name = "model";
  command.does = "the generalized Furnas model: f_max, phi_max and phi(f_s), with intervals";
  command.example = "furnas model --phi-mono 0.588 --half-width 0.002";
  command.setup = [options](CommandLine& app) {
    const Argument mono =
        app.add("--phi-mono", options->mono, "packing fraction of spheres of one size, in (0, 1)");
    app.add("--half-width", options->half_width, "half of its interval").not_negative().needs(mono);
    const Argument sweeps =
        app.add("--sweep", options->sweeps, "folders of sweeps from which phi_mono is taken").excludes(mono);
    app.add("--friction", options->friction, "mu of the samples of equal spheres").needs(sweeps);
    app.add("--step", options->step, "step of f_s in the table").between(1e-4, 1.0).showing_default();
    app.add("--out", options->out, "file for the table, CSV");
  };
  command.run = [options](Console console) {
    if (options->mono == 0 && options->sweeps.empty())
      throw InputError("--phi-mono or --sweep is missing; allowed: one of them");
    const FurnasInterval model = furnas_model_of(*options);
    const Interval mono = model.phi(0), f = model.f_max(), phi = model.phi_max();
    for (const auto& [name, value] : {std::pair{"phi_mono", mono}, {"f_max", f}, {"phi_max", phi}})
      console.out << fmt::format("{:<9} {:.5f} ({:.5f} to {:.5f})\n", name, value.value, value.low,
                                 value.high);
    if (!options->sweeps.empty()) console.out << "in brackets: 95 % intervals\n";
    const Table table = table_of(model, options->step);
    console.out << '\n' << table.aligned();
    if (options->out.empty()) return ExitCode::done;
    make_folder_of(options->out);
    write_file(options->out, table.csv());
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
