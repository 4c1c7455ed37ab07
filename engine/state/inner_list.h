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

/// The pairs of the neighbour list whose gap is so small that they may touch within the next steps. A step
/// tests these pairs instead of the whole list (the dual pair list of Pall et al., J. Chem. Phys. 153 (2020)
/// 134110). Most pairs of a gas, and most pairs with rattlers in a packing, are not in the inner list. No bit
/// of a result depends on it.
struct InnerList {
  Skin skin;                         ///< of the inner list; smaller than that of the neighbour list
  Triangle edges;                    ///< of the cell when the inner list was built [d_s]
  std::vector<double> displacement;  ///< bound for each class since then, without the cell's part [d_s]
  std::int64_t builds{};             ///< PairList::builds of the neighbour list it belongs to
  bool outdated = true;              ///< a contact outside it is possible: test the whole list
  bool kept{};                       ///< whether an inner list is used; it has no use if most rows touch
  std::vector<InnerPair> rows;       ///< ascending; those of a piece begin at the piece's first row
  std::vector<std::uint32_t> count;  ///< number of rows of each piece
};

}  // namespace furnas
