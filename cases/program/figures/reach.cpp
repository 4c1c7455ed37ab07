#include "cases/program/figures/reach.h"

#include <algorithm>
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
      if (point.large == 0) continue;
      for (const Kind& kind : kinds_of(point)) {
        Scatter& scatter = scatters_[kind];
        scatter.phi_J.add(mean_interval(point.phi_J), unit_of(point));
        for (std::size_t k = 0; k < 3; ++k)
          if (point.small_rattlers[k])
            scatter.small_rattlers[k].add(*point.small_rattlers[k], unit_of(point));
      }
    }
  }
}

std::vector<Reach::Kind> Reach::kinds_of(const Point& point) const {
  constexpr double near = 0.03, most = 0.5;
  const auto found = f_max_.find({point.size_ratio, point.friction});
  if (found == f_max_.end()) return {};
  const bool friction = point.friction > 0;
  const double off = point.small_fraction - found->second;
  std::vector<Kind> kinds{{friction, off < -near ? Group::below : off > near ? Group::above : Group::near}};
  const std::size_t threshold = friction ? 0 : 2;  // of the backbone: z_min 2 or 4
  if (const auto& share = point.small_rattlers[threshold])
    kinds.emplace_back(friction, share->mean > most ? Group::large_carry : Group::all_carry);
  return kinds;
}

std::vector<const Reach::Scatter*> Reach::scatters_of(const Point& point) const {
  constexpr std::size_t least_degrees = 5;
  std::vector<const Scatter*> scatters;
  if (point.phi_J.size() >= enough || point.large == 0) return scatters;
  for (const Kind& kind : kinds_of(point)) {
    const auto found = scatters_.find(kind);
    if (found != scatters_.end() && found->second.phi_J.degrees_of_freedom() >= least_degrees)
      scatters.push_back(&found->second);
  }
  return scatters;
}

template <class Of>
std::optional<double> Reach::pooled(const Point& point, Of&& of) const {
  std::optional<double> widest;
  for (const Scatter* scatter : scatters_of(point))
    widest = std::max(widest.value_or(0), of(*scatter).half_width(point.phi_J.size(), unit_of(point)));
  return widest;
}

bool Reach::pools(const Point& point) const { return !point.too_thin() && !scatters_of(point).empty(); }

double Reach::of_phi_J(const Point& point) const {
  constexpr double scatter_of_large = 0.004;
  constexpr std::int64_t many = 1000;
  if (point.too_thin()) return infinity;
  if (const auto half_width = pooled(point, [](const Scatter& s) { return s.phi_J; }))
    return *half_width + point.phi_bound;
  if (point.phi_J.size() > 1) return point.mean_phi_J->half_width;
  return point.large >= many ? scatter_of_large : infinity;
}

double Reach::of_small_rattlers(const Point& point, std::size_t threshold) const {
  const auto half_width = pooled(point, [&](const Scatter& s) { return s.small_rattlers[threshold]; });
  return half_width ? *half_width : point.small_rattlers[threshold]->half_width;
}

}  // namespace furnas
