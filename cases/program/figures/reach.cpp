#include "cases/program/figures/reach.h"

#include <cmath>
#include <limits>

namespace furnas {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t enough = 3;  // samples from which on a point knows its own scatter

// Below this size ratio small spheres do not pass between three large ones that touch, or barely (6.46), and
// do not become rattlers all at once.
constexpr double least_ratio = 5;

/// Scatter of a sample, as a multiple of that of a sample with one large sphere.
double unit_of(const Point& point) { return 1 / std::sqrt(static_cast<double>(point.large)); }

/// The f_max of a curve that is highest between its ends; else that of the model, if there is one.
std::optional<double> f_max_of(const Study& study, const Curve& curve) {
  const auto maximum = maximum_of(curve);
  if (maximum && maximum->inside) return maximum->f_max;
  const auto model = study.model(curve.friction());
  return model ? std::optional(model->middle().f_max()) : std::nullopt;
}

}  // namespace

Reach::Reach(const Study& study) {
  for (const Curve& curve : study.curves) {
    if (curve.size_ratio() < least_ratio) continue;
    if (const auto f_max = f_max_of(study, curve)) f_max_[{curve.size_ratio(), curve.friction()}] = *f_max;
    for (const Point& point : curve.points) {
      const auto kind = kind_of(point);
      if (!kind || point.large == 0) continue;
      Scatter& scatter = scatters_[*kind];
      scatter.phi_J.add(mean_interval(point.phi_J), unit_of(point));
      for (std::size_t k = 0; k < 3; ++k)
        if (point.small_rattlers[k]) scatter.small_rattlers[k].add(*point.small_rattlers[k], unit_of(point));
    }
  }
}

std::optional<Reach::Kind> Reach::kind_of(const Point& point) const {
  constexpr double near = 0.03;
  const auto found = f_max_.find({point.size_ratio, point.friction});
  if (found == f_max_.end()) return {};
  const double off = point.small_fraction - found->second;
  return Kind{point.friction > 0, off < -near ? Side::below : off > near ? Side::above : Side::near};
}

const Reach::Scatter* Reach::scatter_of(const Point& point) const {
  constexpr std::size_t least_degrees = 5;
  if (point.phi_J.size() >= enough || point.large == 0) return nullptr;
  const auto kind = kind_of(point);
  const auto found = kind ? scatters_.find(*kind) : scatters_.end();
  return found != scatters_.end() && found->second.phi_J.degrees_of_freedom() >= least_degrees
             ? &found->second
             : nullptr;
}

bool Reach::pools(const Point& point) const { return !point.too_thin() && scatter_of(point) != nullptr; }

double Reach::of_phi_J(const Point& point) const {
  constexpr double scatter_of_large = 0.004;
  constexpr std::int64_t many = 1000;
  if (point.too_thin()) return infinity;
  if (const Scatter* pooled = scatter_of(point))
    return pooled->phi_J.half_width(point.phi_J.size(), unit_of(point)) + point.phi_bound;
  if (point.phi_J.size() > 1) return point.mean_phi_J->half_width;
  return point.large >= many ? scatter_of_large : infinity;
}

double Reach::of_small_rattlers(const Point& point, std::size_t threshold) const {
  if (const Scatter* pooled = scatter_of(point))
    return pooled->small_rattlers[threshold].half_width(point.phi_J.size(), unit_of(point));
  return point.small_rattlers[threshold]->half_width;
}

}  // namespace furnas
