#pragma once

#include <vector>

namespace furnas {

/// Where a curve is highest, with an interval.
struct Maximum {
  double at{};
  double low{}, high{};  ///< it lies between these with the confidence asked for

  double half_width() const { return (high - low) / 2; }
};

/// The place of the maximum of y(x), y > 0, from samples that scatter: x in any order, several samples for
/// an x; three different x or more.
///
/// 1/y is fitted by a hyperbola, a + b x + c sqrt((x - x_0)^2 + s^2): two straight branches and a bend of any
/// width. The generalized Furnas model is such a curve (s = 0, in f_s), a parabola is its other limit. The
/// interval holds the places of all hyperbolas that an F test does not tell from the best one. Where there
/// are too few samples for that, the interval reaches from the left to the right neighbour of the highest
/// mean, and as far beyond an end of the curve.
Maximum find_maximum(const std::vector<double>& x, const std::vector<double>& y, double confidence = 0.95);

}  // namespace furnas
