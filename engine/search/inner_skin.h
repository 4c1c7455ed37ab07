#pragma once

#include <cstdint>

#include "engine/state/inner_list.h"

namespace furnas {

/// Whether an inner list pays under this list, and the skin for them, while no particle moves further than
/// `motion` [d_s] and the cell is strained by no more than `strain` in a step: the life that makes going
/// through the list and through needless rows of it together cheapest. Answers through `inner`.
void choose_inner_skin(const PairList& list, double motion, double strain, InnerList& inner);

/// Rows that a step looks at while the inner list is not outdated.
std::uint64_t inner_rows(const PairList& list, const InnerList& inner);

/// Gives the inner list up, until one is chosen again, if its rows are not much fewer than the list's.
void drop_inner_list_if_needless(const PairList& list, InnerList& inner);

}  // namespace furnas
