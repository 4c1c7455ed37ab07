#include "cases/program/run/continuation.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "cases/program/build_info.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/case_words.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

constexpr const char* version_key = "version of furnas";
constexpr const char* resting_states_key =
    "resting states: pressure phi step Z_backbone large_rattlers small_rattlers";
constexpr const char* bounds_key = "bounds on phi at these pressures, 0 at rest";
constexpr const char* window_key = "window of rest: step xx yy zz yz xz xy holds holds_loosely";
constexpr const char* look_key = "last look: backbone stress_error force_imbalance kinetic_energy";
constexpr const char* counts_key = "counts: replaced lists_built wall_seconds ended";
constexpr const char* cpu_key = "cpu seconds";
constexpr const char* unit_key = "unit of the list of diameters";
constexpr std::string_view event_key = "event: ";

std::string rows_of(const std::vector<RestingState>& reached) {
  std::string rows;
  for (const RestingState& s : reached)
    rows += fmt::format("{} {} {} {} {} {}\n", s.pressure, s.phi, s.step, s.Z_backbone, s.large_rattlers,
                        s.small_rattlers);
  return rows;
}

std::string bounds_of(const std::vector<RestingState>& reached) {
  std::string bounds;
  for (const RestingState& s : reached) bounds += fmt::format("{}\n", s.phi_bound);
  return bounds;
}

std::string rows_of(const std::deque<RestWatch::Look>& window) {
  std::string rows;
  for (const auto& [step, h, holds, loosely] : window)
    rows += fmt::format("{} {} {} {} {} {} {} {:d} {:d}\n", step, h.xx, h.yy, h.zz, h.yz, h.xz, h.xy, holds,
                        loosely);
  return rows;
}

/// Verdicts after which nothing is left to do; a checkpoint stores the position in this list.
constexpr std::optional<Verdict> ends[] = {{}, Verdict::jammed, Verdict::settled};

std::ptrdiff_t place_of(const std::optional<Verdict>& end) {
  return std::find(std::begin(ends), std::end(ends), end) - std::begin(ends);
}

void require_saved(bool held, const char* key) {
  if (!held)
    throw InputError(std::string("the checkpoint lacks an entry that a run needs to continue: ") + key);
}

/// The text under a key.
const std::string& text_under(const Checkpoint& checkpoint, const char* key) {
  const auto found = checkpoint.extras.find(key);
  require_saved(found != checkpoint.extras.end(), key);
  return found->second;
}

void refuse_another_version(const Checkpoint& checkpoint) {
  const auto found = checkpoint.extras.find(version_key);
  const std::string wrote = found == checkpoint.extras.end() ? "an older version" : found->second;
  if (wrote != build_info().version)
    throw InputError(
        fmt::format("the checkpoint was written by furnas {} and this is furnas {}, which might give "
                    "other bits; resume with that version, or begin a new run with start.file",
                    wrote, build_info().version));
}

void refuse_another_case(const Case& saved, const Case& asked, const std::string& file) {
  for (const Key& key : case_keys()) {
    const std::string was = value_text(key, saved), now = value_text(key, asked);
    if (was == now || changes_no_bit(key)) continue;
    throw InputError(
        fmt::format("{}: {} = {}, but the checkpoint was saved with {}; this key cannot change when "
                    "a run is resumed; begin a new run, with start.file if it is to start from this packing",
                    file, key.path(), now.empty() ? "nothing" : now, was.empty() ? "nothing" : was));
  }
}

}  // namespace

std::map<std::string, std::string> to_extras(const Continuation& c) {
  std::map<std::string, std::string> extras{
      {version_key, std::string(build_info().version)},
      {resting_states_key, rows_of(c.reached)},
      {bounds_key, bounds_of(c.reached)},
      {window_key, rows_of(c.watch.window)},
      {look_key, fmt::format("{} {} {} {}", c.watch.backbone, c.watch.stress_error, c.watch.force_imbalance,
                             c.watch.kinetic_energy)},
      {counts_key, fmt::format("{} {} {} {}", c.replaced, c.lists_built, c.wall_seconds, place_of(c.ended))},
      {cpu_key, fmt::format("{}", c.cpu_seconds)}};
  if (c.listed_unit) extras[unit_key] = fmt::format("{}", *c.listed_unit);
  for (const auto& [name, saved] : c.events) extras[std::string(event_key) + name] = saved;
  return extras;
}

std::vector<RestingState> resting_states_of(const Checkpoint& checkpoint) {
  std::vector<RestingState> reached;
  if (!checkpoint.extras.contains(resting_states_key))
    return reached;  // the checkpoint of a packing without a run
  Numbers rows(text_under(checkpoint, resting_states_key));
  for (RestingState s; rows.more(); reached.push_back(s))
    require_saved(rows.take(s.pressure, s.phi, s.step, s.Z_backbone, s.large_rattlers, s.small_rattlers),
                  resting_states_key);
  if (!checkpoint.extras.contains(bounds_key)) return reached;  // older versions left a pressure only at rest
  Numbers bounds(text_under(checkpoint, bounds_key));
  for (RestingState& s : reached) require_saved(bounds.take(s.phi_bound), bounds_key);
  require_saved(!bounds.more(), bounds_key);
  return reached;
}

Continuation continuation_of(const Checkpoint& checkpoint) {
  refuse_another_version(checkpoint);
  Continuation c;
  c.reached = resting_states_of(checkpoint);
  Numbers looks(text_under(checkpoint, window_key));
  RestWatch::Look look;
  Triangle& h = look.edges;
  for (; looks.more(); c.watch.window.push_back(look))
    require_saved(looks.take(look.step, h.xx, h.yy, h.zz, h.yz, h.xz, h.xy, look.holds, look.holds_loosely),
                  window_key);
  RestWatch::Saved& watch = c.watch;
  require_saved(
      Numbers(text_under(checkpoint, look_key))
          .take_all(watch.backbone, watch.stress_error, watch.force_imbalance, watch.kinetic_energy),
      look_key);
  std::size_t ended{};
  require_saved(Numbers(text_under(checkpoint, counts_key))
                        .take_all(c.replaced, c.lists_built, c.wall_seconds, ended) &&
                    ended < std::size(ends),
                counts_key);
  c.ended = ends[ended];
  if (checkpoint.extras.contains(cpu_key))
    require_saved(Numbers(text_under(checkpoint, cpu_key)).take_all(c.cpu_seconds), cpu_key);
  else
    c.cpu_seconds = std::numeric_limits<double>::quiet_NaN();
  if (checkpoint.extras.contains(unit_key))
    require_saved(Numbers(text_under(checkpoint, unit_key)).take_all(c.listed_unit.emplace()), unit_key);
  for (const auto& [key, saved] : checkpoint.extras)
    if (key.starts_with(event_key)) c.events[key.substr(event_key.size())] = saved;
  return c;
}

Case case_to_go_on_with(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                        std::span<const std::string> set) {
  const Case saved = parse_case(checkpoint.case_text, folder.string() + " (checkpoint)");
  Case c = saved;
  if (const auto file = folder / "case.resolved.toml"; std::filesystem::exists(file)) {
    c = parse_case(read_file(file), file.string());
    refuse_another_case(saved, c, file.string());
  }
  for (const std::string& assignment : set) apply_override(c, assignment);
  validate(c);
  return c;
}

}  // namespace furnas
