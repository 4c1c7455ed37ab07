#include "cases/program/sweep/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cases/program/build_info.h"
#include "cases/program/expected_steps.h"
#include "cases/program/preflight.h"
#include "cases/program/run/recording.h"
#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/case_schema.h"
#include "io/case_words.h"
#include "io/csv.h"
#include "io/diameters_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

double particles_of(const Case& c) {
  if (!c.start.file.empty()) return static_cast<double>(start_of(c).size());
  if (!c.mixture.diameters.empty())
    return static_cast<double>(read_diameters(c.mixture.diameters).diameters.size());
  return static_cast<double>(c.mixture.large) + small_count(mixture_of(c));
}

/// A value in the form for names of folders and for tables. For a start.file it is the file's name with that
/// of its folder.
std::string value_in(const Case& c, const std::string& key) {
  const fs::path start = c.start.file;
  std::string value = key == start_key ? (start.parent_path().filename() / start.filename()).string()
                                       : value_text(*find_key(key), c);
  std::erase_if(value, [](char letter) { return letter == '"' || letter == '\'' || letter == ' '; });
  std::replace(value.begin(), value.end(), '/', '_');
  return without_commas(value);
}

/// The case as text, with keys that change no bit of the steps at their defaults.
std::string identity(Case c) {
  for (const Key& key : case_keys())
    if (changes_no_bit(key)) reset(key, c);
  return resolved_toml(c);
}

/// The same for any small_fraction.
std::string identity_of_curve(Case c) {
  c.mixture.small_fraction = 0;
  return identity(c);
}

/// Calls `visit` with the base case changed to each combination of one value of each axis.
template <class Visit>
void each_point(const SweepGrid& grid, const Case& c, Visit&& visit, std::size_t axis = 0) {
  if (axis == grid.axes.size()) return visit(c);
  for (const std::string& value : grid.axes[axis].values) {
    Case changed = c;
    apply_override(changed, grid.axes[axis].key + "=" + value);
    each_point(grid, changed, visit, axis + 1);
  }
}

void validate_point(const Case& c, const SweepGrid& grid) {
  try {
    validate(c);
  } catch (const InputError& error) {
    throw InputError(grid.place + ": " + error.what());
  }
  // Identical samples would look like independent samples that agree to all digits.
  if (!c.start.file.empty() && grid.samples > 1)
    throw InputError(fmt::format(
        "{}: samples = {}, but start.file = \"{}\" is the same start for every seed; allowed: samples = 1",
        grid.place, grid.samples, c.start.file));
}

}  // namespace

const std::vector<std::string>& keys_of_the_paper() {
  static const std::vector<std::string> keys{"mixture.size_ratio", fraction_key, "contact.friction"};
  return keys;
}

std::string name_in(const std::string& key) { return key.substr(key.find('.') + 1); }

std::vector<std::string> keys_of(const SweepFile& sweep) {
  std::vector<std::string> keys = keys_of_the_paper();
  const auto reads = [](const SweepGrid& grid) {
    return std::any_of(grid.axes.begin(), grid.axes.end(),
                       [](const SweepAxis& axis) { return axis.key == start_key; });
  };
  if (!sweep.base.start.file.empty() || !sweep.base.mixture.diameters.empty() ||
      std::any_of(sweep.grids.begin(), sweep.grids.end(), reads))
    keys = {"contact.friction"};  // a file determines the sizes
  std::map<std::string, std::set<std::string>> values;
  for (const SweepGrid& grid : sweep.grids)
    for (const SweepAxis& axis : grid.axes) values[axis.key].insert(axis.values.begin(), axis.values.end());
  for (const SweepGrid& grid : sweep.grids)
    for (const auto& [key, of_key] : values) {
      const bool named = std::any_of(grid.axes.begin(), grid.axes.end(),
                                     [&, &name = key](const SweepAxis& axis) { return axis.key == name; });
      // A grid that does not name a key takes it from the case.
      if ((of_key.size() > 1 || !named) && std::find(keys.begin(), keys.end(), key) == keys.end())
        keys.push_back(key);
    }
  return keys;
}

fs::path folder_of_sample(const std::vector<std::string>& keys, const std::vector<std::string>& values,
                          std::int64_t seed) {
  std::string point;
  for (std::size_t k = 0; k < keys.size(); ++k)
    point += fmt::format("{}{}={}", point.empty() ? "" : ",", name_in(keys[k]), values[k]);
  return fs::path("samples") / point / std::to_string(seed);
}

