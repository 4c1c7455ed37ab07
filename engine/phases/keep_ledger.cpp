#include "engine/phases/keep_ledger.h"

#include <utility>

namespace furnas {

void book_cell_drag(const double& time_step, const std::size_t& particles, const Cell& cell,
                    const Eigen::Matrix3d& motion, Ledger& ledger) {
  const Triangle flow{motion(0, 0), motion(1, 1), motion(2, 2), motion(1, 2), motion(0, 2), motion(0, 1)};
  const double common = cell.rate.trace() / (3 * static_cast<double>(particles));
  ledger.cell_work -= 0.5 * time_step * (contraction(cell.rate, flow) + common * flow.trace());
}

void book_contacts(const double& time_step, const Cell& cell, const ContactWork& work, Ledger& ledger) {
  ledger.cell_work -=
      0.5 * time_step * (contraction(cell.rate, ledger.last.push) + contraction(cell.rate, work.push));
  ContactWork here = work;
  // These losses are booked at once, not in halves. When a contact opens, its spring vanishes at once; at the
  // Coulomb limit the spring is cut or stretched at once, by any length
  // (docs/developer/decisions/energy-balance.md).
  ledger.losses.opening += std::exchange(here.losses.opening, 0);
  ledger.losses.sliding += std::exchange(here.losses.sliding, 0);
  ledger.losses += 0.5 * ledger.last.losses;
  ledger.losses += 0.5 * here.losses;
  ledger.last = here;
}

}  // namespace furnas
