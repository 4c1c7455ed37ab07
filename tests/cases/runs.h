#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cases/program/program.h"
#include "tests/io/packings.h"

namespace furnas {
Command analyze_command();
Command check_command();
Command run_command();
Command resume_command();
Command certify_command();
Command render_command();
Command export_command();
Command import_command();
Command replicate_command();
Command bench_command();

/// What a command answered.
struct Answer {
  ExitCode code;
  std::string out, err;
};

/// Runs a command of the program in this process.
inline Answer furnas(const std::vector<std::string>& arguments) {
  const std::vector<Command> commands = {
      check_command(),  run_command(),    resume_command(), analyze_command(),   certify_command(),
      render_command(), export_command(), import_command(), replicate_command(), bench_command()};
  std::ostringstream out;
  std::ostringstream err;
  const ExitCode code = run_program(commands, arguments, {out, err});
  return {code, out.str(), err.str()};
}

/// A folder with a case, in which runs leave theirs.
class Runs {
 public:
  /// A case of so few and so soft spheres that it takes a second at most.
  static constexpr const char* soft_case = R"([mixture]
large = 100
start_fraction = 0.2
seed = 4
[contact]
friction = 0.3
[compaction]
pressure = 1e-3
[stop]
stress_error = 1e-2
force_imbalance = 1e-2
kinetic_energy = 1e-8
strain_drift = 1e-3
window = 1000
steps = 200_000
[output]
history_every = 100
picture = "none"
)";

  explicit Runs(const std::string& text = soft_case) { write_file(path("case.toml"), text); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the case into the folder `name` with `set` in its place.
  Answer run(const std::string& name, const std::vector<std::string>& set = {},
             const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"run", path("case.toml"), "--out", path(name)};
    for (const std::string& assignment : set) arguments.insert(arguments.end(), {"--set", assignment});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return furnas(arguments);
  }
  Answer resume(const std::string& name, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"resume", path(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return furnas(arguments);
  }
  nlohmann::json result(const std::string& name) const {
    return nlohmann::json::parse(content(folder_ / (name + "/result.json")));
  }
  std::size_t files() const { return folder_.files(); }

  /// Files in the folder of a run that nobody finished or gave back.
  static std::size_t unfinished(const std::filesystem::path& run) {
    std::size_t count = 0;
    if (!std::filesystem::exists(run)) return count;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(run))
      count += entry.path().extension() == ".tmp" || entry.path().extension() == ".lock";
    return count;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace furnas
