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

namespace furnas {

/// What analyze() is told beside the packing.
struct AnalysisOptions {
  double friction = 0;         ///< mu that tangential forces are measured against; 0: there are none
  int backbone_threshold = 4;  ///< live contacts below which a particle is a rattler, 2 to 4
  ForceBins force_bins{};
  PairCorrelationOptions pair_correlation{};
};

/// The forces and directions of some contacts: of one kind, or of all.
struct ContactAnalysis {
  std::optional<PairKind> kind;  ///< nothing: all
  ForceDistribution normal, tangential;
  std::optional<Mobilisation> mobilisation;  ///< with friction
  Fabric fabric;
};

/// All that can be read off the contacts.
struct NetworkAnalysis {
  Coordination coordination;           ///< of all particles
  Coordination backbone_coordination;  ///< of the particles that are no rattlers
  std::vector<RattlerSensitivity> rattlers;
  std::vector<Fabric> fabric;  ///< of all contacts: together, then by PairKind
  std::vector<ContactAnalysis>
      backbone;  ///< of the backbone's contacts: together, then each kind that occurs
};

/// What a packing is made of and how it hangs together.
struct Analysis {
  std::int64_t large{}, small{};           ///< particles
  double phi{};                            ///< packing fraction
  double small_fraction{};                 ///< f_s, share of the small spheres in the volume of all
  double phi_large{};                      ///< phi_L = phi (1 - f_s)
  double phi_small{};                      ///< phi_S = f_s phi/(1 - phi (1 - f_s))
  int backbone_threshold{};                ///< as it was asked for
  double friction{};                       ///< as it was asked for
  std::optional<NetworkAnalysis> network;  ///< nothing without contacts
  std::vector<PairCorrelation> pairs;      ///< of each kind, then of all
};

/// Shares of the mean normal force at which analyze() counts rattlers.
inline constexpr std::array live_force_shares{0.0, 1e-3, 1e-2, 1e-1};

Analysis analyze(const Packing& packing, const AnalysisOptions& options);

}  // namespace furnas
