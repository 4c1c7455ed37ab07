#include "cases/program/sweep/base_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/require.h"
#include "io/case_file.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// The case of the first sample in the order of the folders; empty without samples.
fs::path case_of_a_sample(const fs::path& folder) {
  const std::vector<fs::path> files = resolved_cases_in(folder);
  return files.empty() ? fs::path() : files.front();
}

}  // namespace

std::string base_case_text(const std::vector<Sample>& samples, const std::vector<std::string>& keys) {
  return fmt::format("# The case of all samples of this sweep, but for the seed and {}.\n{}",
                     fmt::join(keys, ", "), resolved_toml(samples.front().resolved_case));
}

std::optional<Case> read_base_case(const fs::path& folder) {
  fs::path file = folder / base_case_name;
  if (!fs::exists(file)) file = case_of_a_sample(folder);
  if (file.empty()) return {};
  try {
    return parse_case(read_file(file), file.string());  // a start.file may be gone by now
  } catch (const InputError&) {
    return {};
  }
}

bool bears_on_phi_J(const Key& key) {
  return !key.table.empty() && key.table != "output" && key.table != "compute" && !changes_no_bit(key) &&
         key.path() != "mixture.seed" && key.path() != "mixture.large";
}

}  // namespace furnas
