#pragma once

namespace furnas {

/// The generalized Furnas model: the packing fraction of two sizes of spheres in the limit of an infinite
/// size ratio.
///
/// Either the large spheres form the packing and the small ones lie in its voids, or the small spheres form
/// the packing and the large ones are inclusions. The model takes the case with the lower packing fraction.
/// Friction enters only through the packing fraction of spheres of one size. Source: Srivastava et al.,
/// "Jamming of bidisperse frictional spheres" (arXiv 2105.00977), after C. C. Furnas, Bureau of Mines
/// Bulletin 307 (1929).
struct FurnasModel {
  double mono;  ///< phi_mono(mu), packing fraction of spheres of one size, in (0, 1)

  /// phi(f_s): mono/(1 - f_s) up to f_max, mono/(f_s + mono (1 - f_s)) beyond; f_s in [0, 1] is the share of
  /// the small spheres in the volume of all.
  double phi(double small_fraction) const;

  /// f_max = (1 - mono)/(2 - mono), the f_s of the densest mixture. There the small spheres fill the voids of
  /// the large ones with the packing fraction that they have alone.
  double f_max() const { return (1 - mono) / (2 - mono); }

  /// phi_max = 1 - (1 - mono)^2, the packing fraction at f_max.
  double phi_max() const { return mono * (2 - mono); }
};

/// A value and the interval in which it lies.
struct Interval {
  double value{}, low{}, high{};
};

/// The model for a phi_mono that is known to lie in an interval. Each result of the model is monotonic in
/// phi_mono, so its interval follows from the ends of the interval of phi_mono.
class FurnasInterval {
 public:
  /// phi_mono +- half_width, both ends in (0, 1); throws ContractError otherwise. A half_width that is not
  /// finite, as from a single sample, is taken as 0.
  FurnasInterval(double mono, double half_width);

  /// phi_mono between two ends, all three in (0, 1) and in order; throws ContractError otherwise.
  explicit FurnasInterval(const Interval& mono);

  Interval phi(double small_fraction) const;  ///< as FurnasModel::phi
  Interval f_max() const;                     ///< as FurnasModel::f_max
  Interval phi_max() const;                   ///< as FurnasModel::phi_max
  const FurnasModel& middle() const { return middle_; }

 private:
  FurnasModel middle_, low_, high_;
};

/// phi_L = phi (1 - f_s), packing fraction of the large spheres alone; the model has phi_L = phi_mono below
/// f_max.
double fraction_of_large(double phi, double small_fraction);

/// phi_S = f_s phi/(1 - phi (1 - f_s)), packing fraction of the small spheres in the volume that the large
/// ones leave; the model has phi_S = phi_mono above f_max.
double fraction_in_voids(double phi, double small_fraction);

}  // namespace furnas
