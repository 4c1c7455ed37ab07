#include "engine/trials/row_of_two.h"

#include <cmath>

#include "engine/base/require.h"
#include "engine/simulation.h"

namespace furnas {

Packing RowOfTwo::start(double shift, const Vec3<double>& spin) {
  return packing_of({length, 16, 16, 0, 0, 0}, {{.position = {-shift / 2, 8, 8}, .spin = spin},
                                                {.position = {(length + shift) / 2, 8, 8}}});
}

double RowOfTwo::shift_of(const Packing& p) {
  return length * from_fixed(p.fraction[1].x - p.fraction[0].x - (std::uint64_t{1} << 63));
}

double RowOfTwo::shift_at(double time, double damping) {
  const double w = std::sqrt(2 / reduced_mass() - damping * damping);
  return std::exp(-damping * time) * (std::cos(w * time) + damping / w * std::sin(w * time));
}

Oscillation oscillation_of(const std::vector<double>& x, double time_step) {
  require(x.size() >= 4, "an oscillation is read off four places");
  double nn = 0, np = 0, pp = 0, fn = 0, fp = 0;  // n: now, p: past, f: future
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    nn += x[k] * x[k], np += x[k] * x[k - 1], pp += x[k - 1] * x[k - 1];
    fn += x[k + 1] * x[k], fp += x[k + 1] * x[k - 1];
  }
  const double determinant = nn * pp - np * np;
  const double a = (fn * pp - fp * np) / determinant, b = (fp * nn - fn * np) / determinant;
  // The roots of z^2 = a z + b are e^((-decay +- i frequency) dt).
  require(b < 0 && a * a < -4 * b, "the places oscillate");
  return {-0.5 * std::log(-b) / time_step, std::acos(a / (2 * std::sqrt(-b))) / time_step};
}

Oscillation oscillation_of_row(const Model& model, int steps) {
  constexpr double amplitude = 1e-2;
  const auto simulation = make_simulation(model, RowOfTwo::start(amplitude, {}));
  std::vector<double> places;
  // The predicted velocity contains the acceleration of the previous step. This adds a second, spurious
  // motion, which decays as (-gamma dt)^n and is negligible after twelve steps.
  simulation->advance(12);
  for (int n = 0; n < steps; ++n) {
    simulation->advance(1);
    places.push_back(RowOfTwo::shift_of(simulation->packing()));
  }
  return oscillation_of(places, model.time_step);
}

}  // namespace furnas
