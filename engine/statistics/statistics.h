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

/// The scatter of a sample, pooled over groups that have different means. It tells how far a lone sample may
/// be from its mean.
class PooledDeviation {
 public:
  /// Adds a group of which each sample scatters `unit` times as much as one of unit scatter; unit > 0.
  void add(const MeanInterval& group, double unit = 1);

  std::size_t degrees_of_freedom() const { return degrees_; }  ///< sum of n - 1 over the groups
  double value() const;  ///< standard deviation of a sample of unit scatter; 0 without a degree of freedom

  /// Half width of the interval of a mean of n samples that each scatter `unit` times as much as one of unit
  /// scatter, by Student's t; infinite without a degree of freedom.
  double half_width(std::size_t n, double unit = 1, double confidence = 0.95) const;

 private:
  double square_ = 0;  // sum of squares from the means, in squares of the units
  std::size_t degrees_ = 0;
};

/// The value at x = 0 of the straight line through samples y(x) that scatter alike at every x (least
/// squares), with its interval by Student's t; `deviation` is that of a sample from the line. Infinite
/// half_width for fewer than three samples; throws ContractError unless there are two different x.
MeanInterval value_at_zero(const std::vector<double>& x, const std::vector<double>& y,
                           double confidence = 0.95);

}  // namespace furnas
