#include "cases/program/sweep/refinement.h"

#include <algorithm>
#include <cmath>

#include "io/case_protocol.h"

namespace furnas {
namespace {

double rounded(double value, double unit) {
  const double per = std::round(1 / unit);  // 0.3 is 60/200, while 60 * 0.005 is not 0.3
  return std::round(value * per) / per;
}

/// The wanted value in the coarsest rounding that gives a value not yet known.
double new_fraction(double wanted, const std::vector<double>& known) {
  for (const double unit : {0.01, 0.005, 0.0025, 0.001}) {
    const double f = rounded(wanted, unit);
    if (f > 0 && f < 1 &&
        std::none_of(known.begin(), known.end(), [&](double k) { return std::abs(k - f) < 5e-4; }))
      return f;
  }
  return 0;
}

bool same_but_fraction(const Sample& sample, const Point& point, const std::vector<std::string>& keys) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k] != fraction_key && sample.values[k] != point.values[k]) return false;
  return true;
}

}  // namespace

std::vector<double> fractions_to_add(const std::vector<double>& known, const CurveMaximum& m) {
  if (m.f_max_high - m.f_max_low <= 2 * wanted_f_max) return {};
  std::vector<double> all = known, added;
  for (const double wanted : {m.f_max, (m.f_max_low + m.f_max) / 2, (m.f_max + m.f_max_high) / 2})
    if (const double f = new_fraction(wanted, all); f > 0) {
      all.push_back(f);
      added.push_back(f);
    }
  return added;
}

std::vector<Sample> refining_samples(const std::vector<Sample>& samples, const std::vector<std::string>& keys,
                                     const std::filesystem::path& folder) {
  std::vector<Sample> added;
  for (const Curve& curve : curves_of(points_of(table_of(samples, keys)), keys)) {
    const auto maximum = maximum_of(curve);
    if (!maximum) continue;
    std::vector<double> known;
    std::vector<const Sample*> models;  // the samples of the point at the maximum
    for (const Sample& sample : samples) {
      if (!same_but_fraction(sample, curve.points.front(), keys)) continue;
      known.push_back(sample.resolved_case.mixture.small_fraction);
      if (known.back() == maximum->at) models.push_back(&sample);
    }
    for (const double f : fractions_to_add(known, *maximum))
      for (const Sample* model : models) {
        Mixture mixture = mixture_of(model->resolved_case);
        mixture.small_fraction = f;
        if (small_count(mixture) >= 1) added.push_back(moved_to(*model, f, keys, folder));
      }
  }
  return added;
}

}  // namespace furnas
