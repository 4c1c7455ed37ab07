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

/// Second derivatives of the enthalpy U + p V of a backbone whose contacts are springs: what forces answer to
/// small displacements (docs/theory/certificate.md derives it).
///
/// Unknowns of a particle: its displacement u besides the cell's strain and, with friction, R times its turn.
/// A contact holds its two spheres with its normal stiffness along the normal and with k_t across it, if it
/// slides only across its friction; and its forces turn with it, the prestress. Of that part friction makes
/// unsymmetric, the symmetric half is taken: it alone enters the second-order work.
///
/// A particle that bridges two others, with two contacts, may spin about the line through its contact points:
/// nothing moves and no force changes. That spin is held with 1 k_n, so that it is no soft motion.
class Stiffness {
 public:
  Stiffness(const ContactNetwork& network, const Backbone& backbone, double pressure);

  /// Unknowns of all particles, and of one: 3 without friction, 6 with.
  Eigen::Index unknowns() const { return unknowns_; }
  Eigen::Index per_particle() const { return per_particle_; }
  double volume() const { return volume_; }  ///< [d_s^3]
  /// Particles whose spin is held.
  std::int64_t bridges() const { return std::ssize(bridges_); }

  struct Motion {
    Eigen::VectorXd particles;  ///< u and R theta of each particle [d_s]; forces, when it is an answer
    Strain strain;              ///< e; the work conjugate of e, when it is an answer [k_n d_s^2]
  };

  /// Stiffness times motion, contact by contact, without a matrix.
  Motion times(const Motion& motion) const;

  /// How far the energy of a motion is in doubt, because its spheres are not quite in balance: what the
  /// prestress makes of it, were the force of each contact another by as much as its two spheres lack
  /// [k_n d_s^2].
  double doubt(const Motion& motion) const;

  /// The same as matrices: lower triangle among particles, particles by strain, strain by strain.
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
  bool arms_meet_;
};

}  // namespace furnas
