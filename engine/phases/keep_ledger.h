#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "engine/state/cell.h"
#include "engine/state/ledger.h"

namespace furnas {

/// Books the work that the cell's rate does on the motion of the particles over half a step:
/// -(e + tr(e)/(3 N)) : sum m v (x) v. `motion` is that sum.
void book_cell_drag(const double& time_step, const std::size_t& particles, const Cell& cell,
                    const Eigen::Matrix3d& motion, Ledger& ledger);

/// Books half of the contacts' work at this instant, and the second half of their work at the previous
/// instant.
void book_contacts(const double& time_step, const Cell& cell, const ContactWork& work, Ledger& ledger);

}  // namespace furnas
