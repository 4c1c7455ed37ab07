#include "cases/run_folder.h"

#include <charconv>
#include <cmath>

#include "engine/base/require.h"

namespace furnas {
namespace fs = std::filesystem;

namespace {

fs::path first_free(const fs::path& wanted) {
  fs::path candidate = wanted;
  for (int n = 2; fs::exists(candidate); ++n) candidate = wanted.string() + "-" + std::to_string(n);
  return candidate;
}

}  // namespace

fs::path create_run_folder(const std::string& wanted, const fs::path& case_file) {
  fs::path folder = wanted.empty() ? first_free(fs::path("runs") / case_file.stem()) : fs::path(wanted);
  std::error_code error;
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder, error)))
    throw InputError(
        "--out " + folder.string() +
        ": already there and not empty; allowed: a new or empty folder (resume goes on with a run)");
  fs::create_directories(folder, error);
  if (error) throw InputError("cannot make the folder " + folder.string() + ": " + error.message());
  return folder;
}

std::chrono::seconds parse_duration(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string unit(rest, end);
  const double scale = unit == "d"                   ? 86400
                       : unit == "h"                 ? 3600
                       : unit == "m"                 ? 60
                       : unit.empty() || unit == "s" ? 1
                                                     : 0;
  const double seconds = value * scale;
  if (error != std::errc{} || scale == 0 || !(seconds > 0) || seconds > 1e9)
    throw InputError("--walltime " + text + ": allowed: a positive time such as 90s, 30m, 2h or 1d");
  return std::chrono::seconds(static_cast<std::int64_t>(std::ceil(seconds)));
}

}  // namespace furnas
