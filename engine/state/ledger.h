#pragma once

#include <cmath>

#include "engine/base/vec3.h"
#include "engine/state/cell.h"

namespace furnas {

/// Energy of the particles at one instant [k_n d_s^2]. The energy of the cell is not included.
struct Energy {
  double kinetic{};     ///< of the peculiar translation and of the spin
  double normal{};      ///< stored in overlaps
  double tangential{};  ///< stored in tangential springs

  double total() const { return kinetic + normal + tangential; }
};

/// Energy dissipated by contacts [k_n d_s^2].
struct Losses {
  double normal_damping{};
  double tangential_damping{};
  double sliding{};  ///< by the tangential force of contacts at the Coulomb limit
  double opening{};  ///< left in the tangential springs of contacts that opened

  double total() const { return normal_damping + tangential_damping + sliding + opening; }
  void operator+=(const Losses& b) {
    normal_damping += b.normal_damping;
    tangential_damping += b.tangential_damping;
    sliding += b.sliding;
    opening += b.opening;
  }
  friend Losses operator*(double factor, const Losses& l) {
    return {factor * l.normal_damping, factor * l.tangential_damping, factor * l.sliding, factor * l.opening};
  }
};

/// Work and losses of all contacts at one instant.
struct ContactWork {
  /// Sum of force_a branch_b, a <= b, over the forces on which the flow of the cell does work [k_n d_s^2].
  /// With the strain rate e of the cell the power is -sum e_ab push_ab.
  Triangle push;
  Losses losses;  ///< in a step [k_n d_s^2]

  void add(const Vec3<double>& force, const Vec3<double>& branch) { push += upper_product(force, branch); }
  void operator+=(const ContactWork& b) {
    push += b.push;
    losses += b.losses;
  }
};

/// Where the energy of the particles came from and went since the run began [k_n d_s^2].
struct Ledger {
  double initial{};    ///< energy at the start
  double cell_work{};  ///< work of the moving cell on the particles
  Losses losses;
  /// Taken out between steps: motion by Quench and AtRest, motion and springs by Minimize.
  double quenched{};
  ContactWork last;  ///< of the last step; its second half is booked with the next step

  /// Energy that is missing in the balance, if the energy is now `energy`; 0 apart from the error of the time
  /// step.
  double gap(double energy) const { return energy - initial - cell_work + losses.total() + quenched; }

  /// The gap divided by the energy turnover: initial energy plus |work of the cell|.
  double relative_gap(double energy) const {
    const double turnover = initial + std::abs(cell_work);
    return turnover > 0 ? gap(energy) / turnover : 0;
  }
};

}  // namespace furnas
