#include "cases/program/sweep/points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/statistics/maximum.h"

namespace furnas {
namespace {

Point begin_point(const SampleRow& row) {
  Point point;
  point.values = row.values;
  point.size_ratio = row.size_ratio;
  point.small_fraction = row.small_fraction;
  point.friction = row.friction;
  point.pressure = row.pressure;
  point.preset = row.preset;
  return point;
}

void count(Point& point, const SampleRow& row) {
  point.count(row);
  point.large = std::max(point.large, row.large);
  point.small = std::max(point.small, row.small);
}

std::optional<MeanInterval> mean_of(const std::vector<double>& samples) {
  if (samples.empty()) return {};
  return mean_interval(samples);
}

void take_means(Point& point, const std::vector<const SampleRow*>& ended) {
  double bounds = 0;  // sum over the settled samples
  std::vector<double> Z;
  std::array<std::vector<double>, 3> large, small;
  for (const SampleRow* row : ended) {
    point.phi_J.push_back(row->density());
    if (row->settled()) bounds += row->phi_bound;
    Z.push_back(row->Z_backbone);
    point.effective_size += row->backbone;
    for (std::size_t n = 0; n < 3; ++n) {
      if (row->large > 0)
        large[n].push_back(static_cast<double>(row->large_rattlers[n]) / static_cast<double>(row->large));
      if (row->small > 0)
        small[n].push_back(static_cast<double>(row->small_rattlers[n]) / static_cast<double>(row->small));
    }
  }
  point.mean_phi_J = mean_of(point.phi_J);
  if (!ended.empty()) point.phi_bound = bounds / static_cast<double>(ended.size());
  if (point.mean_phi_J) point.mean_phi_J->half_width += point.phi_bound;
  point.mean_Z_backbone = mean_of(Z);
  for (std::size_t n = 0; n < 3; ++n) {
    point.large_rattlers[n] = mean_of(large[n]);
    point.small_rattlers[n] = mean_of(small[n]);
  }
}

/// The thickness of the cell or, if unknown, its upper bound: at given volume no cell is thicker than a cube.
double thickness_at_most(const SampleRow& row) {
  if (std::isfinite(row.thickness)) return row.thickness;
  const double spheres =
      static_cast<double>(row.large) * std::pow(row.size_ratio, 3) +
      static_cast<double>(row.small);  // volume of the spheres, in volumes of a small sphere
  const double volume = std::numbers::pi / 6 * spheres / row.density();
  return std::cbrt(volume) / (row.large > 0 ? row.size_ratio : 1);
}

void take_thickness(Point& point, const std::vector<const SampleRow*>& ended) {
  for (const SampleRow* row : ended) {
    point.thickness =
        std::fmin(point.thickness, row->thickness);  // ignores NaN, a thickness that is not known
    point.thickness_at_most = std::min(point.thickness_at_most, thickness_at_most(*row));
  }
}

}  // namespace

std::vector<Point> points_of(const SampleTable& table) {
  std::vector<Point> points;
  std::map<std::vector<std::string>, std::size_t> place;
  std::vector<std::vector<const SampleRow*>> ended;
  for (const SampleRow& row : table.rows) {
    const auto [found, fresh] = place.emplace(row.values, points.size());
    if (fresh) {
      points.push_back(begin_point(row));
      ended.emplace_back();
    }
    count(points[found->second], row);
    if (row.jammed() || row.settled()) ended[found->second].push_back(&row);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    take_means(points[k], ended[k]);
    take_thickness(points[k], ended[k]);
  }
  return points;
}

std::vector<Curve> curves_of(const std::vector<Point>& points, const std::vector<std::string>& keys) {
  std::vector<Curve> curves;
  std::map<std::vector<std::string>, std::size_t> place;
  for (const Point& point : points) {
    if (!point.mean_phi_J) continue;
    std::vector<std::string> others;
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k] != fraction_key) others.push_back(point.values[k]);
    const auto [found, fresh] = place.emplace(others, curves.size());
    if (fresh) curves.emplace_back();
    curves[found->second].points.push_back(point);
  }
  for (Curve& curve : curves)
    std::sort(curve.points.begin(), curve.points.end(),
              [](const Point& a, const Point& b) { return a.small_fraction < b.small_fraction; });
  return curves;
}

std::optional<CurveMaximum> maximum_of(const Curve& curve) {
  if (curve.points.size() < 3) return {};
  std::vector<double> f, phi;
  for (const Point& point : curve.points)
    for (const double sample : point.phi_J) {
      f.push_back(point.small_fraction);
      phi.push_back(sample);
    }
  const auto highest = std::max_element(
      curve.points.begin(), curve.points.end(),
      [](const Point& a, const Point& b) { return a.mean_phi_J->mean < b.mean_phi_J->mean; });
  const Maximum m = find_maximum(f, phi);
  const auto place = static_cast<std::size_t>(highest - curve.points.begin());
  const bool inside = place > 0 && place + 1 < curve.points.size();
  return CurveMaximum{*highest->mean_phi_J, highest->small_fraction, place, inside, m.at, m.low, m.high};
}

}  // namespace furnas
