#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"
#include "engine/statistics/statistics.h"
#include "io/output_field.h"
#include "io/result.h"

namespace furnas {

/// The samples with the same values of the keys, taken together. Means are over the jammed and the settled
/// samples. A settled sample's phi is used as its phi_J; the mean of the bounds of settled samples widens the
/// interval of phi_J.
struct Point : VerdictCounts {
  std::vector<std::string> values;                          ///< of the keys
  double size_ratio = 1;                                    ///< alpha
  double small_fraction{};                                  ///< f_s
  double friction{};                                        ///< mu
  std::int64_t large{}, small{};                            ///< particles of each species in a sample
  std::vector<double> phi_J;                                ///< of the jammed and settled samples
  std::optional<MeanInterval> mean_phi_J, mean_Z_backbone;  ///< none without such a sample
  std::array<std::optional<MeanInterval>, 3> large_rattlers, small_rattlers;  ///< shares, with z_min 2, 3, 4
  double phi_bound{};  ///< mean of the bounds of settled samples, 0 for jammed ones; part of the interval
  /// Number of backbone spheres of all these samples together. Where the small spheres are rattlers only
  /// large spheres count.
  double effective_size{};
  /// Thickness of the thinnest cell of these samples, in diameters of the largest sphere; NaN if not known.
  double thickness = std::numeric_limits<double>::quiet_NaN();
  /// Upper bound of the thickness: the thickness if known, else that of a cube of the same volume. Infinite
  /// without a sample.
  double thickness_at_most = std::numeric_limits<double>::infinity();
  double pressure = std::numeric_limits<double>::quiet_NaN();  ///< p_a [k_n/d_s]; NaN if not known
  std::string preset;                                          ///< of the case; empty if not known

  /// Whether one of its cells is so thin that it is too thin to represent a large packing (io/result.h).
  bool too_thin() const { return thickness_at_most < least_thickness; }
};

/// "4.1"; "at most 3.1" where only the bound is known; "-" without a sample.
std::string thickness_text(const Point& point);

/// A column of points.csv after those of the keys. A mean is followed by a column of its half width.
struct PointColumn {
  OutputField about;
  std::string (*cell)(const Point&);  ///< its text; empty if not known
  const std::optional<MeanInterval>& (*mean)(const Point&) =
      nullptr;               ///< for a column of a mean, instead of `cell`
  std::string_view title{};  ///< title of a mean on the axis of a chart
};

/// All columns, in the order of the file.
std::span<const PointColumn> point_columns();

/// The name of the column after that of a mean.
std::string name_of_half_width(const PointColumn& column);

/// The points of a table, in its order.
std::vector<Point> points_of(const SampleTable& table);

/// As text: a row for each point.
std::string csv(const std::vector<Point>& points, const std::vector<std::string>& keys);

/// phi_J against f_s at one size ratio and friction (and one value of each other key).
struct Curve {
  std::vector<Point> points;  ///< f_s ascending

  double size_ratio() const { return points.front().size_ratio; }
  double friction() const { return points.front().friction; }
};

/// Groups the points that differ only in small_fraction. Points without a jammed or settled sample are left
/// out.
std::vector<Curve> curves_of(const std::vector<Point>& points, const std::vector<std::string>& keys);

/// Where a curve is highest.
struct CurveMaximum {
  MeanInterval phi_max;                       ///< phi_J of the highest point
  double at{};                                ///< f_s of that point
  std::size_t place{};                        ///< of that point in the curve
  bool inside{};                              ///< whether it lies between the ends of the curve
  double f_max{}, f_max_low{}, f_max_high{};  ///< f_max with its interval, from `find_maximum`
};

/// The maximum of a curve of three points or more.
std::optional<CurveMaximum> maximum_of(const Curve& curve);

}  // namespace furnas
