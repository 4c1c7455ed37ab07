#pragma once

#include <string>
#include <vector>

namespace furnas {

/// A mark on an axis.
struct Tick {
  double at;          ///< value; on a logarithmic axis its decimal logarithm
  std::string label;  ///< empty: a short mark without a label
};

/// The part of an axis that is drawn, low < high; on a logarithmic axis in decimal logarithms.
struct Stretch {
  double low, high;
};

/// Distance of the marks of a linear axis: 1, 2 or 5 times a power of ten, with at most `most` of them in
/// `length`.
double tick_distance(double length, int most);

/// The stretch, widened so that it begins and ends at marks of a linear axis.
Stretch widened_to_ticks(const Stretch& stretch, int most);

/// Marks at round numbers, all with a label.
std::vector<Tick> linear_ticks(const Stretch& stretch, int most);

/// Marks at 1, 2, ... 9 times the powers of ten; labels at the powers, at most `most` of them, and at 2 and 5
/// in a stretch of less than two powers.
std::vector<Tick> logarithmic_ticks(const Stretch& stretch, int most);

}  // namespace furnas
