#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"
#include "engine/statistics/statistics.h"

namespace furnas {

/// What the samples with the same values of the keys say together. Means are those of the jammed ones,
/// and of settled ones, whose phi stands for phi_J: its interval is wider by the mean of their bounds.
struct Point {
  std::vector<std::string> values;  ///< of the keys
  double size_ratio = 1;            ///< alpha
  double small_fraction{};          ///< f_s
  double friction{};                ///< mu
  std::int64_t large{}, small{};    ///< particles of each species in a sample
  std::size_t samples{};
  std::size_t jammed{}, settled{}, budget{}, diverged{}, failed{}, unfinished{};  ///< samples of each verdict
  std::vector<double> phi_J;                                ///< of the jammed and settled ones
  std::optional<MeanInterval> mean_phi_J, mean_Z_backbone;  ///< none without such a sample
  std::array<std::optional<MeanInterval>, 3> large_rattlers, small_rattlers;  ///< shares, with z_min 2, 3, 4
  /// Backbone spheres of all these samples together: what the mean rests on. Where the small spheres rattle
  /// only the large ones count.
  double effective_size{};
};

/// The points of a table, in its order.
std::vector<Point> points_of(const SampleTable& table);

/// As text: a row for each point.
std::string csv(const std::vector<Point>& points, const std::vector<std::string>& keys);

/// phi_J against f_s of one size ratio and friction (and of one value of each other key).
struct Curve {
  std::vector<Point> points;  ///< f_s ascending

  double size_ratio() const { return points.front().size_ratio; }
  double friction() const { return points.front().friction; }
};

/// The points that share all but their small_fraction; those without a jammed or settled sample are left out.
std::vector<Curve> curves_of(const std::vector<Point>& points, const std::vector<std::string>& keys);

/// Where a curve is highest.
struct CurveMaximum {
  MeanInterval phi_max;                       ///< of its highest point
  double at{};                                ///< f_s of that point
  double f_max{}, f_max_low{}, f_max_high{};  ///< with its interval, as `find_maximum` has it
};

/// The maximum of a curve of three points or more.
std::optional<CurveMaximum> maximum_of(const Curve& curve);

}  // namespace furnas
