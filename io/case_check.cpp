#include "io/case_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/state/packing.h"
#include "io/case_schema.h"
#include "io/case_words.h"

namespace furnas {
namespace {

constexpr double small_mass = sphere_volume(0.5);  // [rho d_s^3]

/// The stability limit of x'' = -stiffness x - damping x' with the force, damping included, taken at the
/// start of each step: stiffness dt^2 + 2 damping dt = 4.
double stable_time_step(double stiffness, double damping) {
  return 4 / (damping + std::sqrt(damping * damping + 4 * stiffness));
}

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

std::optional<Conflict> conflict_of_start(const Case& c) {
  const Case::Mixture& mixture = c.mixture;
  if (!c.start.file.empty()) {
    if (mixture == Case::Mixture{}) return {};
    return Conflict{"start.file",
                    fmt::format("start.file = \"{}\" and [mixture] exclude each other: a start is "
                                "read or drawn; leave one of them out",
                                c.start.file)};
  }
  const double small = small_spheres(mixture);
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
  return {};
}

std::optional<Conflict> conflict_of_time_step(const Case& c) {
  const auto dt = time_step(c);
  if (!dt)
    return Conflict{
        "contact.normal_damping",
        fmt::format("contact.normal_damping = {} overdamps the contact of two small spheres, so that "
                    "time_step has no collision time to count in; allowed: normal_damping < {:.5g}, "
                    "or give compaction.time_step_absolute",
                    c.contact.normal_damping, 2 * std::sqrt(2 / small_mass))};
  const double limit = largest_stable_time_step(c);
  if (*dt < limit) return {};
  const bool absolute = c.compaction.time_step_absolute.has_value();
  return Conflict{
      absolute ? "compaction.time_step_absolute" : "compaction.time_step",
      fmt::format("compaction.time_step{} = {} makes a pair of the smallest spheres unstable; "
                  "allowed: below {:.4g} {}",
                  absolute ? "_absolute" : "", absolute ? *dt : c.compaction.time_step,
                  absolute ? limit : limit / *collision_time(c.contact), absolute ? "[time]" : "t_c")};
}

}  // namespace

double small_spheres(const Case::Mixture& mixture) {
  const double ratio = mixture.size_ratio;
  const double share = mixture.small_fraction / (1 - mixture.small_fraction);
  return std::round(static_cast<double>(mixture.large) * ratio * ratio * ratio * share);
}

std::optional<double> collision_time(const Case::Contact& contact) {
  const double squared = 2 / small_mass - contact.normal_damping * contact.normal_damping / 4;
  if (!(squared > 0)) return {};
  return std::numbers::pi / std::sqrt(squared);
}

std::optional<double> time_step(const Case& c) {
  if (c.compaction.time_step_absolute) return c.compaction.time_step_absolute;
  const auto unit = collision_time(c.contact);
  if (!unit) return {};
  return c.compaction.time_step * *unit;
}

double largest_stable_time_step(const Case& c) {
  const bool has_small = !c.start.file.empty() || c.mixture.small_fraction > 0;
  const double ratio = has_small ? 1 : c.mixture.size_ratio;
  const double pair_mass = small_mass * ratio * ratio * ratio / 2;  // m_eff
  const double normal = stable_time_step(1 / pair_mass, c.contact.normal_damping);
  if (c.contact.friction == 0) return normal;
  // Slip of two spheres meets 7/2 of the inverse mass: they also turn.
  const double tangential =
      stable_time_step(3.5 * c.contact.tangential_stiffness / pair_mass, 3.5 * c.contact.tangential_damping);
  return std::min(normal, tangential);
}

std::optional<Conflict> find_conflict(const Case& c) {
  if (auto conflict = conflict_of_start(c)) return conflict;
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
