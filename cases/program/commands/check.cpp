#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>

#include "cases/program/bench/tradeoff/known_bias.h"
#include "cases/program/commands/command.h"
#include "cases/program/preflight.h"
#include "cases/program/sweep/sweep.h"
#include "io/case_check.h"
#include "io/case_file.h"

namespace furnas {

Command check_command() {
  struct Options {
    std::string file;
    std::vector<std::string> set;
    std::optional<int> threads;
    std::optional<std::int64_t> seed;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "check";
  command.does = "say what a case would do, without running it";
  command.example = "furnas check cases/paper.toml";
  command.setup = [options](CommandLine& app) {
    app.add("CASE", options->file, "case file").required();
    app.add("--set", options->set, "change a key of the case, e.g. mixture.large=400");
    app.add("--threads", options->threads, "compute.threads");
    app.add("--seed", options->seed, "mixture.seed");
  };
  command.run = [options](Console console) {
    if (options->threads) options->set.push_back(fmt::format("compute.threads={}", *options->threads));
    if (options->seed) options->set.push_back(fmt::format("mixture.seed={}", *options->seed));
    if (holds_sweep(options->file)) {
      console.out << sweep_report(read_sweep(options->file, options->set));
      return ExitCode::done;
    }
    const Case c = read_case(options->file, options->set);
    validate(c);
    const Preflight preflight = check_case(c);
    console.out << preflight.report;
    for (const std::string& bias : known_biases(c)) console.out << "bias      " << bias << '\n';
    if (preflight.refusal.empty()) return ExitCode::done;
    console.err << "furnas: refused: " << preflight.refusal << '\n';
    return ExitCode::refused;
  };
  return command;
}

}  // namespace furnas
