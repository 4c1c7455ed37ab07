#include "cases/program/bench/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "cases/program/bench/packings.h"
#include "cases/program/case_templates.h"
#include "cases/program/packing_source.h"
#include "cases/program/replication.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/run_case.h"
#include "cases/program/run/run_folder.h"
#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

std::string_view case_text(double ratio) {
  const std::string wanted = "bench/" + benchmark_name(ratio);
  for (const CaseTemplate& known : case_templates())
    if (known.file == wanted) return known.text;
  throw InputError(fmt::format("--ratios {:g}: there is no case for it; allowed: {}", ratio,
                               fmt::join(benchmark_ratios(), ", ")));
}

/// The verdict of a run that has ended; empty if there is no result.
std::string verdict_in(const fs::path& folder) {
  std::ifstream file(folder / "result.json");
  const auto result = nlohmann::json::parse(file, nullptr, false);
  const auto verdict = result.is_object() ? result.find("verdict") : result.end();
  return verdict != result.end() && verdict->is_string() ? verdict->get<std::string>() : "";
}

ExitCode make(double ratio, const PrepareOrder& order, Console console) {
  const std::string text(case_text(ratio));
  const fs::path folder = fs::path(order.folder) / benchmark_name(ratio);
  if (verdict_in(folder) == "jammed") {
    console.out << fmt::format("{}: finished already\n", folder.string());
    return ExitCode::done;
  }
  const bool begun = !Checkpoints::none(folder);
  console.out << fmt::format("{}: {}\n", folder.string(), begun ? "continues" : "begins") << std::flush;
  RunOrder run;
  if (begun) {
    run = order_to_resume(folder, order.set);
  } else {
    const Case c = parse_case(text, "cases/bench/" + benchmark_name(ratio) + ".toml", order.set);
    validate(c);
    run = order_to_run(c);
    run.folder = std::make_unique<RunFolder>(RunFolder::create(folder.string(), {}));
  }
  if (!order.walltime.empty()) run.walltime = parse_duration(order.walltime);
  return run_case(std::move(run), console);
}

void write_repeated(double ratio, const PrepareOrder& order, Console console) {
  const fs::path folder = fs::path(order.folder) / benchmark_name(ratio);
  const PackingSource source = packing_source(folder.string());
  for (const double size : order.sizes) {
    const Times times = times_for(source.packing.size(), size);
    const std::size_t particles = source.packing.size() * copies_of(times);
    const fs::path file =
        fs::path(order.folder) / fmt::format("{}_{}.checkpoint", benchmark_name(ratio), particles);
    if (fs::exists(file)) {
      console.out << fmt::format("{}: there already\n", file.string());
      continue;
    }
    write_replicate(source, times, file);
    console.out << fmt::format("{}: {}\n", file.string(), text_of(times)) << std::flush;
  }
}

}  // namespace

ExitCode prepare_packings(const PrepareOrder& order, Console console) {
  for (const double ratio : order.ratios) case_text(ratio);
  ExitCode worst = ExitCode::done;
  for (const double ratio : order.ratios) {
    const ExitCode code = make(ratio, order, console);
    if (code == ExitCode::interrupted) return code;
    worst = std::max(worst, code);
    if (code != ExitCode::numerical_failure) write_repeated(ratio, order, console);
  }
  return worst;
}

}  // namespace furnas
