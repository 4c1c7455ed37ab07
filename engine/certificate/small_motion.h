#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "engine/certificate/bonds.h"
#include "engine/state/cell.h"

namespace furnas {

/// What presses the cell, and how the cell moves (docs/reference/notation.md).
struct CellMotion {
  CellFreedom freedom = CellFreedom::triclinic;
  double pressure = 1e-4;        ///< p_a; without meaning in a fixed cell [k_n/d_s]
  double inertia = 1;            ///< W [rho d_s^5]
  double drag = 0;               ///< g [1/time]
  bool affine_velocity = false;  ///< contacts feel the cell's flow, too
  bool legacy = false;           ///< shears are driven by branch_a force_b, a < b, as LAMMPS does
};

/// The equations of motion of a backbone and its cell about rest, to first order:
///
///     M z'' + C z' + K z = 0
///
/// with the contacts as they are, those that slide sliding on and the others sticking
/// (docs/theory/certificate.md derives them). A tangential force that slides follows the normal force,
/// damping included, so that neither C nor K is symmetric. The tangential spring of a contact is no unknown
/// of its own: to first order xi is what u, theta and, if contacts feel the cell's flow, e have made of it.
///
/// Unknowns of a particle: its displacement u besides the cell's strain and, with friction, R times its turn.
/// Unknowns of the cell stand last: the strains that it is free to make, in units of the displacement that a
/// strain adds to all particles together. The spin of a bridge is held with 1 k_n and critical damping.
class SmallMotion {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  SmallMotion(const ContactNetwork& network, const Backbone& backbone, const CellMotion& cell);

  Eigen::Index unknowns() const { return inertia_.size(); }
  Eigen::Index per_particle() const { return per_particle_; }  ///< 3 without friction, 6 with
  Eigen::Index particles() const { return particles_; }        ///< of the backbone
  /// Strains of which one unit adds a displacement of 1 d_s, squared and summed over the backbone, as
  /// columns.
  const Eigen::MatrixXd& strains() const { return strains_; }

  const Eigen::VectorXd& inertia() const { return inertia_; }  ///< the diagonal of M [rho d_s^3]
  const Sparse& damping() const { return damping_; }           ///< C [k_n time]
  const Sparse& stiffness() const { return stiffness_; }       ///< K [k_n]

  /// Takes out of a motion what moves the backbone as a whole.
  void hold_centre(Eigen::Ref<Eigen::VectorXcd> motion) const;
  void hold_centre(Eigen::Ref<Eigen::VectorXd> motion) const;

  /// Whether a contact is at the Coulomb limit.
  bool slides() const;

  /// By how much, in a motion z e^(lambda t) with a real lambda, spring and dashpot of each contact at the
  /// Coulomb limit outgrow it: where that is positive the contact slides on, where it is negative it sticks;
  /// 0 of a contact below the limit [k_n d_s].
  Eigen::VectorXd loading(const Eigen::VectorXd& motion, double lambda) const;

  /// The same packing with those contacts at the limit sliding whose loading is positive, the others
  /// sticking.
  SmallMotion sliding_where(const Eigen::VectorXd& loading) const;

  /// How much the product left . K right is in doubt, because spheres are not quite in balance: what the
  /// turning of forces makes of it, were the force of each contact another by as much as its two spheres
  /// lack [k_n].
  double doubt(const Eigen::VectorXcd& left, const Eigen::VectorXcd& right) const;

 private:
  BondMatrix elastic(const Bond& bond) const;
  BondMatrix prestress(const Bond& bond, double push, const Eigen::Vector3d& friction) const;
  BondMatrix viscous(const Bond& bond) const;
  BondMatrix pull_back(const Bond& bond, const BondRows& force) const;
  BondRows seen(const Bond& bond) const;
  BondRows slip(const Bond& bond) const;
  BondRows cut(const Bond& bond, const BondRow& normal, double tangential) const;
  void assemble();

  CellMotion cell_;
  std::vector<Bond> bonds_;
  std::vector<Eigen::Vector3d> limit_;  // direction of F_t of each bond at the Coulomb limit, or 0
  std::vector<Bridge> bridges_;
  Eigen::Index per_particle_;
  Eigen::Index particles_;
  double volume_;
  double friction_;
  bool arms_meet_;
  bool twists_;  // friction turns with the spheres about the normal
  Eigen::MatrixXd strains_;
  Eigen::VectorXd inertia_;
  Sparse damping_, stiffness_;
};

}  // namespace furnas
