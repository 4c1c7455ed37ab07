#include "engine/start/mixture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/random.h"
#include "engine/base/require.h"
#include "engine/base/sphere.h"

namespace furnas {
namespace {

/// Spheres of one size in a periodic cube, found through hashed bins: memory follows the spheres, not
/// the cube.
class Occupied {
 public:
  Occupied(double length, double radius, double probe_radius, std::size_t expected)
      : length_(length),
        bins_(std::max(1.0, std::floor(length / (radius + probe_radius)))),
        contact_((radius + probe_radius) * (radius + probe_radius)),
        heads_(std::bit_ceil(2 * expected + 1), none) {}

  void insert(const Vec3<double>& s) {
    std::uint32_t& head = heads_[slot(bin(s.x), bin(s.y), bin(s.z))];
    spheres_.push_back({s, head});
    head = static_cast<std::uint32_t>(spheres_.size() - 1);
  }

  /// Whether a probe centred at `s` touches one of the spheres.
  bool touches(const Vec3<double>& s) const {
    const std::int64_t reach = bins_ > 2 ? 1 : 0;
    const std::int64_t extra = bins_ > 2 ? 0 : static_cast<std::int64_t>(bins_) - 1;
    for (std::int64_t x = bin(s.x) - reach; x <= bin(s.x) + reach + extra; ++x)
      for (std::int64_t y = bin(s.y) - reach; y <= bin(s.y) + reach + extra; ++y)
        for (std::int64_t z = bin(s.z) - reach; z <= bin(s.z) + reach + extra; ++z)
          for (std::uint32_t k = heads_[slot(x, y, z)]; k != none; k = spheres_[k].next)
            if (near(s, spheres_[k].fraction)) return true;
    return false;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Sphere {
    Vec3<double> fraction;
    std::uint32_t next;
  };

  std::int64_t bin(double s) const { return static_cast<std::int64_t>(s * bins_); }

  /// Bins that follow each other along z do so in memory, which for many spheres is far away: a look costs
  /// nine ways there, not 27.
  std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto n = static_cast<std::int64_t>(bins_);
    const auto wrap = [n](std::int64_t a) {
      return static_cast<std::uint64_t>(a < 0 ? a + n : a < n ? a : a - n);
    };
    const std::uint64_t column = wrap(x) * static_cast<std::uint64_t>(n) + wrap(y);
    return ((column * 0x9E3779B97F4A7C15u >> 20) + wrap(z)) & (heads_.size() - 1);
  }

  bool near(const Vec3<double>& a, const Vec3<double>& b) const {
    const auto nearest = [](double d) { return d - std::nearbyint(d); };
    const Vec3<double> d{nearest(a.x - b.x), nearest(a.y - b.y), nearest(a.z - b.z)};
    return dot(d, d) * length_ * length_ < contact_;
  }

  double length_;
  double bins_;
  double contact_;
  std::vector<std::uint32_t> heads_;
  std::vector<Sphere> spheres_;
};

Vec3<double> random_place(std::uint64_t seed, std::uint64_t particle, std::uint32_t attempt) {
  const auto words = philox(
      {static_cast<std::uint32_t>(particle), static_cast<std::uint32_t>(particle >> 32), attempt, 0}, seed);
  const auto unit = [](std::uint32_t w) { return (w + 0.5) / 4294967296.0; };
  return {unit(words[0]), unit(words[1]), unit(words[2])};
}

}  // namespace

double small_count(const Mixture& m) {
  return std::round(static_cast<double>(m.large) * m.size_ratio * m.size_ratio * m.size_ratio *
                    m.small_fraction / (1 - m.small_fraction));
}

Packing dilute_start(const Mixture& m) {
  const double all = static_cast<double>(m.large) + small_count(m);
  if (all > static_cast<double>(most_particles))
    throw InputError(std::to_string(std::llround(all)) + " spheres are wanted; at most " +
                     std::to_string(most_particles) + " can be numbered");
  const auto large = static_cast<std::size_t>(m.large);
  const auto small = static_cast<std::size_t>(small_count(m));
  const double large_radius = 0.5 * m.size_ratio;
  const double small_radius = 0.5;
  const double volume = static_cast<double>(large) * sphere_volume(large_radius) +
                        static_cast<double>(small) * sphere_volume(small_radius);
  const double length = std::cbrt(volume / m.start_fraction);
  if (length <= 2 * large_radius)
    throw InputError("at a packing fraction of " + std::to_string(m.start_fraction) + " the cell, " +
                     std::to_string(length) + " d_s, is smaller than a large sphere; start more dilute");

  Packing p;
  p.resize(large + small);
  p.cell.edges = {length, length, length, 0, 0, 0};
  Occupied large_ones(length, large_radius, large_radius, large);
  Occupied large_for_small(length, large_radius, small_radius, large);
  Occupied small_ones(length, small_radius, small_radius, small);

  constexpr std::uint32_t most_attempts = 1'000'000;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool is_large = k < large;
    Vec3<double> s;
    std::uint32_t attempt = 0;
    do {
      if (attempt == most_attempts)
        throw InputError("no free place for particle " + std::to_string(k + 1) +
                         " at a packing fraction of " + std::to_string(m.start_fraction) +
                         "; start more dilute");
      s = random_place(m.seed, k, attempt++);
    } while (is_large ? large_ones.touches(s) : large_for_small.touches(s) || small_ones.touches(s));

    if (is_large) {
      large_ones.insert(s);
      large_for_small.insert(s);
    } else {
      small_ones.insert(s);
    }
    p.species[k] = is_large ? Species::large : Species::small;
    p.radius[k] = is_large ? large_radius : small_radius;
    p.mass[k] = sphere_mass(p.radius[k]);
    p.fraction[k] = to_fraction(s);
  }
  return p;
}

void set_masses(Packing& p, double exponent) {
  for (std::size_t k = 0; k < p.size(); ++k)
    p.mass[k] = sphere_mass(0.5) * std::pow(2 * p.radius[k], exponent);
}

}  // namespace furnas
