#include "engine/state/species.h"

#include <algorithm>
#include <array>
#include <optional>

namespace furnas {
namespace {

constexpr double one_size = 1 - 1e-6;  // sizes with a ratio above this count as equal

bool same_size(double a, double b) { return std::min(a, b) >= one_size * std::max(a, b); }

/// Smallest and largest of several radii.
struct Span {
  double least{}, most{};
  explicit Span(double r) : least(r), most(r) {}
  void add(double r) { least = std::min(least, r), most = std::max(most, r); }
  bool is_one_size() const { return same_size(least, most); }
};

std::optional<Span> span_of(const std::vector<double>& radius) {
  if (radius.empty()) return {};
  const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
  Span span(*least);
  span.add(*most);
  return span;
}

std::size_t count_of(std::vector<double> radius) {
  std::sort(radius.begin(), radius.end());
  std::size_t count = 0;
  for (auto at = radius.begin(); at != radius.end(); ++count)
    at = std::find_if(at, radius.end(), [first = *at](double r) { return !same_size(first, r); });
  return count;
}

/// The two types of a packing with exactly two types.
struct TwoTypes {
  std::array<std::int32_t, 2> type{};  ///< the lower type first
  std::array<double, 2> sum{};         ///< of the radii of each
  std::array<double, 2> count{};
  std::array<std::optional<Span>, 2> span;

  void add(std::size_t which, double r) {
    sum[which] += r, ++count[which];
    span[which] ? span[which]->add(r) : static_cast<void>(span[which].emplace(r));
  }
  bool each_is_one_size() const { return span[0]->is_one_size() && span[1]->is_one_size(); }
  std::int32_t larger() const {
    const double lower = sum[0] / count[0], upper = sum[1] / count[1];
    return type[!same_size(lower, upper) && upper > lower ? 1 : 0];
  }
};

std::optional<TwoTypes> two_types(const std::vector<double>& radius, const std::vector<std::int32_t>& type) {
  if (type.empty()) return {};
  const auto [lower, upper] = std::minmax_element(type.begin(), type.end());
  if (*lower == *upper) return {};
  TwoTypes two{.type = {*lower, *upper}, .sum = {}, .count = {}, .span = {}};
  for (std::size_t k = 0; k < type.size(); ++k) {
    if (type[k] != *lower && type[k] != *upper) return {};
    two.add(type[k] == *upper, radius[k]);
  }
  return two;
}

}  // namespace

Sizes sizes_of(const std::vector<double>& radius) {
  const auto span = span_of(radius);
  if (!span) return {};
  Sizes sizes{1, 2 * span->least, 2 * span->most};
  if (span->is_one_size()) return sizes;
  const bool two = std::all_of(radius.begin(), radius.end(), [&](double r) {
    return same_size(r, span->least) || same_size(r, span->most);
  });
  sizes.count = two ? 2 : count_of(radius);
  return sizes;
}

std::vector<Species> species_by_size(const std::vector<double>& radius) {
  std::vector<Species> species(radius.size(), Species::large);
  const Sizes sizes = sizes_of(radius);
  if (sizes.count != 2) return species;
  for (std::size_t k = 0; k < radius.size(); ++k)
    if (!same_size(2 * radius[k], sizes.largest)) species[k] = Species::small;
  return species;
}

std::vector<Species> species_by_type(const std::vector<double>& radius,
                                     const std::vector<std::int32_t>& type) {
  const auto two = two_types(radius, type);
  if (!two || (!two->each_is_one_size() && sizes_of(radius).count == 2)) return species_by_size(radius);
  std::vector<Species> species(radius.size(), Species::small);
  const std::int32_t large = two->larger();
  for (std::size_t k = 0; k < radius.size(); ++k)
    if (type[k] == large) species[k] = Species::large;
  return species;
}

bool is_polydisperse(const Packing& p) {
  std::array<std::optional<Span>, 2> spans;
  for (std::size_t k = 0; k < p.size(); ++k) {
    auto& span = spans[static_cast<std::size_t>(p.species[k])];
    span ? span->add(p.radius[k]) : static_cast<void>(span.emplace(p.radius[k]));
  }
  return std::any_of(spans.begin(), spans.end(),
                     [](const auto& span) { return span && !span->is_one_size(); });
}

bool is_one_polydisperse_species(const Packing& p) {
  return std::all_of(p.species.begin(), p.species.end(), [&](Species s) { return s == p.species.front(); }) &&
         is_polydisperse(p);
}

}  // namespace furnas
