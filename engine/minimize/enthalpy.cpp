#include "engine/minimize/enthalpy.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/search/carry_over.h"
#include "engine/search/displacement.h"
#include "engine/search/find_pairs.h"
#include "engine/search/size_classes.h"

namespace furnas {
namespace {

constexpr std::size_t chunk = 512;  // particles

/// Sums over the contacts in look().
struct ContactTotals {
  double energy{};  ///< [k_n d_s^2]
  double force{};   ///< sum of |F| [k_n d_s]
  Triangle push;    ///< sum of F_a times branch_b at the place [k_n d_s^2]
  std::size_t count{};
  void operator+=(const ContactTotals& b) {
    energy += b.energy;
    force += b.force;
    push += b.push;
    count += b.count;
  }
};

}  // namespace

Enthalpy::Enthalpy(const Packing& p, const AnyLaw& law, const Barostat& bath)
    : law_(law), bath_(bath), id_(p.order.empty() ? memory_order(p) : p.order), edges_(p.cell.edges) {
  if (has_friction(law)) throw InputError("contacts with friction have no energy that positions alone give");
  for (const std::uint32_t k : id_) {
    radius_.push_back(p.radius[k]);
    mass_.push_back(p.mass[k]);
    fraction_.push_back(p.fraction[k]);
    image_.push_back(p.image[k]);
  }
  list_.classes = size_classes(radius_);
  renew_list();
}

void Enthalpy::renew_list() {
  constexpr double share = 0.1;  // of the smallest diameter: displacements are small here
  constexpr double strain = 0.01;
  list_.skin = {share * 2 * list_.classes.back().smallest_radius, strain};
  list_.reference = fraction_;
  find_pairs(bin_classes(list_.classes, list_.skin, edges_, fraction_), edges_, radius_, list_);
  branch_.resize(list_.rows());
  force_.resize(list_.rows());
  for_chunks(particles(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) {
        const Fraction& mine = fraction_[i];
        const Fraction& other = fraction_[list_.partner[k]];
        branch_[k] = edges_ * (list_.quarter.empty() ? nearest_difference(mine, other)
                                                     : row_difference(mine, other, list_.quarter[k]));
      }
  });
}

bool Enthalpy::covers(const Shift& shift) const {
  const double strain = strain_between(edges_, edges_ + product(shift.strain, edges_));
  if (strain >= 1) return false;
  std::vector<double> moved;
  for (const SizeClass& group : list_.classes) {
    const auto square =
        ordered_sum<Largest>(group.last - group.first, chunk, [&](std::size_t begin, std::size_t end) {
          Largest piece;
          for (std::size_t k = group.first + begin; k < group.first + end; ++k)
            piece += {dot(shift.displacement[k], shift.displacement[k])};
          return piece;
        });
    // The list is checked with displacements measured in the cell in which it was built.
    moved.push_back(std::sqrt(square.value) / (1 - strain));
  }
  return rows_are_complete(list_.classes, list_.skin, list_.edges, moved, strain);
}

void Enthalpy::look(const Shift& shift, Point& point) {
  const Triangle& e = shift.strain;
  const ContactTotals total = std::visit(
      [&](const auto& law) {
        return ordered_sum<ContactTotals>(particles(), chunk, [&](std::size_t begin, std::size_t end) {
          ContactTotals piece;
          for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) {
              const std::uint32_t j = list_.partner[k];
              const Vec3<double> branch =
                  branch_[k] + (e * branch_[k] + (shift.displacement[i] - shift.displacement[j]));
              const double reach = radius_[i] + radius_[j];
              const double square = dot(branch, branch);
              force_[k] = {};
              if (square >= reach * reach) continue;
              const double distance = std::sqrt(square);
              const auto touch =
                  resting_touch(radius_[i], radius_[j], reduced_mass(mass_[i], mass_[j]), reach - distance);
              const double push = law.stiffness(touch).push;
              force_[k] = (push / distance) * branch;
              piece.energy += law.energy(touch, {}).normal;
              piece.force += push;
              piece.push += upper_product(force_[k], branch_[k]);
              ++piece.count;
            }
          return piece;
        });
      },
      law_);
  for_chunks(particles(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3<double> sum;
      for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) sum -= force_[k];
      for (std::size_t k = list_.incoming_first[i]; k < list_.incoming_first[i + 1]; ++k)
        sum += force_[list_.incoming[k]];
      point.gradient.displacement[i] = sum;
    }
  });
  const double outside = bath_.pressure * edges_.determinant();
  const double x = 1 + e.xx, y = 1 + e.yy, z = 1 + e.zz;
  point.value = total.energy + outside * x * y * z;
  point.gradient.strain = possible(
      Triangle{outside * y * z, outside * x * z, outside * x * y, 0, 0, 0} - total.push, bath_.freedom);
  point.contacts = total.count;
  point.mean_force = total.count > 0 ? total.force / static_cast<double>(total.count) : 0;
}

