#include "tests/cases/runs.h"

#include <nlohmann/json.hpp>
#include <sstream>

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
Command new_command();
Command schema_command();
Command info_command();

Answer furnas(const std::vector<std::string>& arguments) {
  const std::vector<Command> commands = {
      check_command(),  run_command(),    resume_command(), analyze_command(),   certify_command(),
      render_command(), export_command(), import_command(), replicate_command(), bench_command(),
      new_command(),    schema_command(), info_command()};
  std::ostringstream out;
  std::ostringstream err;
  const ExitCode code = run_program(commands, arguments, {out, err});
  return {code, out.str(), err.str()};
}

Answer Runs::run(const std::string& name, const std::vector<std::string>& set,
                 const std::vector<std::string>& options) const {
  std::vector<std::string> arguments{"run", path("case.toml"), "--out", path(name)};
  for (const std::string& assignment : set) arguments.insert(arguments.end(), {"--set", assignment});
  arguments.insert(arguments.end(), options.begin(), options.end());
  return furnas(arguments);
}

Answer Runs::resume(const std::string& name, const std::vector<std::string>& options) const {
  std::vector<std::string> arguments{"resume", path(name)};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return furnas(arguments);
}

nlohmann::json Runs::result(const std::string& name) const {
  return nlohmann::json::parse(content(folder_ / (name + "/result.json")));
}

std::size_t Runs::unfinished(const std::filesystem::path& run) {
  std::size_t count = 0;
  if (!std::filesystem::exists(run)) return count;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run))
    count += entry.path().extension() == ".tmp" || entry.path().extension() == ".lock";
  return count;
}

}  // namespace furnas
