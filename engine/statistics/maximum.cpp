#include "engine/statistics/maximum.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <map>
#include <optional>

#include "engine/base/require.h"

namespace furnas {
namespace {

/// Samples at a larger distance from the highest mean are not used, because there the branches of the curve
/// need not be straight.
constexpr double reach = 0.3;
constexpr double step = 0.002;  ///< step of x_0 in the search

/// The samples that a hyperbola is fitted to, as x and 1/y.
struct Samples {
  Eigen::VectorXd x, inverse;
};

struct Fit {
  double square;  ///< sum of squared residuals
  double at;      ///< place of the minimum of the hyperbola
};

/// The best hyperbola with this x_0 and s, if it has a minimum.
std::optional<Fit> fit(const Samples& samples, double centre, double width) {
  const Eigen::ArrayXd x = samples.x.array() - centre;
  Eigen::MatrixX3d columns(x.size(), 3);
  columns << Eigen::VectorXd::Ones(x.size()), x.matrix(), (x.square() + width * width).sqrt().matrix();
  const Eigen::Vector3d c = columns.colPivHouseholderQr().solve(samples.inverse);
  const double tilt = c[1] / c[2];
  if (!(c[2] > 0 && std::abs(tilt) < 1)) return {};
  const double at = centre - tilt * width / std::sqrt(1 - tilt * tilt);
  if (at < samples.x.minCoeff() || at > samples.x.maxCoeff()) return {};
  return Fit{(columns * c - samples.inverse).squaredNorm(), at};
}

std::vector<Fit> fits_of(const Samples& samples) {
  std::vector<Fit> fits;
  const double low = samples.x.minCoeff(), high = samples.x.maxCoeff();
  for (double centre = low; centre <= high; centre += step)
    for (const double width : {0.0, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0})
      if (const auto found = fit(samples, centre, width)) fits.push_back(*found);
  return fits;
}

/// The place of the highest mean, with its neighbours as the interval.
Maximum highest_mean(const std::vector<double>& x, const std::vector<double>& y) {
  std::map<double, std::pair<double, double>> sums;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sums[x[k]].first += y[k];
    sums[x[k]].second += 1;
  }
  require(sums.size() >= 3, "a maximum needs three places");
  const auto mean = [](const auto& of) { return of.second.first / of.second.second; };
  const auto best = std::max_element(sums.begin(), sums.end(),
                                     [&](const auto& a, const auto& b) { return mean(a) < mean(b); });
  const bool first = best == sums.begin(), last = std::next(best) == sums.end();
  // Beyond its last point the curve may continue to rise.
  const double left = first ? 2 * best->first - std::next(best)->first : std::prev(best)->first;
  const double right = last ? 2 * best->first - std::prev(best)->first : std::next(best)->first;
  return {best->first, left, right};
}

}  // namespace

Maximum find_maximum(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  require(x.size() == y.size(), "each y has its x");
  require(confidence > 0 && confidence < 1, "a confidence lies between 0 and 1");
  const Maximum coarse = highest_mean(x, y);
  std::vector<double> near_x, near_inverse;
  for (std::size_t k = 0; k < x.size(); ++k) {
    require(y[k] > 0, "a curve is positive");
    if (std::abs(x[k] - coarse.at) > reach) continue;
    near_x.push_back(x[k]);
    near_inverse.push_back(1 / y[k]);
  }
  constexpr std::size_t parameters = 5;
  const auto places = [](std::vector<double> all) {
    std::sort(all.begin(), all.end());
    return std::unique(all.begin(), all.end()) - all.begin();
  };
  // Through as many places as parameters there is nearly always a hyperbola, whose interval is too narrow.
  if (places(near_x) <= static_cast<long>(parameters)) return coarse;
  const auto count = static_cast<Eigen::Index>(near_x.size());
  const std::vector<Fit> fits = fits_of({Eigen::Map<Eigen::VectorXd>(near_x.data(), count),
                                         Eigen::Map<Eigen::VectorXd>(near_inverse.data(), count)});
  if (fits.empty()) return coarse;
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const Fit& a, const Fit& b) { return a.square < b.square; });
  // The F test has two parameters, x_0 and s. With only the place as parameter the interval would contain the
  // maximum less often than `confidence`.
  const auto freedom = static_cast<double>(near_x.size() - parameters);
  const double F = boost::math::quantile(boost::math::fisher_f(2, freedom), confidence);
  const double most = best->square * (1 + 2 * F / freedom);
  Maximum found{best->at, best->at - step / 2, best->at + step / 2};
  for (const Fit& f : fits) {
    if (f.square > most) continue;
    found.low = std::min(found.low, f.at);
    found.high = std::max(found.high, f.at);
  }
  return found;
}

}  // namespace furnas
