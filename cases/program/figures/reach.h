#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "cases/program/figures/study.h"

namespace furnas {

/// How far the mean of a point may be from that of many large packings: half of its 95 % interval.
///
/// From three samples on it is Student's interval of the samples. One or two samples tell next to nothing of
/// their scatter. At size ratios from 5 on theirs is pooled over the points of a group: those with two
/// samples or more that have size ratio 5 or more, like the point have friction or none, and lie on the same
/// side of f_max (below, near, above). In a second group the same spheres carry the load: the large ones
/// alone (most small ones are rattlers), or small ones, too. The group that scatters more counts, because
/// near f_max packings of both kinds occur. The scatter of a sample is taken to fall with the number of large
/// spheres, as N_l^-1/2. That was measured below f_max (docs/results/study.md, "The number of spheres").
/// Elsewhere it makes intervals wider, because the points with few samples have fewer large spheres.
class Reach {
 public:
  explicit Reach(const Study& study);

  /// Of phi_J. Infinite for a cell too thin. Where the study tells nothing of the scatter it is Student's for
  /// two samples; a single sample of 1000 large spheres or more has twice the standard deviation of
  /// docs/results/verification.md, and a smaller one is infinite.
  double of_phi_J(const Point& point) const;

  /// Of the share of rattlers among the small spheres; `threshold` 0, 1, 2 is z_min 2, 3, 4.
  double of_small_rattlers(const Point& point, std::size_t threshold) const;

  /// Whether of_phi_J() follows from a pooled scatter.
  bool pools(const Point& point) const;

 private:
  enum class Group { below, near, above, large_carry, all_carry };
  struct Scatter {
    PooledDeviation phi_J;
    std::array<PooledDeviation, 3> small_rattlers;
  };
  using Kind = std::pair<bool, Group>;  ///< whether there is friction; the group

  std::vector<Kind> kinds_of(const Point& point) const;               ///< none where f_max is not known
  std::vector<const Scatter*> scatters_of(const Point& point) const;  ///< none where nothing is pooled

  /// The half width that the groups of a point give to one of its quantities, `of`(scatter); none where
  /// nothing is pooled.
  template <class Of>
  std::optional<double> pooled(const Point& point, Of&& of) const;

  std::map<std::pair<double, double>, double> f_max_;  ///< by size ratio and friction
  std::map<Kind, Scatter> scatters_;
};

}  // namespace furnas
