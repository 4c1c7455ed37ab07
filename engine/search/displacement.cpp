#include "engine/search/displacement.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/base/sphere.h"

namespace furnas {
namespace {

Eigen::Matrix3d dense(const Triangle& t) {
  Eigen::Matrix3d m;
  m << t.xx, t.xy, t.xz, 0, t.yy, t.yz, 0, 0, t.zz;
  return m;
}

}  // namespace

bool list_is_complete(const PairList& list, const std::vector<double>& displacement, double shrunk) {
  return rows_are_complete(list.classes, list.skin, list.edges, displacement, shrunk);
}

bool rows_are_complete(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                       const std::vector<double>& displacement, double shrunk) {
  if (shrunk >= 1) return false;
  const Vec3<double> height = heights(edges);
  // A row still means its image as long as the difference has changed by less than 3/8 of a cell; the limit
  // here is 1/4.
  const double furthest = 0.25 * std::min({height.x, height.y, height.z});
  for (std::size_t a = 0; a < classes.size(); ++a) {
    for (std::size_t b = a; b < classes.size(); ++b) {
      const double moved = displacement[a] + displacement[b];
      const auto holds = [&](double radii) {
        const double reach = radii + skin(radii);
        return moved <= furthest && (1 - shrunk) * (reach - moved) >= radii;
      };
      // The condition is linear in the radii, so it is enough to check the ends of their range.
      if (!holds(classes[a].smallest_radius + classes[b].smallest_radius) ||
          !holds(classes[a].largest_radius + classes[b].largest_radius))
        return false;
    }
  }
  return true;
}

double shrinkage(const Triangle& then, const Triangle& now) {
  const Eigen::Matrix3d f = dense(product(now, inverse(then)));
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(f.transpose() * f, Eigen::EigenvaluesOnly);
  return 1 - std::sqrt(std::max(solver.eigenvalues()(0), 0.0));
}

double shrinkage_bound(const Triangle& then, const Triangle& now) {
  // sigma_min(F) >= 1 - |F - I| in the spectral norm, and strain_between, the Frobenius norm, is at least the
  // spectral norm.
  return strain_between(then, now);
}

bool is_time_to_ask(const PairList& list, std::int64_t step) {
  const std::int64_t age = step - list.step;
  constexpr std::int64_t first = 128;
  return age >= first && std::has_single_bit(static_cast<std::uint64_t>(age));
}

bool is_too_wide(const PairList& list, const std::vector<double>& displacement, double shrunk,
                 std::int64_t step, std::optional<double> fixed) {
  if (fixed) return false;
  const double radii = 2 * list.classes.back().smallest_radius;
  return next_skin(list, displacement, shrunk, step, fixed)(radii) < 0.5 * list.skin(radii);
}

Skin next_skin(const PairList& list, const std::vector<double>& displacement, double shrunk,
               std::int64_t step, std::optional<double> fixed) {
  if (fixed) return {*fixed, 0};
  constexpr double build_cost = 40;     // cost of building a list per particle, in tests of needless pairs
  constexpr double first_fixed = 0.05;  // before the first measurement [smallest diameter]
  constexpr double first_relative = 0.01;
  const SizeClass& smallest = list.classes.back();
  const double diameter = 2 * smallest.smallest_radius;
  const auto life = static_cast<double>(step - list.step);
  if (list.builds == 0 || life <= 0) return {first_fixed * diameter, first_relative};

  const double motion = 2 * *std::max_element(displacement.begin(), displacement.end()) / life;  // [d_s/step]
  const double strain = std::max(shrunk, 0.0) / life;                                            // [1/step]
  // A shell of thickness s around a sphere of diameter d contains 12 filled s/d needless pairs. s, and so
  // this number, grows in proportion to the life of the list.
  const double filled = static_cast<double>(smallest.last - smallest.first) * sphere_volume(diameter / 2) /
                        list.edges.determinant();
  const double growth = 12 * filled * (motion / diameter + strain) + 1e-12;
  const double wanted = std::clamp(std::sqrt(build_cost / growth), 5.0, 5000.0);
  constexpr double margin = 1.2;
  return {std::clamp(margin * motion * wanted, 1e-3 * diameter, 0.5 * diameter),
          std::clamp(margin * strain * wanted, 1e-4, 0.1)};
}

}  // namespace furnas
