#include "engine/state/shorter_edges.h"

#include <array>
#include <cmath>

#include "engine/base/require.h"

namespace furnas {
namespace {

__extension__ using Wide = __int128;

/// Whole cells and fraction of one coordinate as one number in units of 2^-64.
Wide join(std::int64_t whole, std::uint64_t fraction) { return (Wide{whole} << 64) + fraction; }
std::uint64_t fraction_of(Wide x) { return static_cast<std::uint64_t>(x); }
std::int64_t whole_of(Wide x) { return static_cast<std::int64_t>(x >> 64); }

/// The coordinates along the shortened edges: s_a + xy s_b + xz s_c, s_b + yz s_c, s_c.
struct Relabelling {
  std::int64_t xy{}, xz{}, yz{};
  bool changes() const { return xy != 0 || xz != 0 || yz != 0; }

  std::array<Wide, 3> operator()(const std::array<Wide, 3>& s) const {
    return {s[0] + xy * s[1] + xz * s[2], s[1] + yz * s[2], s[2]};
  }
};

/// Shortens the edges and returns the relabelling.
Relabelling shorten(Triangle& h) {
  Relabelling flip;
  flip.yz = std::llround(h.yz / h.yy);
  h.yz -= static_cast<double>(flip.yz) * h.yy;
  h.xz -= static_cast<double>(flip.yz) * h.xy;
  const std::int64_t of_c = std::llround(h.xz / h.xx);
  h.xz -= static_cast<double>(of_c) * h.xx;
  flip.xy = std::llround(h.xy / h.xx);
  h.xy -= static_cast<double>(flip.xy) * h.xx;
  flip.xz = of_c + flip.xy * flip.yz;  // yz times b was subtracted from c, and xy times a from b
  return flip;
}

}  // namespace

bool is_tilted(const Triangle& h, double farthest) {
  return std::abs(h.xy) > farthest * h.xx || std::abs(h.xz) > farthest * h.xx ||
         std::abs(h.yz) > farthest * h.yy;
}

bool shorten_edges(Packing& p, double farthest) {
  if (!is_tilted(p.cell.edges, farthest)) return false;
  const Relabelling flip = shorten(p.cell.edges);
  require(flip.changes(), "a tilted cell has shorter edges");

  std::vector<Fraction> before = p.fraction;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Fraction& s = before[k];
    const auto moved = flip({join(p.image[k][0], s.x), join(p.image[k][1], s.y), join(p.image[k][2], s.z)});
    p.fraction[k] = {fraction_of(moved[0]), fraction_of(moved[1]), fraction_of(moved[2])};
    for (std::size_t axis = 0; axis < 3; ++axis)
      p.image[k][axis] = static_cast<std::int32_t>(whole_of(moved[axis]));
  }
  const auto nearest = [](std::uint64_t a, std::uint64_t b) {
    return Wide{static_cast<std::int64_t>(a - b)};
  };
  for (Contact& c : p.contacts) {
    const Fraction& i = before[c.i];
    const Fraction& j = before[c.j];
    const auto moved =
        flip({nearest(i.x, j.x) + (Wide{c.image[0]} << 64), nearest(i.y, j.y) + (Wide{c.image[1]} << 64),
              nearest(i.z, j.z) + (Wide{c.image[2]} << 64)});
    const Fraction& a = p.fraction[c.i];
    const Fraction& b = p.fraction[c.j];
    const std::array<Wide, 3> near{nearest(a.x, b.x), nearest(a.y, b.y), nearest(a.z, b.z)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      c.image[axis] = static_cast<std::int8_t>(whole_of(moved[axis] - near[axis]));
  }
  return true;
}

}  // namespace furnas
