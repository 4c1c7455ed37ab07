#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/contacts.h"

namespace furnas {

/// Range and resolution of g(r).
struct PairCorrelationOptions {
  double reach = 0;   ///< largest distance [d_s]; 0: half the cell's thickness, but 2.5 to 5 large diameters
  double bin = 0.02;  ///< bin width for the smallest d_ab; for a larger one a multiple of it [d_s]
  double most_pairs = 2e8;  ///< with more pairs, distances are measured from every n-th particle only
};

/// g(r): the number of centres at a distance, divided by the number that an ideal gas would have there.
///
/// As with contacts, all images of all particles count, also the images of the particle itself. Therefore a
/// packing has the same g in its cell and in any larger cell that repeats it.
struct PairCorrelation {
  std::optional<PairKind> kind;  ///< nothing: all particles, whatever their species
  double contact{};           ///< d_ab, mean diameter of the two species [d_s]; of all particles if no kind
  std::int64_t origins{};     ///< particles from which distances were measured
  std::vector<double> edges;  ///< of the bins [d_s]
  std::vector<std::int64_t> counts;  ///< partners found from all origins
  std::vector<double> g;             ///< 1 in an ideal gas
  std::vector<double> error;         ///< one standard deviation of g in an ideal gas of these counts
  std::vector<double> neighbours;    ///< partners of an origin nearer than the upper edge, on average

  double centre(std::size_t bin) const { return 0.5 * (edges[bin] + edges[bin + 1]); }
};

/// One g(r) for each kind that has pairs and, if there are two species, one for all particles. If spheres of
/// many sizes are one species, only the g(r) of all particles. Throws InputError when the reach spans more
/// than ten cells, or the bins are too many.
std::vector<PairCorrelation> pair_correlation(const Packing& packing,
                                              const PairCorrelationOptions& options = {});

/// The reach that is used when none is given [d_s].
double chosen_reach(const Packing& packing);

}  // namespace furnas
