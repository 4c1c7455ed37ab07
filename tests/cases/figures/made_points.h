#pragma once

#include <utility>
#include <vector>

#include "cases/program/figures/study.h"

namespace furnas {

/// A point whose samples have all jammed.
inline Point point(double size_ratio, double small_fraction, double friction, std::vector<double> phi_J,
                   std::int64_t large = 100) {
  Point p;
  p.size_ratio = size_ratio;
  p.small_fraction = small_fraction;
  p.friction = friction;
  p.large = large;
  p.samples = p.jammed = phi_J.size();
  p.mean_phi_J = mean_interval(phi_J);
  p.phi_J = std::move(phi_J);
  return p;
}

/// A study with samples of size ratio 10 that scatter by +-`scatter` about the model, three a point, and with
/// one sample of size ratio 20 near f_max.
inline Study with_a_lone_sample(double scatter, double phi, std::int64_t large) {
  Study study;
  study.mono = {point(1, 0, 0.3, {0.588, 0.589, 0.590})};
  Curve curve;
  for (const double f : {0.28, 0.29, 0.30}) {
    const double model = FurnasModel{0.589}.phi(f);
    curve.points.push_back(point(10, f, 0.3, {model - scatter, model, model + scatter}));
  }
  study.curves = {curve, {{point(20, 0.29, 0.3, {phi}, large)}}};
  return study;
}

}  // namespace furnas
