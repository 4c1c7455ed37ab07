#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

#include "engine/certificate/backbone.h"
#include "engine/certificate/bonds.h"
#include "engine/certificate/contact_network.h"

namespace furnas {

/// Second derivatives of the enthalpy U + p V of a backbone whose contacts are springs: the change of forces
/// by small displacements (docs/theory/certificate.md derives it).
///
/// Unknowns of a particle: its displacement u relative to the strained cell and, with friction, R times its
/// rotation. A contact acts with its normal stiffness along the normal and with k_t in the two tangential
/// directions; a sliding contact only in the tangential direction perpendicular to F_t. In addition the
/// contact's forces turn with the contact: the prestress. With friction the prestress part is not symmetric.
/// Only its symmetric part is used, because only this part enters the second-order work.
///
/// A bridge (bonds.h) can spin about the line through its two contact points without changing a force. A
/// spring of 1 k_n is added to this spin, so that the spin is no soft mode.
class Stiffness {
 public:
  Stiffness(const ContactNetwork& network, const Backbone& backbone, double pressure);

  /// Number of unknowns of all particles, and of one particle: 3 without friction, 6 with.
  Eigen::Index unknowns() const { return unknowns_; }
  Eigen::Index per_particle() const { return per_particle_; }
  double volume() const { return volume_; }  ///< [d_s^3]
  /// Number of bridges, whose spin has an added spring.
  std::int64_t bridges() const { return std::ssize(bridges_); }

  struct Motion {
    Eigen::VectorXd particles;  ///< u and R theta of each particle [d_s]; forces, in a result of times()
    Strain strain;              ///< e; in a result of times() the force conjugate to e [k_n d_s^2]
  };

  /// The product of stiffness and motion, summed over the contacts without a matrix.
  Motion times(const Motion& motion) const;

  /// Uncertainty of the energy of a motion because the spheres are not exactly in balance [k_n d_s^2]. It is
  /// the change of the prestress part if the force of each contact changes by the net forces of its two
  /// spheres.
  double doubt(const Motion& motion) const;

  /// The stiffness as matrices: particles by particles (lower triangle), particles by strain, strain by
  /// strain.
  Eigen::SparseMatrix<double> among_particles() const;
  Eigen::MatrixXd particles_by_strain() const;
  StrainMatrix among_strains() const;

 private:
  BondMatrix local(const Bond& bond) const;
  BondMatrix elastic(const Bond& bond) const;
  BondMatrix prestress(const Bond& bond, double push, const Eigen::Vector3d& friction) const;
  BondVector of_bond(const Bond& bond, const Motion& motion) const;
  std::array<Eigen::Index, 12> places(const Bond& bond) const;
  StrainMatrix of_volume() const;

  std::vector<Bond> bonds_;
  std::vector<Bridge> bridges_;
  Eigen::Index per_particle_;
  Eigen::Index unknowns_;
  double volume_;
  double pressure_;
  bool arms_meet_, twists_;
};

}  // namespace furnas
