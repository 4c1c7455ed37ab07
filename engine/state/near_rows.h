#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/pair_list.h"

namespace furnas {

/// A row of the list, and whose it is.
struct NearRow {
  RowNumber row;
  std::uint32_t i, j;
};

/// The rows of the list whose gap is so small that they may touch within the next steps: a list within the
/// list, which a step goes through in its stead. Most pairs of a gas, and of the rattlers of a packing, are
/// not among them. No bit of a result depends on it.
struct NearRows {
  Skin skin;                         ///< of these rows; narrower than the list's
  Triangle edges;                    ///< of the cell when they were noted [d_s]
  std::vector<double> travelled;     ///< bound of each class's longest way since, the affine part apart [d_s]
  std::int64_t builds{};             ///< PairList::builds of the list they are of
  bool worn = true;                  ///< a contact outside them is possible: go through the whole list
  bool kept{};                       ///< noted when that is done; of no use where most rows touch
  std::vector<NearRow> rows;         ///< ascending; those of a piece of particles from its first row on
  std::vector<std::uint32_t> count;  ///< of each piece
};

}  // namespace furnas
