#pragma once

#include <cstddef>
#include <vector>

namespace furnas {

/// A mean from a few independent samples, with its interval.
struct MeanInterval {
  std::size_t samples{};
  double mean{};
  double deviation{};   ///< standard deviation of a sample (n - 1); 0 for fewer than two
  double half_width{};  ///< of the interval of the mean for the given confidence; infinite for fewer than two

  double low() const { return mean - half_width; }
  double high() const { return mean + half_width; }
};

/// Mean of normally distributed samples with its interval by Student's t.
MeanInterval mean_interval(const std::vector<double>& samples, double confidence = 0.95);

/// Difference of two means whose samples may scatter differently (Welch), a - b.
MeanInterval difference_interval(const std::vector<double>& a, const std::vector<double>& b,
                                 double confidence = 0.95);

/// The value at x = 0 of the straight line through samples y(x) that scatter alike at every x (least
/// squares), with its interval by Student's t; `deviation` is that of a sample from the line. Infinite
/// half_width for fewer than three samples; throws ContractError unless there are two different x.
MeanInterval value_at_zero(const std::vector<double>& x, const std::vector<double>& y,
                           double confidence = 0.95);

}  // namespace furnas
