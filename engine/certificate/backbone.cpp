#include "engine/certificate/backbone.h"

#include <Eigen/Dense>
#include <array>
#include <numeric>

namespace furnas {
namespace {

/// Contacts that count: their normal force exceeds a share of the mean normal force of their kind
/// (large-large, large-small, small-small).
std::vector<const StaticContact*> counting(const ContactNetwork& network, const std::vector<Species>& species,
                                           double share) {
  const auto kind = [&](const StaticContact& c) {
    return static_cast<std::size_t>(species[c.i]) + static_cast<std::size_t>(species[c.j]);
  };
  std::array<double, 3> sum{};
  std::array<double, 3> count{};
  for (const StaticContact& c : network.contacts) sum[kind(c)] += c.normal_force, ++count[kind(c)];
  std::vector<const StaticContact*> all;
  for (const StaticContact& c : network.contacts)
    if (c.normal_force * count[kind(c)] > share * sum[kind(c)]) all.push_back(&c);
  return all;
}

/// A union-find structure that also holds the offsets of particles against each other in whole cells.
/// Particles are joined contact by contact.
class Pieces {
 public:
  using Cells = Eigen::Matrix<std::int64_t, 3, 1>;

  explicit Pieces(std::size_t count) : parent_(count), offset_(count, Cells::Zero()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// The piece of a particle and the particle's offset against the piece's root.
  std::pair<std::uint32_t, Cells> find(std::uint32_t k) {
    std::uint32_t root = k;
    Cells sum = Cells::Zero();
    while (parent_[root] != root) sum += offset_[root], root = parent_[root];
    const Cells whole = sum;
    while (parent_[k] != root && k != root) {
      const std::uint32_t next = parent_[k];
      const Cells own = offset_[k];
      parent_[k] = root, offset_[k] = sum;
      sum -= own;
      k = next;
    }
    return {root, whole};
  }

  /// Puts i and j into one piece such that j's image lies `cells` away from i's cell.
  void join(std::uint32_t i, std::uint32_t j, const Cells& cells) {
    const auto [a, of_i] = find(i);
    const auto [b, of_j] = find(j);
    if (a == b) return;
    parent_[b] = a;
    offset_[b] = of_i + cells - of_j;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<Cells> offset_;
};

Pieces::Cells cells_of(const StaticContact& c) { return {c.cells[0], c.cells[1], c.cells[2]}; }

}  // namespace

Backbone find_backbone(const ContactNetwork& network, const std::vector<Species>& species,
                       const CoreRule& rule) {
  const auto contacts = counting(network, species, rule.force_share);
  Backbone core;
  core.contains.assign(species.size(), true);
  const auto weight = [&](const StaticContact& c) { return rule.by_constraints && c.sliding ? 2 : 3; };
  const int least = 3 * rule.least_contacts;
  std::vector<int> degree;
  for (bool gone = true; gone;) {
    gone = false;
    degree.assign(species.size(), 0);
    for (const StaticContact* c : contacts)
      if (core.contains[c->i] && core.contains[c->j]) degree[c->i] += weight(*c), degree[c->j] += weight(*c);
    for (std::size_t k = 0; k < species.size(); ++k)
      if (core.contains[k] && degree[k] < least) core.contains[k] = false, gone = true;
  }

  std::vector<int> to_members(species.size(), 0);
  for (const StaticContact* c : contacts) {
    if (core.contains[c->j]) to_members[c->i] += weight(*c);
    if (core.contains[c->i]) to_members[c->j] += weight(*c);
  }
  for (std::uint32_t k = 0; k < species.size(); ++k) {
    if (core.contains[k]) core.particles.push_back(k);
    if (core.contains[k] != (to_members[k] >= least)) ++core.rule_breaks;
  }
  for (const StaticContact& c : network.contacts)
    if (core.contains[c.i] && core.contains[c.j]) core.bonds.push_back(&c);
  return core;
}

Percolation percolation(const Backbone& backbone) {
  Pieces pieces(backbone.contains.size());
  for (const StaticContact* c : backbone.bonds) pieces.join(c->i, c->j, cells_of(*c));

  // A path along bonds that returns to its first particle in another cell has crossed the packing.
  std::vector<Eigen::Matrix3d> crossings(backbone.contains.size(), Eigen::Matrix3d::Zero());
  for (const StaticContact* c : backbone.bonds) {
    const auto [root, of_i] = pieces.find(c->i);
    const Eigen::Vector3d loop = (of_i + cells_of(*c) - pieces.find(c->j).second).cast<double>();
    crossings[root] += loop * loop.transpose();
  }
  std::vector<std::int64_t> size(backbone.contains.size(), 0);
  for (const std::uint32_t k : backbone.particles) ++size[pieces.find(k).first];

  Percolation found;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < size.size(); ++k) {
    found.pieces += size[k] > 0;
    if (size[k] > size[largest]) largest = k;
  }
  if (backbone.particles.empty()) return found;
  found.largest_piece = size[largest];
  found.directions = static_cast<int>(Eigen::FullPivLU<Eigen::Matrix3d>(crossings[largest]).rank());
  return found;
}

}  // namespace furnas
