#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "engine/laws/hooke.h"
#include "engine/state/packing.h"

/// Contacts and forces the slow way: all pairs, all images, long double. Shares no code with the search.
namespace furnas::test {

using Long = long double;
using Far = Vec3<Long>;

/// A touch by name: i <= j and the image k, where the branch is h (nearest(s_i - s_j) + k). Of a particle
/// and its own images only the first half is named.
struct TouchName {
  std::uint32_t i, j;
  std::array<int, 3> image;
  friend auto operator<=>(const TouchName&, const TouchName&) = default;
};

struct BruteTouch {
  Far branch;     ///< from j to i [d_s]
  Long distance;  ///< [d_s]
};

/// s_i - s_j to the nearest image; 64 bits of a long double hold it exactly.
inline Far exact_difference(const Fraction& i, const Fraction& j) {
  const auto component = [](std::uint64_t a, std::uint64_t b) {
    return static_cast<Long>(static_cast<std::int64_t>(a - b)) / static_cast<Long>(two_to_64);
  };
  return {component(i.x, j.x), component(i.y, j.y), component(i.z, j.z)};
}

inline Far times(const Triangle& h, const Far& s) {
  return {Long(h.xx) * s.x + Long(h.xy) * s.y + Long(h.xz) * s.z, Long(h.yy) * s.y + Long(h.yz) * s.z,
          Long(h.zz) * s.z};
}

/// All pairs, image by image, whose centres are closer than R_i + R_j + margin. The cell is triangular:
/// the third component of a branch bounds its third image, then the second the second, then the first.
inline std::map<TouchName, BruteTouch> brute_pairs(const Packing& p, double margin) {
  const Triangle& h = p.cell.edges;
  std::map<TouchName, BruteTouch> found;
  const auto least = [](Long bound) { return static_cast<int>(std::floor(bound)); };
  const auto most = [](Long bound) { return static_cast<int>(std::ceil(bound)); };
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (std::uint32_t j = i; j < p.size(); ++j) {
      const Far d = exact_difference(p.fraction[i], p.fraction[j]);
      const Long reach = Long(p.radius[i]) + Long(p.radius[j]) + Long(margin);
      for (int z = least(-reach / h.zz - d.z); z <= most(reach / h.zz - d.z); ++z) {
        const Long lean_y = h.yz * (d.z + z);
        for (int y = least((-reach - lean_y) / h.yy - d.y); y <= most((reach - lean_y) / h.yy - d.y); ++y) {
          const Long lean_x = h.xz * (d.z + z) + h.xy * (d.y + y);
          for (int x = least((-reach - lean_x) / h.xx - d.x); x <= most((reach - lean_x) / h.xx - d.x); ++x) {
            if (i == j && std::tuple(x, y, z) <= std::tuple(0, 0, 0)) continue;
            const Far branch = times(h, {d.x + x, d.y + y, d.z + z});
            const Long distance = norm(branch);
            if (distance < reach) found[{i, j, {x, y, z}}] = {branch, distance};
          }
        }
      }
    }
  return found;
}

/// Name of the touch that a contact of the engine reports.
inline TouchName name_of(const Packing& p, const Contact& c) {
  TouchName name{c.i, c.j, {c.image[0], c.image[1], c.image[2]}};
  const bool swap = c.i > c.j || (c.i == c.j && name.image < std::array<int, 3>{});
  if (!swap) return name;
  std::swap(name.i, name.j);
  const Fraction &a = p.fraction[c.i], &b = p.fraction[c.j];
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  // A difference of half a cell is its own opposite, so its image moves by one.
  name.image = {(a.x - b.x == half) - name.image[0], (a.y - b.y == half) - name.image[1],
                (a.z - b.z == half) - name.image[2]};
  return name;
}

/// Force of the synchronized law on i, without history and before the first step.
inline Far brute_force(const Packing& p, const HookeConstants& law, bool spins, const TouchName& name,
                       const BruteTouch& touch) {
  const auto wide = [](const Vec3<double>& v) { return Far{v.x, v.y, v.z}; };
  const Long radius_i = p.radius[name.i];
  const Long radius_j = p.radius[name.j];
  const Long overlap = radius_i + radius_j - touch.distance;
  const Long mass =
      Long(p.mass[name.i]) * Long(p.mass[name.j]) / (Long(p.mass[name.i]) + Long(p.mass[name.j]));
  const Far normal = touch.branch * (1 / touch.distance);
  const Far velocity = wide(p.velocity[name.i]) - wide(p.velocity[name.j]);
  const Long f_n = overlap - mass * Long(law.normal_damping) * dot(velocity, normal);
  if (!spins) return f_n * normal;
  const Far arms =
      (radius_i - overlap / 2) * wide(p.spin[name.i]) + (radius_j - overlap / 2) * wide(p.spin[name.j]);
  const Far slip = velocity - dot(velocity, normal) * normal - cross(arms, normal);
  Far tangential = (-mass * Long(law.tangential_damping)) * slip;
  const Long size = norm(tangential);
  const Long limit = Long(law.friction) * std::abs(f_n);
  if (size > limit) tangential *= limit / size;
  return f_n * normal + tangential;
}

}  // namespace furnas::test
