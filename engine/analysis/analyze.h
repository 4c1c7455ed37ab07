#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/coordination.h"
#include "engine/analysis/fabric.h"
#include "engine/analysis/force_distribution.h"
#include "engine/analysis/pair_correlation.h"
#include "engine/analysis/rattlers.h"
#include "engine/state/species.h"

namespace furnas {

/// What analyze() needs besides the packing.
struct AnalysisOptions {
  double friction = 0;         ///< mu, with which tangential forces are compared; 0: there are none
  int backbone_threshold = 4;  ///< live contacts below which a particle is a rattler, 2 to 4
  ForceBins force_bins{};
  PairCorrelationOptions pair_correlation{};
};

/// The forces and directions of the contacts of one kind, or of all contacts.
struct ContactAnalysis {
  std::optional<PairKind> kind;  ///< nothing: all
  ForceDistribution normal, tangential;
  std::optional<Mobilisation> mobilisation;  ///< with friction
  Fabric fabric;
};

/// Results that need the contacts.
struct NetworkAnalysis {
  Coordination coordination;           ///< of all particles
  Coordination backbone_coordination;  ///< of the particles that are no rattlers
  std::vector<RattlerSensitivity> rattlers;
  std::vector<Fabric> fabric;  ///< of all contacts: first all together, then by PairKind, as in `backbone`
  /// Of the backbone's contacts: first all together, then each kind that occurs. The kinds are left out if
  /// the spheres are one species of many sizes.
  std::vector<ContactAnalysis> backbone;
};

/// The two species in the cell, where each has one size.
struct MixtureFractions {
  double small_fraction{};  ///< f_s, share of the small spheres in the volume of all
  double phi_large{};       ///< phi_L = phi (1 - f_s)
  double phi_small{};       ///< phi_S = f_s phi/(1 - phi (1 - f_s))
};

/// What a packing consists of, and its contact network.
struct Analysis {
  std::int64_t large{}, small{};            ///< particles of each species
  Sizes sizes;                              ///< of the spheres
  bool polydisperse{};                      ///< spheres of one species differ in size
  double phi{};                             ///< packing fraction
  std::optional<MixtureFractions> mixture;  ///< nothing for a polydisperse packing
  int backbone_threshold{};                 ///< as in AnalysisOptions
  double friction{};                        ///< as in AnalysisOptions
  std::optional<NetworkAnalysis> network;   ///< nothing without contacts
  std::vector<PairCorrelation> pairs;       ///< of each kind, then of all

  /// Whether the distinction of large and small has a meaning; it has none if spheres of many sizes are one
  /// species.
  bool has_species() const { return !polydisperse || (large > 0 && small > 0); }
};

/// Shares of the mean normal force at which analyze() counts rattlers.
inline constexpr std::array live_force_shares{0.0, 1e-3, 1e-2, 1e-1};

/// Measures a packing. Throws InputError for options that do not suit the packing.
Analysis analyze(const Packing& packing, const AnalysisOptions& options);

}  // namespace furnas
