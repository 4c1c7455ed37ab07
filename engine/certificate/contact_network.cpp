#include "engine/certificate/contact_network.h"

#include <algorithm>
#include <utility>

#include "engine/certificate/overlaps.h"

namespace furnas {
namespace {

/// The histories of a packing by pair and image.
class RecordedContacts {
 public:
  explicit RecordedContacts(const Packing& p) : p_(p) {
    for (std::uint32_t n = 0; n < p.contacts.size(); ++n) {
      const Contact& c = p.contacts[n];
      entries_.emplace_back(std::minmax(c.i, c.j), n);
    }
    std::sort(entries_.begin(), entries_.end());
  }

  /// The listed contact of this overlap, and whether it is listed with i and j exchanged; null if it is not
  /// listed.
  std::pair<const Contact*, bool> find(const Overlap& o) const {
    const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(o.i, o.j);
    const double near = 1e-6 * norm(o.branch);
    for (auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{pair, 0});
         at != entries_.end() && at->first == pair; ++at) {
      const Contact& c = p_.contacts[at->second];
      Vec3<double> d = nearest_difference(p_.fraction[c.i], p_.fraction[c.j]);
      d += {double(c.image[0]), double(c.image[1]), double(c.image[2])};
      const Vec3<double> branch = p_.cell.edges * d;
      if (c.i == o.i && norm(branch - o.branch) < near) return {&c, false};
      if (c.j == o.i && norm(branch + o.branch) < near) return {&c, true};
    }
    return {nullptr, false};
  }

 private:
  using Entry = std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;
  const Packing& p_;
  std::vector<Entry> entries_;
};

StaticContact at_rest(const Packing& p, const Springs& springs, const Overlap& o) {
  StaticContact c;
  c.i = o.i, c.j = o.j, c.cells = o.cells, c.branch = o.branch;
  c.distance = norm(o.branch);
  c.normal = o.branch * (1 / c.distance);
  const double overlap = p.radius[o.i] + p.radius[o.j] - c.distance;
  const double mass = reduced_mass(p.mass[o.i], p.mass[o.j]);
  const ContactStiffness stiffness =
      stiffness_of(springs.law, resting_touch(p.radius[o.i], p.radius[o.j], mass, overlap));
  c.normal_force = stiffness.push;
  c.normal_stiffness = stiffness.normal;
  c.tangential_stiffness = stiffness.tangential;
  c.normal_damping = mass * stiffness.normal_damping;
  c.tangential_damping = mass * stiffness.tangential_damping;
  const double shortening = arms_meet(springs.law) ? 0.5 * overlap : 0;
  c.arm_i = p.radius[o.i] - shortening;
  c.arm_j = p.radius[o.j] - shortening;
  return c;
}

void take_history(const Springs& springs, const RecordedContacts& recorded, const Overlap& o,
                  StaticContact& c) {
  const auto [listed, reversed] = recorded.find(o);
  c.known = listed != nullptr;
  if (!listed || springs.friction() == 0) return;
  const Vec3<double> xi = reversed ? -listed->history : listed->history;
  c.tangential_force = -c.tangential_stiffness * (xi - dot(xi, c.normal) * c.normal);
  c.sliding =
      at_coulomb_limit(norm(c.tangential_force), c.normal_force, springs.friction(), springs.at_limit);
}

}  // namespace

ContactNetwork contact_network(const Packing& p, const Springs& springs) {
  ContactNetwork network;
  network.springs = springs;
  network.radius = p.radius;
  network.mass = p.mass;
  network.volume = p.cell.volume();
  const RecordedContacts recorded(p);
  std::int64_t listed = 0;
  for (const Overlap& o : find_overlaps(p)) {
    StaticContact c = at_rest(p, springs, o);
    take_history(springs, recorded, o, c);
    network.mean_force += norm(c.force());
    network.mean_normal_force += c.normal_force;
    ++(c.known ? listed : network.unlisted);
    network.contacts.push_back(c);
  }
  network.open = static_cast<std::int64_t>(p.contacts.size()) - listed;
  if (network.contacts.empty()) return network;
  network.mean_force /= static_cast<double>(network.contacts.size());
  network.mean_normal_force /= static_cast<double>(network.contacts.size());
  return network;
}

}  // namespace furnas
