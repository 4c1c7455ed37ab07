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
  double mono = 0, half_width = 0, step = 0.05;
  std::optional<double> friction;
  std::vector<std::string> sweeps;
  std::string out;
};

FurnasInterval model_of_phi_mono(double mono, double half_width) {
  if (!(mono - half_width > 0 && mono + half_width < 1))
    throw InputError(
        fmt::format("--phi-mono {} --half-width {}: allowed: an interval in (0, 1)", mono, half_width));
  return {mono, half_width};
}

/// The frictions of which the sweeps have equal spheres.
std::vector<double> frictions_of(const Study& study) {
  std::vector<double> frictions;
  for (const Point& point : study.mono) frictions.push_back(point.friction);
  return frictions;
}

FurnasInterval model_of_sweeps(const Study& study, const std::string& sweep, double friction) {
  if (const auto model = study.model(friction)) return *model;
  const std::vector<double> known = frictions_of(study);
  const std::string allowed =
      known.empty() ? "" : fmt::format("; allowed: --friction {}", fmt::join(known, ", "));
  throw InputError(
      fmt::format("there are no jammed samples of equal spheres with friction {}, from which the "
                  "model follows{}. To make them: {}, then add --sweep {}_mono_{}",
                  friction, allowed, command_for_equal_spheres(sweep, friction), sweep, friction));
}

/// That of the option, or the only friction of the sweeps.
double friction_of(const ModelOptions& o, const Study& study) {
  if (o.friction) return *o.friction;
  const std::vector<double> known = frictions_of(study);
  if (known.size() > 1)
    throw InputError(fmt::format("--friction is missing; allowed: {}", fmt::join(known, ", ")));
  return known.empty() ? 0 : known.front();
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
    app.add("--friction", options->friction,
            "mu of the samples of equal spheres; may be left out if the sweeps have only one")
        .needs(sweeps);
    app.add("--step", options->step, "step of f_s in the table").between(1e-4, 1.0).showing_default();
    app.add("--out", options->out, "file for the table, CSV");
  };
  command.run = [options](Console console) {
    if (options->mono == 0 && options->sweeps.empty())
      throw InputError("--phi-mono or --sweep is missing; allowed: one of them");
    const bool of_sweeps = !options->sweeps.empty();
    const Study study = of_sweeps ? study_of({options->sweeps.begin(), options->sweeps.end()}) : Study{};
    const double friction = friction_of(*options, study);
    const FurnasInterval model = of_sweeps ? model_of_sweeps(study, options->sweeps.front(), friction)
                                           : model_of_phi_mono(options->mono, options->half_width);
    if (of_sweeps) console.out << fmt::format("{:<9} {}\n", "friction", friction);
    const Interval mono = model.phi(0), f = model.f_max(), phi = model.phi_max();
    for (const auto& [name, value] : {std::pair{"phi_mono", mono}, {"f_max", f}, {"phi_max", phi}})
      console.out << fmt::format("{:<9} {:.5f} ({:.5f} to {:.5f})\n", name, value.value, value.low,
                                 value.high);
    if (of_sweeps) console.out << "in brackets: 95 % intervals\n";
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
