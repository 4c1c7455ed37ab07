#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/pair_list.h"

namespace furnas {

/// A row of the neighbour list and its two particles.
struct InnerPair {
  RowNumber row;
  std::uint32_t i, j;
};

/// The pairs of the neighbour list that may touch within the next steps, because their gap is small: a list
/// within the list, which a step goes through instead of the whole (the dual pair list of Pall et al.,
/// J. Chem. Phys. 153 (2020) 134110). Most pairs of a gas, and of the rattlers of a packing, are not
/// among them. No bit of a result depends on it.
struct InnerList {
  Skin skin;                         ///< of these rows; narrower than the list's
  Triangle edges;                    ///< of the cell when they were noted [d_s]
  std::vector<double> displacement;  ///< bound of the largest of each class since, without the cell's [d_s]
  std::int64_t builds{};             ///< PairList::builds of the list they are of
  bool outdated = true;              ///< a contact outside it is possible: go through the whole list
  bool kept{};                       ///< noted when that is done; of no use where most rows touch
  std::vector<InnerPair> rows;       ///< ascending; those of a piece of particles from its first row on
  std::vector<std::uint32_t> count;  ///< of each piece
};

}  // namespace furnas
