#pragma once

#include <cstdint>

#include "engine/state/near_rows.h"

namespace furnas {

/// Whether near rows pay under this list, and the skin for them, while no particle moves further than
/// `motion` [d_s] and the cell is strained by no more than `strain` in a step: the life that makes going
/// through the list and through needless near rows together cheapest. Answers through `near`.
void choose_near_skin(const PairList& list, double motion, double strain, NearRows& near);

/// Rows that a step looks at while the near ones are not worn.
std::uint64_t near_rows(const PairList& list, const NearRows& near);

/// Gives near rows up, until they are chosen again, if they are not much fewer than the list's.
void weigh_near_rows(const PairList& list, NearRows& near);

}  // namespace furnas
