#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/preflight.h"
#include "cases/program/run/run_case.h"
#include "cases/program/run/run_folder.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/case_protocol.h"

namespace furnas {
namespace {

struct RunOptions {
  std::string file;
  std::vector<std::string> set;
  std::string out;
  std::string walltime;
  std::optional<int> threads;
  std::optional<std::int64_t> seed;
};

/// Placing 2.6e7 spheres takes a minute, during which there is no progress to show.
void announce_start(const Case& c, Console console) {
  constexpr double many = 1e6;
  if (!c.start.file.empty() || !c.mixture.diameters.empty()) return;
  const Mixture mixture = mixture_of(c);
  const double spheres = static_cast<double>(mixture.large) + small_count(mixture);
  if (spheres >= many) console.err << fmt::format("places {:.0f} spheres at random\n", spheres) << std::flush;
}

}  // namespace

Command run_command() {
  auto options = std::make_shared<RunOptions>();
  Command command;
  command.name = "run";
  command.does = "run a case to its verdict";
  command.example = "furnas run cases/first_packing.toml --set contact.friction=0.1 --threads 2";
  command.setup = [options](CommandLine& app) {
    app.add("CASE", options->file, "case file").required();
    app.add("--set", options->set, "change a key of the case, e.g. contact.friction=0.1");
    app.add("--out", options->out, "folder for the files; default: runs/<case>, numbered");
    app.add("--walltime", options->walltime, "stop and save after e.g. 90s, 30m, 2h or 1d");
    app.add("--threads", options->threads, "compute.threads");
    app.add("--seed", options->seed, "mixture.seed");
  };
  command.run = [options](Console console) {
    std::vector<std::string> set = options->set;
    if (options->threads) set.push_back(fmt::format("compute.threads={}", *options->threads));
    if (options->seed) set.push_back(fmt::format("mixture.seed={}", *options->seed));
    const Case c = read_case(options->file, set);
    validate(c);
    const auto walltime =
        options->walltime.empty() ? std::nullopt : std::optional(parse_duration(options->walltime));
    const Preflight preflight = check_case(c);
    if (!preflight.refusal.empty()) {
      console.err << "furnas: refused: " << preflight.refusal << '\n';
      return ExitCode::refused;
    }
    if (!preflight.remark.empty()) console.err << "furnas: " << preflight.remark << '\n';
    announce_start(c, console);
    RunOrder order = order_to_run(c);
    order.walltime = walltime;
    order.folder = std::make_unique<RunFolder>(RunFolder::create(options->out, options->file));
    return run_case(std::move(order), console);
  };
  return command;
}

}  // namespace furnas
