#pragma once

#include <array>
#include <map>

#include "cases/program/figures/study.h"

namespace furnas {

/// How far the mean of a point may be from that of many large packings: half of its 95 % interval.
///
/// From three samples on it is Student's interval of the samples. One or two samples tell next to nothing of
/// their scatter. Theirs is pooled over the points of the study with two samples or more that have size ratio
/// 5 or more and lie on the same side of the f_max of the model; the scatter of a sample is taken to fall
/// with the number of large spheres, as N_l^-1/2 (docs/results/study.md, "The number of spheres").
class Reach {
 public:
  explicit Reach(const Study& study);

  /// Of phi_J. Infinite for a cell too thin, and for one or two samples if the study tells nothing of their
  /// scatter; a single sample of 1000 large spheres or more then has twice the standard deviation of
  /// docs/results/verification.md.
  double of_phi_J(const Point& point) const;

  /// Of the share of rattlers among the small spheres; `threshold` 0, 1, 2 is z_min 2, 3, 4.
  double of_small_rattlers(const Point& point, std::size_t threshold) const;

  /// Whether the scatter of the point is a pooled one.
  bool pools(const Point& point) const;

 private:
  enum class Side { below, near, above };
  struct Scatter {
    PooledDeviation phi_J;
    std::array<PooledDeviation, 3> small_rattlers;
  };

  std::optional<Side> side(const Point& point) const;   ///< none without a model
  const Scatter* scatter_of(const Point& point) const;  ///< nullptr where the point has its own

  std::map<double, double> f_max_;  // of the model, by friction
  std::map<Side, Scatter> scatters_;
};

}  // namespace furnas
