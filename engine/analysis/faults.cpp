#include "engine/analysis/faults.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "engine/base/random.h"

namespace furnas {
namespace {

bool finite(const Ledger& l) {
  return std::isfinite(l.initial + l.cell_work + l.losses.total() + l.quenched + l.last.losses.total()) &&
         finite(l.last.push);
}

std::string name(std::size_t k) { return std::to_string(k + 1); }
std::string names(const Contact& c) { return name(c.i) + " and " + name(c.j); }

std::string at(const Packing& p) { return " at step " + std::to_string(p.step); }

std::string not_finite(const Packing& p) {
  if (!finite(p.cell.edges) || !finite(p.cell.rate))
    return "an edge of the cell or its rate is not finite" + at(p);
  if (!p.stress.contacts.allFinite() || !p.stress.motion.allFinite())
    return "a component of the stress is not finite" + at(p);
  if (!finite(p.ledger)) return "a sum of the energy ledger is not finite" + at(p);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::pair<const char*, const Vec3<double>&> values[] = {
        {"velocity", p.velocity[k]}, {"spin", p.spin[k]}, {"force", p.force[k]}, {"torque", p.torque[k]}};
    for (const auto& [what, value] : values)
      if (!finite(value))
        return "the " + std::string(what) + " of particle " + name(k) + " is not finite" + at(p);
  }
  for (const Contact& c : p.contacts)
    if (!finite(c.force) || !finite(c.history) || !finite(c.branch))
      return "the force or the history of the contact of particles " + names(c) + " is not finite" + at(p);
  return {};
}

std::string run_through(const Packing& p) {
  for (const Contact& c : p.contacts) {
    const double share = c.overlap / (p.radius[c.i] + p.radius[c.j]);
    if (share > deepest_overlap)
      return "particles " + names(c) +
             " have run into each other until their centres nearly coincide (overlap " +
             std::to_string(share) + " of the sum of their radii)" + at(p) + "; press more slowly";
  }
  return {};
}

struct Touching {
  std::uint32_t partner{};
  double overlap{};  ///< [d_s]
};

/// Calls what(k) for each whole k for which |lean + k| edge < reach.
template <class What>
void for_images(double lean, double edge, double reach, What&& what) {
  const int last = static_cast<int>(std::floor(reach / edge - lean));
  for (int k = static_cast<int>(std::ceil(-reach / edge - lean)); k <= last; ++k) what(lean + k);
}

/// All spheres and images that overlap particle i, without a list. The cell is triangular: the third
/// component of a branch bounds its third image, then the second the second, then the first.
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

/// The first of `these` without its like among `others`. A touch thinner than rounding may be missing.
std::optional<Touching> unmatched(const std::vector<Touching>& these, const std::vector<Touching>& others) {
  constexpr double rounding = 1e-9;  // [d_s] of edges and radii up to 1e5
  for (const Touching& t : these) {
    const auto same = [&](const Touching& o) {
      return o.partner == t.partner && std::abs(o.overlap - t.overlap) < rounding;
    };
    if (t.overlap > rounding && std::none_of(others.begin(), others.end(), same)) return t;
  }
  return {};
}

}  // namespace

double stiffest_step(const Packing& p, const Model& model) {
  const auto contact = std::visit(
      [](const auto& law) { return law.spins ? std::max(2.0, 7 * law.constants.tangential_stiffness) : 2.0; },
      model.law);
  std::vector<int> contacts(p.size());
  for (const Contact& c : p.contacts) ++contacts[c.i], ++contacts[c.j];
  double square = 0;
  for (std::size_t k = 0; k < p.size(); ++k) square = std::max(square, contact * contacts[k] / p.mass[k]);
  return model.time_step * std::sqrt(square);
}

std::string fault_of(const Packing& p, const Model& model) {
  if (std::string fault = not_finite(p); !fault.empty()) return fault;
  const double phi = p.fraction_filled();
  if (phi > 1)
    return "the spheres fill " + std::to_string(phi) + " of the cell" + at(p) +
           "; the pressure is too high for their stiffness";
  if (std::string fault = run_through(p); !fault.empty()) return fault;
  constexpr double limit = 2;
  if (const double step = stiffest_step(p, model); step > limit)
    return "the time step is too long for the contacts" + at(p) +
           ": times their stiffest frequency it may reach " + std::to_string(step) +
           ", allowed up to 2; take " + std::to_string(limit / step) + " of it";
  return {};
}

std::string audit_contacts(const Packing& p, std::size_t sample, std::uint64_t key) {
  std::map<std::uint32_t, std::vector<Touching>> listed;  // by the particles that are watched
  for (std::uint32_t n = 0; n < std::min(sample, p.size()); ++n)
    listed[sample < p.size() ? static_cast<std::uint32_t>(philox({n, 0, 0, 0}, key)[0] % p.size()) : n];
  const auto list = [&](std::uint32_t i, std::uint32_t j, double overlap) {
    if (const auto watched = listed.find(i); watched != listed.end()) watched->second.push_back({j, overlap});
  };
  for (const Contact& c : p.contacts) list(c.i, c.j, c.overlap), list(c.j, c.i, c.overlap);

  for (const auto& [i, contacts] : listed) {
    const std::vector<Touching> all = touching(p, i);
    const auto sentence = [&, i = i](const Touching& t, const char* what) {
      return "the neighbour list " + std::string(what) + " particles " + name(i) + " and " + name(t.partner) +
             " (overlap " + std::to_string(t.overlap) + " d_s)" + at(p) + "; this is an error of the program";
    };
    if (const auto missed = unmatched(all, contacts)) return sentence(*missed, "has missed the contact of");
    if (const auto extra = unmatched(contacts, all)) return sentence(*extra, "has a contact that is none of");
  }
  return {};
}

}  // namespace furnas
