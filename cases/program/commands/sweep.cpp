#include "cases/program/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <ostream>

#include "cases/program/run/progress.h"
#include "cases/program/run/run_folder.h"
#include "cases/program/shell_word.h"
#include "cases/program/sweep/slurm.h"
#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  std::string file, out, takeover, walltime, partition;
  std::vector<std::string> set;
  std::optional<int> jobs;
  int samples = 0;
  bool refine = false, leave = false, slurm = false;
};

/// The assignment with the whole path if it names a file; `base` is the case with all assignments.
std::string from_anywhere(const std::string& assignment, const Case& base) {
  const std::string key = assignment.substr(0, assignment.find_first_of(" ="));
  if (key == "start.file") return key + "=" + fs::absolute(base.start.file).lexically_normal().string();
  if (key == "mixture.diameters")
    return key + "=" + fs::absolute(base.mixture.diameters).lexically_normal().string();
  return assignment;
}

/// The command line of a worker, which also works from another current directory.
std::vector<std::string> command_of(const SweepOptions& o, const Case& base, const fs::path& folder) {
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string(), "sweep",
                                 fs::absolute(o.file).lexically_normal().string(), "--out", folder.string()};
  for (const std::string& assignment : o.set)
    words.insert(words.end(), {"--set", from_anywhere(assignment, base)});
  if (o.samples > 0) words.insert(words.end(), {"--samples", std::to_string(o.samples)});
  if (o.refine) words.emplace_back("--refine");
  if (!o.takeover.empty()) words.insert(words.end(), {"--takeover", o.takeover});
  return words;
}

/// Writes the script that runs the sweep in Slurm, and prints how to submit it.
ExitCode write_slurm(const SweepOptions& o, const SweepOrder& order, Console console) {
  const fs::path folder = fs::absolute(order.folder).lexically_normal();
  std::vector<Sample> samples = samples_of(order.file, keys_of(order.file), folder);
  const std::size_t all = samples.size();
  std::erase_if(samples, [](const Sample& s) { return state_of(s) == SampleState::finished; });
  const SlurmWishes wishes{o.partition, o.jobs, order.walltime};
  const SlurmArray array = array_for(samples, wishes);
  make_folder(folder);
  const fs::path script = folder / "sweep.sbatch";
  write_file(script, slurm_script(array, wishes, command_of(o, order.file.base, folder), folder));
  console.out << fmt::format(
      "array    {} task{} of {} core{}, {:.2f} GB and {}, for {} of {} samples\n"
      "script   {}\n"
      "submit   sbatch {}\n",
      array.tasks, array.tasks == 1 ? "" : "s", array.cores, array.cores == 1 ? "" : "s", array.memory / 1e9,
      duration_text(std::chrono::duration<double>(array.time).count()), samples.size(), all, script.string(),
      shell_word(script.string()));
  return ExitCode::done;
}

}  // namespace

Command sweep_command() {
  auto options = std::make_shared<SweepOptions>();
  Command command;
  command.name = "sweep";
  command.does =
      "run the samples of a case with [sweep], several at once; the same command again continues it or helps";
  command.example = "furnas sweep cases/study/smoke.toml --out runs/smoke";
  command.setup = [options](CommandLine& app) {
    app.add("CASE", options->file, "case file with [sweep], or any with --samples").required();
    app.add("--out", options->out, "folder for the samples and tables; default: runs/<case>");
    app.add("--set", options->set, "change a key of the case that the sweep does not set");
    app.add("--jobs", options->jobs, "threads of all samples together; default: all of the machine")
        .between(1, 1024);
    app.add("--samples", options->samples, "number of seeds at each point, instead of sweep.samples")
        .between(1, 100'000);
    app.flag("--refine", options->refine,
             "add points around the maximum of each phi_J(f_s), until f_max is known to +-0.01");
    app.add("--walltime", options->walltime, "save all samples and stop after e.g. 90s, 30m, 2h or 1d");
    app.flag("--leave", options->leave,
             "end when other workers on the folder run all samples that are left; default: wait, and take "
             "over the samples of lost workers");
    app.add(
        "--takeover", options->takeover,
        "time without a sign of life of this worker after which others may take its samples; default: 2m");
    const Argument slurm = app.flag(
        "--slurm", options->slurm,
        "run nothing, but write a job array for Slurm; --jobs and --walltime then apply to each task");
    app.add("--partition", options->partition, "partition of Slurm").needs(slurm);
  };
  command.run = [options](Console console) {
    const bool one_point = options->samples > 0 && !holds_sweep(options->file);
    SweepOrder order{.file = one_point ? sweep_of_one_point(options->file, options->set)
                                       : read_sweep(options->file, options->set),
                     .folder = options->out,
                     .jobs = options->jobs.value_or(available_threads()),
                     .refine = options->refine,
                     .walltime = {},
                     .waits = !options->leave};
    if (!options->walltime.empty()) order.walltime = parse_duration(options->walltime, "--walltime");
    if (!options->takeover.empty()) order.takeover = parse_duration(options->takeover, "--takeover");
    if (order.folder.empty()) order.folder = fs::path("runs") / fs::path(options->file).stem();
    if (options->samples > 0)
      for (SweepGrid& grid : order.file.grids) grid.samples = options->samples;
    return options->slurm ? write_slurm(*options, order, console) : run_sweep(order, console);
  };
  return command;
}

}  // namespace furnas
