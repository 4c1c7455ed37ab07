#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/contacts.h"

namespace furnas {

/// How far and how finely g(r) is looked at; zeros are chosen by the program.
struct PairCorrelationOptions {
  double reach = 0;   ///< largest distance [d_s]; 0: half of the cell, within 2.5 to 5 large diameters
  double bin = 0.02;  ///< width of bins for the smallest pair; wider pairs take whole multiples of it [d_s]
  double most_pairs = 2e8;  ///< beyond, only every so many particles are looked at from
};

/// g(r): how many centres lie at a distance, over how many would if all lay at random.
///
/// All images of all particles count, those of the particle itself, too, as with contacts: a packing has the
/// same g in its cell and in any larger one that repeats it.
struct PairCorrelation {
  std::optional<PairKind> kind;  ///< nothing: all particles, whatever their species
  double contact{};           ///< d_ab, mean diameter of the two species [d_s]; of all particles if no kind
  std::int64_t origins{};     ///< particles that were looked at from
  std::vector<double> edges;  ///< of the bins [d_s]
  std::vector<std::int64_t> counts;  ///< partners found from all origins
  std::vector<double> g;             ///< 1 in an ideal gas
  std::vector<double> error;         ///< one standard deviation of g in an ideal gas of these counts
  std::vector<double> neighbours;    ///< partners of an origin nearer than the upper edge, on average

  double centre(std::size_t bin) const { return 0.5 * (edges[bin] + edges[bin + 1]); }
};

/// Of each kind of which there are pairs, then of all where there are two species; only of all where spheres
/// of many sizes are one species. Throws InputError when the reach spans more than ten cells, or the bins are
/// too many.
std::vector<PairCorrelation> pair_correlation(const Packing& packing,
                                              const PairCorrelationOptions& options = {});

/// The reach that is taken where none is given [d_s].
double chosen_reach(const Packing& packing);

}  // namespace furnas