Shift Enthalpy::softness() const {
  Shift soft(particles());
  std::vector<double> stiffness(list_.rows());
  const Triangle against_strain = std::visit(
      [&](const auto& law) {
        return ordered_sum<Triangle>(particles(), chunk, [&](std::size_t begin, std::size_t end) {
          Triangle piece;
          for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) {
              const std::uint32_t j = list_.partner[k];
              const double distance = norm(branch_[k]);
              const double overlap = radius_[i] + radius_[j] - distance;
              if (overlap <= 0) continue;
              stiffness[k] = law.stiffness(resting_touch(radius_[i], radius_[j],
                                                         reduced_mass(mass_[i], mass_[j]), overlap))
                                 .normal;
              const Triangle s =
                  upper_product(branch_[k] * (1 / distance), branch_[k]);  // stretch by a strain
              piece += stiffness[k] *
                       Triangle{s.xx * s.xx, s.yy * s.yy, s.zz * s.zz, s.yz * s.yz, s.xz * s.xz, s.xy * s.xy};
            }
          return piece;
        });
      },
      law_);
  for_chunks(particles(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      double sum = 0;
      for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) sum += stiffness[k];
      for (std::size_t k = list_.incoming_first[i]; k < list_.incoming_first[i + 1]; ++k)
        sum += stiffness[list_.incoming[k]];
      const double soft_here = sum > 0 ? 3 / sum : 1;
      soft.displacement[i] = {soft_here, soft_here, soft_here};
    }
  });
  const auto softer = [](double sum) { return sum > 0 ? 1 / sum : 1; };
  soft.strain = {softer(against_strain.xx), softer(against_strain.yy), softer(against_strain.zz),
                 softer(against_strain.yz), softer(against_strain.xz), softer(against_strain.xy)};
  if (bath_.freedom == CellFreedom::cubic)
    soft.strain.xx = soft.strain.yy = soft.strain.zz = softer(against_strain.trace());
  return soft;
}

void Enthalpy::move(const Shift& shift) {
  edges_ += product(shift.strain, edges_);
  const Triangle to_fractions = inverse(edges_);
  for_chunks(particles(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Fraction way = to_fraction(to_fractions * shift.displacement[i]);
      const Fraction before = fraction_[i];
      fraction_[i] = {before.x + way.x, before.y + way.y, before.z + way.z};
      image_[i] = crossed(image_[i], before, fraction_[i]);
    }
  });
  renew_list();
}

double Enthalpy::force_imbalance(const Point& point) const {
  struct Mean {
    double sum{};
    std::size_t count{};
    void operator+=(const Mean& b) { sum += b.sum, count += b.count; }
  };
  const Mean mean = ordered_sum<Mean>(particles(), chunk, [&](std::size_t begin, std::size_t end) {
    Mean piece;
    for (std::size_t i = begin; i < end; ++i) {
      const double force = norm(point.gradient.displacement[i]);
      if (force > 0) piece += {force, 1};
    }
    return piece;
  });
  if (mean.count == 0 || point.mean_force == 0) return 0;
  return mean.sum / static_cast<double>(mean.count) / point.mean_force;
}

double Enthalpy::stress_error(const Point& point) const {
  const Triangle& g = point.gradient.strain;
  const double outside = bath_.pressure * edges_.determinant();
  double largest = 0;
  for (double slope : {g.xx, g.yy, g.zz, g.yz, g.xz, g.xy}) largest = std::max(largest, std::abs(slope));
  return largest / outside;
}

void Enthalpy::put_into(Packing& p) const {
  p.cell = {.edges = edges_, .rate = {}};
  p.contacts.clear();
  p.stress = {};
  p.ledger.last = {};
  std::fill(p.force.begin(), p.force.end(), Vec3<double>{});
  std::fill(p.velocity.begin(), p.velocity.end(), Vec3<double>{});
  for (std::size_t i = 0; i < particles(); ++i) {
    p.fraction[id_[i]] = fraction_[i];
    p.image[id_[i]] = image_[i];
    for (std::size_t k = list_.first[i]; k < list_.first[i + 1]; ++k) {
      const std::uint32_t j = list_.partner[k];
      const double distance = norm(branch_[k]);
      const double reach = radius_[i] + radius_[j];
      if (distance >= reach) continue;
      Contact c;
      c.i = id_[i];
      c.j = id_[j];
      c.image = image_of_row(list_, k, fraction_[i], fraction_[j]);
      c.branch = branch_[k];
      c.overlap = reach - distance;
      const Touch<double> touch =
          resting_touch(radius_[i], radius_[j], reduced_mass(mass_[i], mass_[j]), c.overlap);
      c.force = (stiffness_of(law_, touch).push / distance) * c.branch;
      p.force[c.i] += c.force;
      p.force[c.j] -= c.force;
      p.stress.contacts += Eigen::Vector3d(c.branch.x, c.branch.y, c.branch.z) *
                           Eigen::RowVector3d(c.force.x, c.force.y, c.force.z);
      p.ledger.last.add(c.force, c.branch);
      p.contacts.push_back(c);
    }
  }
}

}  // namespace furnas
