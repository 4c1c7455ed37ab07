#include "cases/program/replication.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "engine/base/require.h"
#include "io/case_file.h"
#include "io/checkpoint.h"
#include "io/formats.h"

namespace furnas {
namespace {

/// The case of the larger packing. If the case gives the absolute inertia of the cell, it is scaled with M
/// L^2. [mixture] stays that of the original packing.
Case replicated(Case c, const Times& times) {
  if (c.compaction.inertia_absolute) *c.compaction.inertia_absolute *= std::pow(copies_of(times), 5.0 / 3);
  return c;
}

}  // namespace

Times parse_times(const std::string& text) {
  Times times{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (std::size_t a = 0; a < 3 && good; ++a) {
    if (a > 0) good = at != end && *at++ == 'x';
    const auto [rest, error] = std::from_chars(at, end, times[a]);
    good = good && error == std::errc{} && times[a] >= 1;
    at = rest;
  }
  if (!good || at != end)
    throw InputError("--times " + text + ": allowed: three whole numbers from 1 on, such as 2x2x2");
  return times;
}

std::string text_of(const Times& times) { return fmt::format("{}", fmt::join(times, "x")); }

void write_replicate(const PackingSource& source, const Times& times, const std::filesystem::path& file) {
  const bool whole = file.extension() == ".checkpoint";
  const std::string_view format =
      whole ? "" : format_by_extension(file);  // an unknown extension is refused before the work
  if (!whole) return write_packing(replicate(source.packing, times), format, file);
  const Replica replica(source.packing, times);
  const std::string case_text = source.of_case ? resolved_toml(replicated(*source.of_case, times)) : "";
  write_checkpoint({replica, case_text}, file);
}

}  // namespace furnas
