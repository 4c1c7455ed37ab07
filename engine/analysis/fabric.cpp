#include "engine/analysis/fabric.h"

#include <cmath>

namespace furnas {

double Fabric::anisotropy() const {
  if (contacts == 0) return 0;
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double deviation = tensor[k] - 1.0 / 3;
    squares += deviation * deviation + 2 * tensor[k + 3] * tensor[k + 3];
  }
  return std::sqrt(1.5 * squares);
}

double Fabric::anisotropy_by_chance() const {
  return contacts > 0 ? 1 / std::sqrt(static_cast<double>(contacts)) : 0;
}

Fabric fabric(const Packing& p, const Selection& contacts) {
  Fabric found;
  found.contacts = static_cast<std::int64_t>(contacts.size());
  for (const std::size_t n : contacts) {
    const Vec3<double>& r = p.contacts[n].branch;
    const double square = dot(r, r);
    const double products[] = {r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.x * r.z, r.y * r.z};
    for (std::size_t k = 0; k < 6; ++k) found.tensor[k] += products[k] / square;
  }
  if (found.contacts > 0)
    for (double& component : found.tensor) component /= static_cast<double>(found.contacts);
  return found;
}

}  // namespace furnas
