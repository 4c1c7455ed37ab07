#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "engine/state/species.h"
#include "io/formats.h"

namespace furnas {
namespace {

std::string spheres_text(const Packing& packing) {
  if (is_polydisperse(packing)) {
    const Sizes sizes = sizes_of(packing.radius);
    return fmt::format("{} sizes from {:.6g} to {:.6g} (polydisperse)", sizes.count, sizes.smallest,
                       sizes.largest);
  }
  std::size_t large = 0;
  for (Species s : packing.species) large += s == Species::large;
  return fmt::format("{} large", large);
}

void describe(const Packing& packing, Console console) {
  console.out << packing.size() << " particles, " << spheres_text(packing) << ", packing fraction "
              << packing.fraction_filled() << '\n';
  if (packing.labels.turned)
    console.out
        << "the cell was turned so that its first edge lies along x and its second in the plane of x and "
           "y, and all vectors with it\n";
}

/// The same packing in other units of length and mass; the unit of time stays.
void rescale(Packing& p, double length, double mass) {
  Triangle& h = p.cell.edges;
  for (double* edge : {&h.xx, &h.yy, &h.zz, &h.yz, &h.xz, &h.xy}) *edge *= length;
  p.labels.origin *= length;
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.radius[k] *= length;
    p.mass[k] *= mass;
    p.velocity[k] *= length;
    p.force[k] *= mass * length;
    p.torque[k] *= mass * length * length;
  }
  p.contacts.clear();  // their forces have other units
}

}  // namespace

Command import_command() {
  struct Options {
    std::string source;
    std::optional<std::int64_t> frame;
    std::string out;
    std::optional<double> scale, density;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "import";
  command.does = "read a packing, describe it and write it as a file from which a run can start";
  command.example = "furnas import packing.lammpstrj --out start.vtp";
  command.setup = [options](CommandLine& app) {
    app.add("FILE", options->source, "packing in one of: " + names_of_read_formats()).required();
    add_frame(app, options->frame);
    app.add("--out", options->out, "file to write, format by its extension; default: only describe");
    app.add("--scale", options->scale,
            "multiply all lengths by this number to get the unit d_s, the diameter of a small sphere: 1000 "
            "for a diameter of 0.001 m")
        .above_zero();
    app.add("--density", options->density,
            "density of the spheres in the units of the file, to get masses in rho d_s^3: for example 2500 "
            "for 2500 kg/m^3")
        .above_zero();
  };
  command.run = [options](Console console) {
    Packing packing = read_packing(options->source, options->frame);
    if (options->scale || options->density) {
      const double length = options->scale.value_or(1);
      rescale(packing, length, length * length * length / options->density.value_or(1));
    }
    describe(packing, console);
    if (options->out.empty()) return ExitCode::done;
    const std::string_view format = format_by_extension(options->out);
    make_folder_of(options->out);
    write_packing(packing, format, options->out);
    remark_on_losses(packing, format, console.err);
    console.out << options->out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
