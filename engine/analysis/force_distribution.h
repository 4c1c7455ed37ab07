#pragma once

#include <cstdint>

#include "engine/analysis/contacts.h"
#include "engine/analysis/histogram.h"

namespace furnas {

/// The bins of the histograms of force/mean force.
struct ForceBins {
  bool logarithmic = false;
  double width = 0.2;   ///< of linear bins [mean force]
  int per_decade = 10;  ///< logarithmic bins in a power of ten
};

/// The distribution of a force over contacts: the probability density of force/mean, with the mean over these
/// contacts.
struct ForceDistribution {
  std::int64_t contacts{};
  double mean{};        ///< of the forces [k_n d_s]
  double largest{};     ///< largest force [k_n d_s]
  Histogram histogram;  ///< of force/mean; without bins if the mean is 0. Logarithmic bins count forces of 0
                        ///< as `below`.
};

/// The distribution of the normal forces.
ForceDistribution normal_forces(const Packing& packing, const Selection& contacts, const ForceBins& bins);

/// The distribution of the absolute values of the tangential forces.
ForceDistribution tangential_forces(const Packing& packing, const Selection& contacts, const ForceBins& bins);

/// How far contacts are from sliding.
struct Mobilisation {
  std::int64_t contacts{};
  std::int64_t sliding{};  ///< those at the Coulomb limit
  std::int64_t beyond{};  ///< those above it by more than rounding: `friction` is not the one the packing was
                          ///< made with
  double mean{};          ///< of |F_t|/(mu F_n)
  Histogram histogram;    ///< of |F_t|/(mu F_n) in [0, 1]

  /// Share of the contacts at the Coulomb limit; 0 without contacts.
  double sliding_share() const;
};

/// |F_t|/(friction F_n) of the contacts with F_n > 0, in `bins` bins; friction > 0.
Mobilisation mobilisation(const Packing& packing, const Selection& contacts, double friction, int bins = 20);

}  // namespace furnas
