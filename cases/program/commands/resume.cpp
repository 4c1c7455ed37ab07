#include <fmt/format.h>

#include <memory>

#include "cases/program/commands/command.h"
#include "cases/program/run/run_case.h"
#include "cases/program/run/run_folder.h"

namespace furnas {
namespace {

struct ResumeOptions {
  std::string folder;
  std::string walltime;
  std::optional<int> threads;
  std::optional<std::int64_t> steps, more;
  std::optional<double> phi_error;
};

}  // namespace

Command resume_command() {
  auto options = std::make_shared<ResumeOptions>();
  Command command;
  command.name = "resume";
  command.does = "continue a stopped run";
  command.example = "furnas resume runs/first_packing --threads 2";
  command.setup = [options](CommandLine& app) {
    app.add("DIR", options->folder, "folder of the run").required();
    app.add("--walltime", options->walltime, "stop and save after e.g. 90s, 30m, 2h or 1d");
    app.add("--threads", options->threads, "compute.threads");
    const Argument steps =
        app.add("--steps", options->steps, "new value of stop.steps, to extend a spent budget");
    app.add("--more", options->more, "number of steps beyond those already done")
        .above_zero()
        .excludes(steps);
    app.add("--phi-error", options->phi_error,
            "new value of stop.phi_error, to continue a settled run; 0: until it is at rest");
  };
  command.run = [options](Console console) {
    std::vector<std::string> set;
    if (options->threads) set.push_back("compute.threads=" + std::to_string(*options->threads));
    if (options->steps) set.push_back("stop.steps=" + std::to_string(*options->steps));
    if (options->phi_error) set.push_back(fmt::format("stop.phi_error={}", *options->phi_error));
    RunOrder order = order_to_resume(options->folder, set, options->more);
    if (!options->walltime.empty()) order.walltime = parse_duration(options->walltime);
    return run_case(std::move(order), console);
  };
  return command;
}

}  // namespace furnas
