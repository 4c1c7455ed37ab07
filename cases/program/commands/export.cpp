#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string_view>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/lammps_kit.h"
#include "cases/program/packing_source.h"
#include "engine/base/require.h"
#include "engine/protocol/protocol.h"
#include "io/atomic_file.h"
#include "io/formats.h"
#include "io/packing_csv.h"
#include "io/voxels.h"
#include "viz/solid_surface.h"

namespace furnas {
namespace {

struct ExportOptions {
  std::string source;
  std::optional<std::int64_t> frame;
  std::string format;
  std::string out;
  std::optional<double> edge;
  bool box = false;
};

/// Prints the size of a large file before it is written; throws OutputError if the disk has no room for it.
void announce(const std::string& what, double bytes, double memory, const std::string& out, Console console) {
  console.err << fmt::format("{}: {:.1f} MB in {}, {:.0f} MB of memory\n", what, bytes / 1e6, out,
                             memory / 1e6)
              << std::flush;
  std::error_code unknown;
  const auto folder = std::filesystem::absolute(out).parent_path();
  const auto space = std::filesystem::space(folder, unknown);
  if (!unknown && static_cast<double>(space.available) < bytes)
    throw OutputError(fmt::format("{}: needs {:.1f} MB and the disk has {:.1f} MB; allowed: a longer --edge",
                                  out, bytes / 1e6, static_cast<double>(space.available) / 1e6));
}

/// The edge of the grid: that of --edge, or a sixteenth of the smallest diameter.
double edge_of(const ExportOptions& options, const Packing& packing) {
  return options.edge.value_or(smallest_diameter(packing) / 16);
}

void export_voxels(const ExportOptions& options, const Packing& packing, const std::string& out,
                   Console console) {
  const VoxelPlan plan = plan_voxels(packing, edge_of(options, packing));
  const auto& n = plan.grid.points;
  const auto& h = plan.grid.spacing;
  announce(
      fmt::format("{} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} d_s", n[0], n[1], n[2], h.x, h.y, h.z),
      static_cast<double>(plan.bytes), plan.memory, out, console);
  write_voxels(plan, out);
}

void export_stl(const ExportOptions& options, const Packing& packing, const std::string& out,
                Console console) {
  const double edge = edge_of(options, packing);
  const SurfacePlan plan = plan_surface(packing, edge, options.box);
  announce(fmt::format("about {:.2g} triangles on a grid of {:.4g} d_s", plan.triangles, edge), plan.bytes,
           plan.memory, out, console);
  console.err << write_stl(plan, out) << " triangles\n";
}

/// Formats of solids, which are not formats of packings: the spheres cannot be read back.
struct SolidFormat {
  const char* name;
  const char* extension;
  void (*write)(const ExportOptions&, const Packing&, const std::string& out, Console);
};

constexpr SolidFormat solids[] = {{"stl", ".stl", export_stl}, {"voxels", ".mhd", export_voxels}};

/// Another word for FORMAT: the contacts alone, for scripts.
constexpr const char* contacts = "contacts";

void export_contacts(const ExportOptions& options, const std::string& out) {
  const Packing packing = packing_source(options.source, options.frame).packing;
  if (packing.contacts.empty())
    throw InputError(options.source +
                     ": contains no contacts; allowed for contacts: the folder of a run, or a checkpoint");
  make_folder_of(out);
  write_contacts_csv(packing, out);
}

const SolidFormat* solid_of(const std::string& name) {
  for (const SolidFormat& solid : solids)
    if (solid.name == name) return &solid;
  return nullptr;
}

void export_packing(const std::string& format, const Packing& packing, const std::string& out,
                    Console console) {
  write_packing(packing, format, out);
  remark_on_losses(packing, format, console.err);
}

/// Another word for FORMAT: a folder with all that LAMMPS needs.
constexpr const char* kit = "lammps";

std::string write_kit(const ExportOptions& o) {
  const PackingSource source = packing_source(o.source, o.frame);
  const auto c = case_about(source, o.source);
  if (!c)
    throw InputError(o.source +
                     ": contains no case, from which law, time step and pressure would follow; allowed for "
                     "lammps: the folder of a run, or a packing in it");
  std::string folder = o.out.empty() ? kit : o.out;
  write_lammps_kit(source.packing, *c, source.reached.size(), o.source, folder);
  return folder;
}

/// The names that the command knows: those of packings, and what else it writes.
std::vector<std::string_view> known_formats() {
  std::vector<std::string_view> all;
  for (const Format& format : formats())
    if (format.write) all.emplace_back(format.name);
  all.emplace_back(contacts);
  for (const SolidFormat& solid : solids) all.emplace_back(solid.name);
  all.emplace_back(kit);
  return all;
}

void require_known_format(const std::string& format) {
  const auto all = known_formats();
  if (std::find(all.begin(), all.end(), format) == all.end())
    throw InputError(fmt::format("'{}' is no format to write; allowed are {}", format, fmt::join(all, ", ")));
}

void require_solid_options_fit(const ExportOptions& options) {
  if (options.edge && !solid_of(options.format))
    throw InputError(fmt::format("--edge and {} exclude each other; allowed: stl, voxels", options.format));
  if (options.box && options.format != "stl")
    throw InputError(fmt::format("--box and {} exclude each other; allowed: stl", options.format));
}

}  // namespace

Command export_command() {
  auto options = std::make_shared<ExportOptions>();
  Command command;
  command.name = "export";
  command.does = "write a packing in another format, or all that LAMMPS needs to continue a run";
  command.example = "furnas export runs/first_packing stl --edge 0.1 --box";
  command.setup = [options](CommandLine& app) {
    add_packing_source(app, options->source, options->frame);
    app.add("FORMAT", options->format,
            names_of_written_formats() +
                "; contacts: the contacts as CSV; stl: the union of the spheres as triangles; voxels: a "
                "MetaImage of the periodic box, 1 in a sphere and 0 between spheres; lammps: a folder with "
                "data file, input deck and README")
        .required();
    app.add("--out", options->out,
            "file, or for lammps the folder; missing folders are made; default: packing with the format's "
            "extension");
    app.add("--edge", options->edge,
            "for stl and voxels: edge of the grid [d_s]; default: a sixteenth of the smallest diameter")
        .above_zero();
    app.flag("--box", options->box,
             "for stl: the part of the packing and its images within the periodic box, closed at the faces "
             "of the box; default: each sphere once and whole");
  };
  command.run = [options](Console console) {
    require_known_format(options->format);
    require_solid_options_fit(*options);
    remark_on_older_checkpoint(options->source, console.err);
    if (options->format == kit) {
      console.out << write_kit(*options) << '\n';
      return ExitCode::done;
    }
    if (options->format == contacts) {
      const std::string out = options->out.empty() ? "contacts.csv" : options->out;
      export_contacts(*options, out);
      console.out << out << '\n';
      return ExitCode::done;
    }
    const SolidFormat* solid = solid_of(options->format);
    const std::string extension =
        solid ? std::string(solid->extension) : std::string(extension_of(options->format));
    const std::string out = options->out.empty() ? "packing" + extension : options->out;
    const Packing packing = packing_source(options->source, options->frame).packing;
    make_folder_of(out);
    if (solid)
      solid->write(*options, packing, out, console);
    else
      export_packing(options->format, packing, out, console);
    console.out << out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
