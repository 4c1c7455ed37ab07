#include "engine/search/size_classes.h"

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>

#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr double widest_class = 1.5;

/// Radii are compared as `float`: in mixed precision a simulation knows no others.
double compared(double radius) { return static_cast<float>(radius); }

/// Lower bounds of the classes' radii, largest first, from all radii.
std::vector<double> class_bounds(std::vector<double> radii) {
  std::transform(radii.begin(), radii.end(), radii.begin(), compared);
  std::sort(radii.begin(), radii.end(), std::greater<>());
  std::vector<double> smallest;
  double largest = 0;
  for (double radius : radii) {
    if (smallest.empty() || largest > widest_class * radius) {
      largest = radius;
      smallest.push_back(radius);
    }
    smallest.back() = radius;
  }
  return smallest;
}

std::size_t class_of(double radius, const std::vector<double>& bounds) {
  std::size_t c = 0;
  while (compared(radius) < bounds[c]) ++c;
  return c;
}

/// Spreads the 21 leading bits of a fraction, so that each is followed by two zero bits.
std::uint64_t spread(std::uint64_t fraction) {
  std::uint64_t x = fraction >> 43;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

std::vector<SizeClass> size_classes(const std::vector<double>& radii_in_order) {
  const std::vector<double> bounds = class_bounds(radii_in_order);
  std::vector<SizeClass> classes;
  for (std::size_t i = 0; i < radii_in_order.size(); ++i) {
    const std::size_t c = class_of(radii_in_order[i], bounds);
    if (c == classes.size()) classes.push_back({i, i, radii_in_order[i], radii_in_order[i]});
    if (c + 1 != classes.size())
      throw InputError("the order in memory has a particle of radius " + std::to_string(radii_in_order[i]) +
                       " after smaller ones; allowed: size classes one after another, largest first");
    SizeClass& group = classes.back();
    group.last = i + 1;
    group.smallest_radius = std::min(group.smallest_radius, radii_in_order[i]);
    group.largest_radius = std::max(group.largest_radius, radii_in_order[i]);
  }
  return classes;
}

std::vector<std::uint32_t> memory_order(const Packing& packing) {
  const std::vector<double> bounds = class_bounds(packing.radius);
  struct Key {
    std::size_t size_class;
    std::uint64_t curve;
    std::uint32_t index;
  };
  std::vector<Key> keys(packing.size());
  for (std::uint32_t k = 0; k < keys.size(); ++k) {
    const Fraction& s = packing.fraction[k];
    keys[k] = {class_of(packing.radius[k], bounds), spread(s.x) << 2 | spread(s.y) << 1 | spread(s.z), k};
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tie(a.size_class, a.curve, a.index) < std::tie(b.size_class, b.curve, b.index);
  });
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& key) { return key.index; });
  return order;
}

}  // namespace furnas
