#include "io/case_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/stability.h"
#include "engine/protocol/protocol.h"
#include "engine/state/packing.h"
#include "io/case_protocol.h"
#include "io/case_schema.h"
#include "io/case_words.h"
#include "io/result.h"

namespace furnas {
namespace {

bool holds(const Range& range, const std::vector<double>& values) {
  return !values.empty() &&
         std::all_of(values.begin(), values.end(), [&](double value) { return range.contains(value); });
}

bool holds_allowed_value(const Key& key, const Case& c) {
  Case copy = c;
  const auto holds_field = [&](auto* field) {
    using Value = std::decay_t<decltype(*field)>;
    if (const auto* choices = std::get_if<Choices>(&key.allowed)) {
      if constexpr (std::is_same_v<Value, std::string>)
        return std::find(choices->begin(), choices->end(), *field) != choices->end();
    }
    if (const auto* range = std::get_if<Range>(&key.allowed)) {
      if constexpr (std::is_same_v<Value, std::vector<double>>)
        return holds(*range, *field);
      else if constexpr (std::is_arithmetic_v<Value>)
        return range->contains(static_cast<double>(*field));
      else if constexpr (!std::is_same_v<Value, std::string>)
        return !field->has_value() || range->contains(static_cast<double>(**field));
    }
    return true;
  };
  return std::visit(holds_field, key.field(copy));
}

/// Refuses a cell that is less than two smallest diameters wide when dense. Such a cell would be a lattice of
/// one or two spheres and their images; this is not a packing, and it often gains energy instead of coming to
/// rest.
std::optional<Conflict> conflict_of_small_cell(const Case& c) {
  if (c.compaction.cell == "fixed") return {};
  constexpr double least_width = 2;  // in smallest diameters
  const Mixture mixture = mixture_of(c);
  const double largest = large_diameter(mixture);
  const double volume = sphere_volume(largest / 2) /
                        (1 - mixture.small_fraction);  // of a large sphere and its share of small ones
  const double width = dense_width(static_cast<double>(mixture.large) * volume);
  if (width >= least_width) return {};
  const double least = std::ceil(std::pow(least_width / dense_width(volume), 3));
  const double thick = std::ceil(std::pow(least_thickness * largest / dense_thickness(volume), 3));
  return Conflict{
      "mixture.large",
      fmt::format(
          "mixture.large = {} makes a cell {:.1f} diameters of the smallest spheres wide when dense, too "
          "small to jam; allowed: at least {:.0f}, and from {:.0f} on the cell is {} largest diameters thick",
          c.mixture.large, width, least, thick, least_thickness)};
}

std::optional<Conflict> conflict_of_start(const Case& c) {
  const Case::Mixture& mixture = c.mixture;
  if (!c.start.file.empty()) {
    for (const Key& key : case_keys())
      if (key.table == "mixture" && value_text(key, c) != value_text(key, Case{}))
        return Conflict{"start.file",
                        fmt::format("start.file = \"{}\" and {} = {} exclude each other: a start is read or "
                                    "drawn; leave one of them out",
                                    c.start.file, key.path(), value_text(key, c))};
    return {};
  }
  if (!mixture.diameters.empty()) {
    if (mixture.has_default_sizes()) return {};
    return Conflict{
        "mixture.diameters",
        fmt::format("mixture.diameters = \"{}\" and size_ratio, small_fraction, large exclude each "
                    "other: sizes are listed or mixed; leave one of them out",
                    mixture.diameters)};
  }
  const double small = small_count(mixture_of(c));
  const double all = small + static_cast<double>(mixture.large);
  if (all > static_cast<double>(most_particles))
    return Conflict{
        "mixture.large",
        fmt::format("mixture.large = {} with size_ratio = {} and small_fraction = {} makes {:.4g} "
                    "spheres; allowed: at most {:.0f}",
                    mixture.large, mixture.size_ratio, mixture.small_fraction, all,
                    static_cast<double>(most_particles))};
  if (mixture.small_fraction > 0 && small < 1)
    return Conflict{
        "mixture.small_fraction",
        fmt::format("mixture.small_fraction = {} makes less than one small sphere with large = {}; "
                    "allowed: 0, or enough for one",
                    mixture.small_fraction, mixture.large)};
  return conflict_of_small_cell(c);
}

std::optional<Conflict> conflict_of_phi_error(const Case& c) {
  if (c.stop.phi_error == 0) return {};
  const auto with = [&](const char* other, const char* why) {
    return Conflict{"stop.phi_error", fmt::format("stop.phi_error = {} and {} exclude each other: {}",
                                                  c.stop.phi_error, other, why)};
  };
  if (c.stop.criterion == "paper")
    return with("stop.criterion = \"paper\"", "that criterion uses the kinetic energy alone; leave one out");
  if (c.compaction.cell == "fixed") return with("compaction.cell = \"fixed\"", "there phi does not change");
  return {};
}

std::optional<Conflict> conflict_of_time_step(const Case& c) {
  const Protocol protocol = protocol_of(c);
  const double dt = time_step_of(protocol);
  const double limit = largest_stable_step(law_of(protocol), equal_pair(1));
  if (dt < limit) return {};
  const bool absolute = c.compaction.time_step_absolute.has_value();
  return Conflict{
      absolute ? "compaction.time_step_absolute" : "compaction.time_step",
      fmt::format("compaction.time_step{} = {} makes a pair of the smallest spheres unstable; allowed: below "
                  "{:.4g} {}",
                  absolute ? "_absolute" : "", absolute ? dt : *c.compaction.time_step,
                  absolute ? limit : limit / time_unit_of(protocol), absolute ? "[time]" : "t_c")};
}

}  // namespace

std::optional<Conflict> find_conflict(const Case& c) {
  if (auto conflict = conflict_of_start(c)) return conflict;
  if (auto conflict = conflict_of_phi_error(c)) return conflict;
  return conflict_of_time_step(c);
}

void validate(const Case& c) {
  for (const Key& key : case_keys())
    if (!holds_allowed_value(key, c))
      throw InputError(fmt::format("{} = {} is not allowed; allowed: {}", key.path(), value_text(key, c),
                                   allowed_text(key)));
  if (const auto conflict = find_conflict(c)) throw InputError(conflict->message);
}

}  // namespace furnas
