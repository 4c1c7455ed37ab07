#include "engine/statistics/statistics.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double quantile(double degrees, double confidence) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.5 * (1 + confidence));
}

}  // namespace

MeanInterval mean_interval(const std::vector<double>& x, double confidence) {
  require(!x.empty(), "a mean needs a sample");
  require(confidence > 0 && confidence < 1, "a confidence lies between 0 and 1");
  const auto n = static_cast<double>(x.size());
  MeanInterval m{x.size(), std::accumulate(x.begin(), x.end(), 0.0) / n, 0, infinity};
  if (x.size() < 2) return m;
  double square = 0;
  for (double v : x) square += (v - m.mean) * (v - m.mean);
  m.deviation = std::sqrt(square / (n - 1));
  m.half_width = quantile(n - 1, confidence) * m.deviation / std::sqrt(n);
  return m;
}

MeanInterval difference_interval(const std::vector<double>& a, const std::vector<double>& b,
                                 double confidence) {
  const MeanInterval ma = mean_interval(a, confidence);
  const MeanInterval mb = mean_interval(b, confidence);
  MeanInterval d{a.size() + b.size(), ma.mean - mb.mean, 0, infinity};
  if (a.size() < 2 || b.size() < 2) return d;
  const auto na = static_cast<double>(a.size());
  const auto nb = static_cast<double>(b.size());
  const double va = ma.deviation * ma.deviation / na;
  const double vb = mb.deviation * mb.deviation / nb;
  d.deviation = std::sqrt(va + vb);
  d.half_width = 0;
  if (d.deviation == 0) return d;
  const double degrees = (va + vb) * (va + vb) / (va * va / (na - 1) + vb * vb / (nb - 1));
  d.half_width = quantile(degrees, confidence) * d.deviation;
  return d;
}

void PooledDeviation::add(const MeanInterval& group, double unit) {
  require(unit > 0, "samples of a group scatter");
  if (group.samples < 2) return;
  const double deviation = group.deviation / unit;
  square_ += static_cast<double>(group.samples - 1) * deviation * deviation;
  degrees_ += group.samples - 1;
}

double PooledDeviation::value() const {
  return degrees_ > 0 ? std::sqrt(square_ / static_cast<double>(degrees_)) : 0;
}

double PooledDeviation::half_width(std::size_t n, double unit, double confidence) const {
  require(n > 0, "a mean needs a sample");
  if (degrees_ == 0) return infinity;
  return quantile(static_cast<double>(degrees_), confidence) * unit * value() /
         std::sqrt(static_cast<double>(n));
}

MeanInterval value_at_zero(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  require(x.size() == y.size(), "a sample of the line has an x and a y");
  const MeanInterval mx = mean_interval(x, confidence), my = mean_interval(y, confidence);
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx.mean) * (x[k] - mx.mean);
    xy += (x[k] - mx.mean) * (y[k] - my.mean);
  }
  require(xx > 0, "a line goes through two different x");
  const double slope = xy / xx;
  MeanInterval zero{x.size(), my.mean - slope * mx.mean, 0, infinity};
  if (x.size() < 3) return zero;
  double square = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double off = y[k] - zero.mean - slope * x[k];
    square += off * off;
  }
  const auto n = static_cast<double>(x.size());
  zero.deviation = std::sqrt(square / (n - 2));
  zero.half_width = quantile(n - 2, confidence) * zero.deviation * std::sqrt(1 / n + mx.mean * mx.mean / xx);
  return zero;
}

}  // namespace furnas
