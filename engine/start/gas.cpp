#include "engine/start/gas.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>

#include "engine/base/random.h"
#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/state/species.h"

namespace furnas {
namespace {

/// Spheres of about one size in a periodic cube, sorted into hashed bins. The memory is proportional to the
/// number of spheres, not to the volume of the cube.
class Occupied {
 public:
  /// `radius` and `probe_radius` are upper bounds of the radii of the spheres and of the probes.
  Occupied(double length, double radius, double probe_radius, std::size_t expected)
      : length_(length),
        bins_(std::max(1.0, std::floor(length / (radius + probe_radius)))),
        heads_(std::bit_ceil(2 * expected + 1), none) {}

  void insert(const Vec3<double>& s, std::uint32_t id) {
    std::uint32_t& head = heads_[slot(bin(s.x), bin(s.y), bin(s.z))];
    spheres_.push_back({s, head, id});
    head = static_cast<std::uint32_t>(spheres_.size() - 1);
  }

  /// Whether a probe centred at `s` touches one of the spheres; `radii` is indexed by id.
  bool touches(const Vec3<double>& s, double probe_radius, const std::vector<double>& radii) const {
    const std::int64_t reach = bins_ > 2 ? 1 : 0;
    const std::int64_t extra = bins_ > 2 ? 0 : static_cast<std::int64_t>(bins_) - 1;
    for (std::int64_t x = bin(s.x) - reach; x <= bin(s.x) + reach + extra; ++x)
      for (std::int64_t y = bin(s.y) - reach; y <= bin(s.y) + reach + extra; ++y)
        for (std::int64_t z = bin(s.z) - reach; z <= bin(s.z) + reach + extra; ++z)
          for (std::uint32_t k = heads_[slot(x, y, z)]; k != none; k = spheres_[k].next)
            if (near(s, spheres_[k].fraction, radii[spheres_[k].id] + probe_radius)) return true;
    return false;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Sphere {
    Vec3<double> fraction;
    std::uint32_t next, id;
  };

  std::int64_t bin(double s) const { return static_cast<std::int64_t>(s * bins_); }

  /// Place of a bin in the hash table. Neighbouring bins along z are neighbours in memory. For many spheres
  /// the table is not in the cache, so a search then needs nine accesses to memory instead of 27.
  std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto n = static_cast<std::int64_t>(bins_);
    const auto wrap = [n](std::int64_t a) {
      return static_cast<std::uint64_t>(a < 0 ? a + n : a < n ? a : a - n);
    };
    const std::uint64_t column = wrap(x) * static_cast<std::uint64_t>(n) + wrap(y);
    return ((column * 0x9E3779B97F4A7C15u >> 20) + wrap(z)) & (heads_.size() - 1);
  }

  bool near(const Vec3<double>& a, const Vec3<double>& b, double contact) const {
    const auto nearest = [](double d) { return d - std::nearbyint(d); };
    const Vec3<double> d{nearest(a.x - b.x), nearest(a.y - b.y), nearest(a.z - b.z)};
    return dot(d, d) * length_ * length_ < contact * contact;
  }

  double length_;
  double bins_;
  std::vector<std::uint32_t> heads_;
  std::vector<Sphere> spheres_;
};

/// Spheres sorted into size classes; within a class the largest diameter is at most twice the smallest. For
/// each class of probes there are separate bins with the spheres that a probe may touch.
class OccupiedByAll {
 public:
  /// `order`: the ids, largest sphere first.
  OccupiedByAll(double length, const std::vector<double>& radii, const std::vector<std::uint32_t>& order)
      : radii_(radii) {
    for (const std::uint32_t id : order) {
      if (classes_.empty() || radii[id] < classes_.back().largest / 2) classes_.push_back({radii[id], 0, {}});
      ++classes_.back().count;
    }
    for (std::size_t probe = 0; probe < classes_.size(); ++probe)
      for (std::size_t other = 0; other <= probe; ++other)
        classes_[probe].met.emplace_back(length, classes_[other].largest, classes_[probe].largest,
                                         classes_[other].count);
  }

