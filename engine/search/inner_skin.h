#pragma once

#include <cstdint>

#include "engine/state/inner_list.h"

namespace furnas {

/// Chooses the skin of the inner list, and whether an inner list is worthwhile; sets `kept` and `skin` of
/// `inner`. `motion` is the largest change of a distance by the particles' motion in a step [d_s], and
/// `strain` the largest strain of the cell in a step. The skin minimizes the cost of the passes through the
/// whole list plus the cost of needless rows in the inner list.
void choose_inner_skin(const PairList& list, double motion, double strain, InnerList& inner);

/// Number of rows that a step tests while the inner list is not outdated.
std::uint64_t inner_rows(const PairList& list, const InnerList& inner);

/// Drops the inner list, until the next choose_inner_skin(), if it has more than 60 % of the rows of the
/// list.
void drop_inner_list_if_needless(const PairList& list, InnerList& inner);

}  // namespace furnas
