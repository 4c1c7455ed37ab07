#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cases/program/program.h"
#include "tests/io/packings.h"

namespace furnas {

/// What a command answered.
struct Answer {
  ExitCode code;
  std::string out, err;
};

/// Runs a command of the program in this process.
Answer furnas(const std::vector<std::string>& arguments);

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
drag = 0.0
time_step = 0.02
[stop]
stress_error = 1e-2
force_imbalance = 1e-2
kinetic_energy = 1e-8
strain_drift = 1e-3
window = 20
steps = 200_000
[output]
history_every = 100
picture = "none"
)";

  explicit Runs(const std::string& text = soft_case) { write_file(path("case.toml"), text); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the case into the folder `name` with `set` in its place.
  Answer run(const std::string& name, const std::vector<std::string>& set = {},
             const std::vector<std::string>& options = {}) const;
  Answer resume(const std::string& name, const std::vector<std::string>& options = {}) const;
  /// What the run of this name has written into its result.json.
  nlohmann::json result(const std::string& name) const;
  std::size_t files() const { return folder_.files(); }

  /// Files in the folder of a run that nobody finished or gave back.
  static std::size_t unfinished(const std::filesystem::path& run);

 private:
  TemporaryFolder folder_;
};

}  // namespace furnas
