#include "engine/statistics/furnas_model.h"

#include <algorithm>
#include <cmath>

#include "engine/base/require.h"

namespace furnas {

double FurnasModel::phi(double f) const {
  // The two denominators are equal only at f_max. The larger denominator gives the lower packing fraction,
  // which is the one of the model.
  return mono / std::max(1 - f, f + mono * (1 - f));
}

FurnasInterval::FurnasInterval(double mono, double half_width)
    : FurnasInterval(std::isfinite(half_width) ? Interval{mono, mono - half_width, mono + half_width}
                                               : Interval{mono, mono, mono}) {}

FurnasInterval::FurnasInterval(const Interval& mono) : middle_{mono.value}, low_{mono.low}, high_{mono.high} {
  require(0 < mono.low && mono.low <= mono.value && mono.value <= mono.high && mono.high < 1,
          "phi_mono lies between 0 and 1");
}

Interval FurnasInterval::phi(double f) const { return {middle_.phi(f), low_.phi(f), high_.phi(f)}; }

Interval FurnasInterval::f_max() const { return {middle_.f_max(), high_.f_max(), low_.f_max()}; }

Interval FurnasInterval::phi_max() const { return {middle_.phi_max(), low_.phi_max(), high_.phi_max()}; }

double fraction_of_large(double phi, double f) { return phi * (1 - f); }

double fraction_in_voids(double phi, double f) { return f * phi / (1 - phi * (1 - f)); }

}  // namespace furnas
