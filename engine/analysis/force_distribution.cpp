#include "engine/analysis/force_distribution.h"

#include <algorithm>

#include "engine/base/require.h"

namespace furnas {
namespace {

template <class Force>
ForceDistribution distribution(const Packing& p, const Selection& contacts, const ForceBins& bins,
                               Force force) {
  std::vector<double> forces;
  double sum = 0;
  for (const std::size_t n : contacts) {
    forces.push_back(force(p.contacts[n]));
    sum += forces.back();
  }
  ForceDistribution found;
  found.contacts = static_cast<std::int64_t>(forces.size());
  if (!(sum > 0)) return found;
  found.mean = sum / static_cast<double>(forces.size());
  double least = found.mean, most = 0;
  for (double& f : forces) {
    if (f > 0) least = std::min(least, f);
    most = std::max(most, f);
    f /= found.mean;
  }
  found.largest = most;
  found.histogram = histogram(
      forces, bins.logarithmic ? logarithmic_edges(bins.per_decade, least / found.mean, most / found.mean)
                               : linear_edges(bins.width, most / found.mean));
  return found;
}

}  // namespace

ForceDistribution normal_forces(const Packing& p, const Selection& contacts, const ForceBins& bins) {
  return distribution(p, contacts, bins, normal_force);
}

ForceDistribution tangential_forces(const Packing& p, const Selection& contacts, const ForceBins& bins) {
  return distribution(p, contacts, bins, tangential_force);
}

double Mobilisation::sliding_share() const {
  return contacts > 0 ? static_cast<double>(sliding) / static_cast<double>(contacts) : 0;
}

Mobilisation mobilisation(const Packing& p, const Selection& contacts, double friction, int bins) {
  require(friction > 0 && bins > 0, "a friction above zero");
  Mobilisation found;
  std::vector<double> shares;
  double sum = 0;
  for (const std::size_t n : contacts) {
    const double normal = normal_force(p.contacts[n]), tangential = tangential_force(p.contacts[n]);
    if (!(friction * normal > 0)) continue;
    double share = tangential / (friction * normal);
    found.sliding += at_coulomb_limit(tangential, normal, friction);
    if (at_coulomb_limit(tangential, normal, friction, -coulomb_tolerance))
      ++found.beyond;
    else
      share = std::min(share, 1.0);
    shares.push_back(share);
    sum += share;
  }
  found.contacts = static_cast<std::int64_t>(shares.size());
  if (!shares.empty()) found.mean = sum / static_cast<double>(shares.size());
  std::vector<double> edges;
  for (int n = 0; n <= bins; ++n) edges.push_back(static_cast<double>(n) / bins);
  found.histogram = histogram(shares, edges);
  return found;
}

}  // namespace furnas
