#include "engine/monitor/audit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "engine/base/random.h"

namespace furnas {
namespace {

struct Touching {
  std::uint32_t partner{};
  double overlap{};  ///< [d_s]
};

/// Calls what(lean + k) for each whole number k with |lean + k| edge < reach.
template <class What>
void for_images(double lean, double edge, double reach, What&& what) {
  const int last = static_cast<int>(std::floor(reach / edge - lean));
  for (int k = static_cast<int>(std::ceil(-reach / edge - lean)); k <= last; ++k) what(lean + k);
}

/// All spheres and images that overlap particle i, found without a neighbour list. Because the matrix of the
/// cell is triangular, the z component of the branch depends only on the image along the third edge. The
/// images along the third edge are therefore bounded first, then those along the second and first edge.
std::vector<Touching> touching(const Packing& p, std::uint32_t i) {
  const Triangle& h = p.cell.edges;
  std::vector<Touching> found;
  for (std::uint32_t j = 0; j < p.size(); ++j) {
    const double reach = p.radius[i] + p.radius[j];
    const Vec3<double> d = nearest_difference(p.fraction[i], p.fraction[j]);
    for_images(d.z, h.zz, reach, [&](double z) {
      for_images(d.y + h.yz * z / h.yy, h.yy, reach, [&](double y) {
        const double across = y * h.yy;
        const double sy = (across - h.yz * z) / h.yy;
        for_images(d.x + (h.xy * sy + h.xz * z) / h.xx, h.xx, reach, [&](double x) {
          const double distance = norm(Vec3<double>{x * h.xx, across, z * h.zz});
          if (distance < reach && distance > 0) found.push_back({j, reach - distance});
        });
      });
    });
  }
  return found;
}

/// The first contact in `these` without an equal one in `others`. Contacts with an overlap below rounding may
/// be missing.
std::optional<Touching> unmatched(const std::vector<Touching>& these, const std::vector<Touching>& others) {
  constexpr double rounding = 1e-9;  // [d_s] for edges and radii up to 1e5
  for (const Touching& t : these) {
    const auto same = [&](const Touching& o) {
      return o.partner == t.partner && std::abs(o.overlap - t.overlap) < rounding;
    };
    if (t.overlap > rounding && std::none_of(others.begin(), others.end(), same)) return t;
  }
  return {};
}

}  // namespace

std::string audit_contacts(const Packing& p, std::size_t sample, std::uint64_t key) {
  std::map<std::uint32_t, std::vector<Touching>> listed;  // contacts by audited particle
  for (std::uint32_t n = 0; n < std::min(sample, p.size()); ++n)
    listed[sample < p.size() ? static_cast<std::uint32_t>(philox({n, 0, 0, 0}, key)[0] % p.size()) : n];
  const auto list = [&](std::uint32_t i, std::uint32_t j, double overlap) {
    if (const auto watched = listed.find(i); watched != listed.end()) watched->second.push_back({j, overlap});
  };
  for (const Contact& c : p.contacts) list(c.i, c.j, c.overlap), list(c.j, c.i, c.overlap);

  for (const auto& [i, contacts] : listed) {
    const std::vector<Touching> all = touching(p, i);
    const auto sentence = [&, i = i](const Touching& t, const char* what) {
      return "the neighbour list " + std::string(what) + " particles " + std::to_string(p.id(i)) + " and " +
             std::to_string(p.id(t.partner)) + " (overlap " + std::to_string(t.overlap) + " d_s) at step " +
             std::to_string(p.step) + "; this is an error of the program";
    };
    if (const auto missed = unmatched(all, contacts)) return sentence(*missed, "has missed the contact of");
    if (const auto extra = unmatched(contacts, all)) return sentence(*extra, "has a contact that is none of");
  }
  return {};
}

}  // namespace furnas
