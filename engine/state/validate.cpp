#include "engine/state/validate.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "engine/base/require.h"

namespace furnas {
namespace {

std::string name(std::size_t k) { return "particle " + std::to_string(k + 1); }

void refuse_common_centres(const Packing& p) {
  std::vector<std::uint32_t> order(p.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto key = [&](std::uint32_t k) {
    const Fraction& s = p.fraction[k];
    return std::tuple(s.x, s.y, s.z, k);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t n = 1; n < order.size(); ++n)
    if (p.fraction[order[n - 1]] == p.fraction[order[n]])
      throw InputError(name(order[n - 1]) + " and " + name(order[n]) + " have the same centre");
}

}  // namespace

void validate(const Packing& p) {
  if (p.size() == 0) throw InputError("the packing has no particles");
  const Triangle& h = p.cell.edges;
  if (!(h.xx > 0 && h.yy > 0 && h.zz > 0) || !finite(h))
    throw InputError("the cell has no volume: its edges must be finite and positive along the diagonal");
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!(p.radius[k] > 0) || !(p.mass[k] > 0) || !std::isfinite(p.radius[k] + p.mass[k]))
      throw InputError(name(k) + " has radius " + std::to_string(p.radius[k]) + " and mass " +
                       std::to_string(p.mass[k]) + "; both must be positive");
    if (!finite(p.velocity[k]) || !finite(p.spin[k]) || !finite(p.force[k]) || !finite(p.torque[k]))
      throw InputError(name(k) + " has a velocity, spin, force or torque that is not a number");
  }
  refuse_common_centres(p);
}

}  // namespace furnas