Sample sample_of(const Case& c, const std::vector<std::string>& keys, const fs::path& folder) {
  const double particles = particles_of(c);
  Sample sample{c, {}, {}, particles, expected_steps(c, particles)};
  for (const std::string& key : keys) sample.values.push_back(value_in(c, key));
  sample.folder = folder / folder_of_sample(keys, sample.values, c.mixture.seed);
  return sample;
}

std::vector<Sample> samples_of(const SweepFile& sweep, const std::vector<std::string>& keys,
                               const fs::path& folder) {
  std::vector<Sample> samples;
  std::map<fs::path, std::string> known;
  for (const SweepGrid& grid : sweep.grids)
    each_point(grid, sweep.base, [&](Case c) {
      validate_point(c, grid);
      for (int k = 0; k < grid.samples; ++k, ++c.mixture.seed) {
        Sample sample = sample_of(c, keys, folder);
        const std::string is = resolved_toml(c);
        const auto [place, fresh] = known.emplace(sample.folder, is);
        if (!fresh && place->second != is)
          throw InputError(fmt::format(
              "{}: {} would be the folder of two cases, which differ in a key that its name does not have; "
              "allowed: one case for each combination of values",
              grid.place, sample.folder.string()));
        if (fresh) samples.push_back(std::move(sample));
      }
    });
  return samples;
}

Sample moved_to(const Sample& sample, double small_fraction, const std::vector<std::string>& keys,
                const fs::path& folder) {
  Case c = sample.resolved_case;
  c.mixture.small_fraction = small_fraction;
  validate(c);
  return sample_of(c, keys, folder);
}

std::vector<fs::path> resolved_cases_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder / "samples"))
    for (const auto& point : fs::directory_iterator(folder / "samples"))
      if (point.is_directory())
        for (const auto& sample : fs::directory_iterator(point))
          if (const fs::path file = sample.path() / "case.resolved.toml"; fs::exists(file))
            files.push_back(file);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Sample> added_samples(const std::vector<Sample>& planned, const std::vector<std::string>& keys,
                                  const fs::path& folder) {
  std::set<fs::path> known;
  std::set<std::string> curves;
  for (const Sample& sample : planned) {
    known.insert(sample.folder);
    curves.insert(identity_of_curve(sample.resolved_case));
  }
  std::vector<Sample> added;
  for (const fs::path& file : resolved_cases_in(folder)) {
    if (known.contains(file.parent_path())) continue;
    const Sample sample = sample_of(read_case(file), keys, folder);
    if (sample.folder == file.parent_path() && curves.contains(identity_of_curve(sample.resolved_case)))
      added.push_back(sample);
  }
  return added;
}

double Sample::memory() const { return expected_memory(particles, resolved_case); }

SampleState state_of(const Sample& sample) {
  const fs::path resolved = sample.folder / "case.resolved.toml";
  if (!fs::exists(resolved)) return SampleState::missing;
  if (identity(read_case(resolved)) != identity(sample.resolved_case))
    throw InputError(
        fmt::format("{} holds the run of another case than this sweep has for that folder; remove the "
                    "folder, or take another --out",
                    sample.folder.string()));
  std::ifstream file(sample.folder / "result.json");
  const auto result = nlohmann::json::parse(file, nullptr, false);
  if (result.is_object()) try {
      const std::string version = result.value("version", "an older version");
      if (version != build_info().version)
        throw InputError(
            fmt::format("{} was made by furnas {} and this is furnas {}, whose samples may have other bits; "
                        "use that version, "
                        "remove the folder, or take another --out",
                        sample.folder.string(), version, build_info().version));
      const std::string verdict = result.value("verdict", "");
      const bool all_steps = result.value("steps", std::int64_t{0}) >= sample.resolved_case.stop.steps;
      const Case::Stop& stop = sample.resolved_case.stop;
      const auto bound = result.find("phi_bound");
      const bool as_asked =
          bound != result.end() && bound->is_number() && bound->get<double>() < stop.phi_error;
      if (verdict == "jammed" || (verdict == "settled" && as_asked) || verdict == "diverged" ||
          (verdict == "budget" && all_steps))
        return SampleState::finished;
    } catch (const nlohmann::json::exception& error) {
      throw InputError(fmt::format("{}: {}", (sample.folder / "result.json").string(), error.what()));
    }
  return Checkpoints::none(sample.folder) ? SampleState::missing : SampleState::interrupted;
}

}  // namespace furnas
