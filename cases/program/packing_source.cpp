#include "cases/program/packing_source.h"

#include <fmt/format.h>

#include <limits>
#include <ostream>

#include "cases/program/run/recording.h"
#include "cases/program/run/run_folder.h"
#include "engine/base/require.h"
#include "engine/simulation.h"
#include "io/case_file.h"
#include "io/formats.h"
#include "io/text_reader.h"

namespace furnas {

namespace fs = std::filesystem;

namespace {

PackingSource source_from(Checkpoint checkpoint, const std::string& name) {
  PackingSource source{std::move(checkpoint.packing), {}, resting_states_of(checkpoint)};
  if (!checkpoint.case_text.empty())
    source.of_case = parse_case(checkpoint.case_text, name + " (checkpoint)");
  return source;
}

}  // namespace

PackingSource packing_source(const std::string& name, std::optional<std::int64_t> frame) {
  if (frame && fs::is_directory(name))
    throw InputError(fmt::format("--frame {}: {} is the folder of a run; allowed: a file with several frames",
                                 *frame, name));
  if (fs::is_directory(name)) return source_from(Checkpoints::read_newest(name), name);
  if (is_checkpoint(name) && !frame) return source_from(read_checkpoint(name), name);
  return {read_packing(name, frame), {}, {}};
}

void remark_on_older_checkpoint(const std::string& name, std::ostream& out) {
  if (fs::is_directory(name) || !fs::exists(name) || !is_checkpoint(name)) return;
  if (const auto newer = Checkpoints::newer_than(name))
    out << "furnas: " << name << " is the older of two checkpoints; " << newer->filename().string()
        << " is newer. To use the newest, give the folder instead of the file\n";
}

void add_packing_source(CommandLine& app, std::string& name, std::optional<std::int64_t>& frame) {
  app.add("DIR or FILE", name, "folder of a run, or a packing in any format").required();
  add_frame(app, frame);
}

void add_frame(CommandLine& app, std::optional<std::int64_t>& frame) {
  app.add("--frame", frame,
          "number of the frame in a file with several (LAMMPS dump, extended XYZ), from 1; default: the last")
      .between(1, std::numeric_limits<int>::max());
}

void remark_on_losses(const Packing& packing, std::string_view format, std::ostream& out) {
  if (const std::string lost = lost_in(packing, format); !lost.empty())
    out << "furnas: " << format << " cannot store " << lost << ": left out\n";
}

fs::path folder_about(const std::string& folder_or_file, const std::string& wanted) {
  const fs::path source = folder_or_file;
  const fs::path own = fs::is_directory(source) ? source : source.parent_path();
  fs::path folder = !wanted.empty() ? fs::path(wanted) : own.empty() ? fs::path(".") : own;
  make_folder(folder);
  return folder;
}

void make_folder_of(const fs::path& file) {
  if (file.has_parent_path()) make_folder(file.parent_path());
}

std::optional<Case> case_about(const PackingSource& source, const std::string& folder_or_file) {
  if (source.of_case) return source.of_case;
  const fs::path folder = fs::absolute(folder_or_file).parent_path();
  for (const fs::path& of_run : {fs::path(folder_or_file), folder, folder.parent_path()})
    if (const fs::path file = of_run / "case.resolved.toml"; fs::exists(file))
      return parse_case(read_file(file), file.string());  // the start that the case names may be gone
  return {};
}

Packing packing_from(const std::string& name) { return packing_source(name).packing; }

Packing with_overlaps_as_contacts(const Packing& packing) {
  Packing resting = packing;
  resting.cell.rate = {};
  resting.order.clear();  // so that the forces are computed from the positions
  Model model;
  model.law = Frictionless<false>{{.normal_damping = 0}};
  model.barostat.freedom = CellFreedom::fixed;
  return make_simulation(model, resting)->packing();
}

}  // namespace furnas