  /// Must be called in the order of the ids, largest sphere first.
  bool touches(const Vec3<double>& s, std::uint32_t id) {
    while (radii_[id] < classes_[present_].largest / 2) ++present_;
    const double radius = radii_[id];
    const auto& met = classes_[present_].met;
    return std::any_of(met.begin(), met.end(),
                       [&](const Occupied& some) { return some.touches(s, radius, radii_); });
  }

  void insert(const Vec3<double>& s, std::uint32_t id) {
    for (std::size_t probe = present_; probe < classes_.size(); ++probe)
      classes_[probe].met[present_].insert(s, id);
  }

 private:
  struct Class {
    double largest;             ///< radius [d_s]
    std::size_t count;          ///< spheres
    std::vector<Occupied> met;  ///< for probes of this class: spheres, by class down to this one
  };

  const std::vector<double>& radii_;
  std::vector<Class> classes_;
  std::size_t present_ = 0;
};

Vec3<double> random_place(std::uint64_t seed, std::uint64_t particle, std::uint32_t attempt) {
  const auto words = philox(
      {static_cast<std::uint32_t>(particle), static_cast<std::uint32_t>(particle >> 32), attempt, 0}, seed);
  const auto unit = [](std::uint32_t w) { return (w + 0.5) / 4294967296.0; };
  return {unit(words[0]), unit(words[1]), unit(words[2])};
}

/// The ids sorted by radius, largest first; equal radii keep their order.
std::vector<std::uint32_t> biggest_first(const std::vector<double>& radii) {
  std::vector<std::uint32_t> order(radii.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return radii[a] > radii[b]; });
  return order;
}

/// Edge of the cube that the spheres fill to start_fraction [d_s].
double length_of(const std::vector<double>& radii, const GasOptions& options) {
  double volume = options.sphere_volume;
  if (volume == 0)
    for (const double radius : radii) volume += sphere_volume(radius);
  const double length = std::cbrt(volume / options.start_fraction);
  const double largest = *std::max_element(radii.begin(), radii.end());
  if (length <= 2 * largest)
    throw InputError("at a packing fraction of " + std::to_string(options.start_fraction) + " the cell, " +
                     std::to_string(length) + " d_s, is smaller than a large sphere; start more dilute");
  return length;
}

}  // namespace

Packing dilute_gas(const std::vector<double>& radii, const GasOptions& options) {
  if (radii.empty()) throw InputError("no spheres are wanted; allowed: 1 or more");
  const auto wrong = std::find_if(radii.begin(), radii.end(),
                                  [](double radius) { return !(std::isfinite(radius) && radius > 0); });
  if (wrong != radii.end())
    throw InputError("sphere " + std::to_string(wrong - radii.begin() + 1) + " has the radius " +
                     std::to_string(*wrong) + "; allowed: above 0 and finite");
  if (!(std::isfinite(options.start_fraction) && options.start_fraction > 0))
    throw InputError("the packing fraction of the start is " + std::to_string(options.start_fraction) +
                     "; allowed: above 0");
  if (radii.size() > static_cast<std::size_t>(most_particles))
    throw InputError(std::to_string(radii.size()) + " spheres are wanted; at most " +
                     std::to_string(most_particles) + " can be numbered");
  const double length = length_of(radii, options);
  Packing p;
  p.resize(radii.size());
  p.cell.edges = {length, length, length, 0, 0, 0};
  p.radius = radii;
  p.species = species_by_size(radii);

  constexpr std::uint32_t most_attempts = 1'000'000;
  const std::vector<std::uint32_t> order = biggest_first(radii);
  OccupiedByAll occupied(length, radii, order);
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::uint32_t id = order[n];
    Vec3<double> s;
    std::uint32_t attempt = 0;
    do {
      if (attempt == most_attempts)
        throw InputError("no free place for particle " + std::to_string(id + 1) +
                         " at a packing fraction of " + std::to_string(options.start_fraction) +
                         "; start more dilute");
      s = random_place(options.seed, n, attempt++);
    } while (occupied.touches(s, id));
    occupied.insert(s, id);
    p.mass[id] = sphere_mass(radii[id]);
    p.fraction[id] = to_fraction(s);
  }
  return p;
}

}  // namespace furnas
