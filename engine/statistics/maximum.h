#pragma once

#include <vector>

namespace furnas {

/// The place of the maximum of a curve, with its interval.
struct Maximum {
  double at{};
  double low{}, high{};  ///< ends of the interval, for the given confidence

  double half_width() const { return (high - low) / 2; }
};

/// The place of the maximum of y(x), y > 0, from samples that scatter. The x may be in any order and may have
/// several samples each; at least three different x are needed.
///
/// 1/y is fitted by a hyperbola, a + b x + c sqrt((x - x_0)^2 + s^2): two straight branches and a bend of any
/// width. The generalized Furnas model is such a curve with s = 0 and x = f_s; the other limit of the
/// hyperbola is a parabola. The interval contains the minima of all hyperbolas that an F test cannot
/// distinguish from the best one. With five different x or fewer the interval extends from the left to the
/// right neighbour of the highest mean. At an end of the curve, where one neighbour is missing, it extends as
/// far beyond the end as to the other side.
Maximum find_maximum(const std::vector<double>& x, const std::vector<double>& y, double confidence = 0.95);

}  // namespace furnas
