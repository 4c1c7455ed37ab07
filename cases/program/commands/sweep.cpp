#include "cases/program/sweep/sweep.h"

#include <memory>

#include "engine/base/parallel.h"

namespace furnas {

Command sweep_command() {
  struct Options {
    std::string file, out;
    std::vector<std::string> set;
    int jobs = available_threads();
    int samples = 0;
    bool refine = false;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "sweep";
  command.does = "run the samples of a case with [sweep], several at once; again: go on with it";
  command.example = "furnas sweep cases/study/smoke.toml --out runs/smoke";
  command.setup = [options](CommandLine& app) {
    app.add("CASE", options->file, "case file with [sweep], or any with --samples").required();
    app.add("--out", options->out, "folder for the samples and tables; default: runs/<case>");
    app.add("--set", options->set, "change a key of the case that the sweep leaves alone");
    app.add("--jobs", options->jobs, "threads of all samples together; default: all of the machine")
        .between(1, 1024);
    app.add("--samples", options->samples, "seeds at each point, instead of sweep.samples")
        .between(1, 100'000);
    app.flag("--refine", options->refine,
             "add points around the maximum of each phi_J(f_s), until f_max is known to +-0.01");
  };
  command.run = [options](Console console) {
    const bool one_point = options->samples > 0 && !holds_sweep(options->file);
    SweepOrder order{
        one_point ? sweep_of_one_point(options->file, options->set) : read_sweep(options->file, options->set),
        options->out, options->jobs, options->refine};
    if (order.folder.empty())
      order.folder = std::filesystem::path("runs") / std::filesystem::path(options->file).stem();
    if (options->samples > 0)
      for (SweepGrid& grid : order.file.grids) grid.samples = options->samples;
    return run_sweep(order, console);
  };
  return command;
}

}  // namespace furnas
