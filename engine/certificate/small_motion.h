#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "engine/certificate/bonds.h"
#include "engine/state/cell.h"

namespace furnas {

/// The bath that presses the cell, and the constants of the cell's motion (docs/reference/notation.md).
struct CellMotion {
  CellFreedom freedom = CellFreedom::triclinic;
  double pressure = 1e-4;        ///< p_a; without meaning in a fixed cell [k_n/d_s]
  double inertia = 1;            ///< W [rho d_s^5]
  double drag = 0;               ///< g [1/time]
  bool affine_velocity = false;  ///< relative velocities in contacts include the cell's flow
  bool legacy = false;           ///< shears are driven by branch_a force_b, a < b, as LAMMPS does
};

/// The equations of motion of a backbone and its cell about rest, to first order:
///
///     M z'' + C z' + K z = 0
///
/// The set of contacts is fixed: contacts that slide continue to slide, and the others stick
/// (docs/theory/certificate.md derives the equations). In a sliding contact |F_t| is mu F_n, including the
/// damping part of F_n; therefore neither C nor K is symmetric. The tangential spring of a contact is no
/// unknown of its own: to first order its displacement xi follows from u, theta and, if contacts feel the
/// cell's flow, e.
///
/// Unknowns of a particle: its displacement u relative to the strained cell and, with friction, R times its
/// rotation. The unknowns of the cell come last: the strains that it is free to make, each times
/// displacement_of_strain(). The spin of a bridge (bonds.h) gets a spring of 1 k_n and critical damping.
class SmallMotion {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  SmallMotion(const ContactNetwork& network, const Backbone& backbone, const CellMotion& cell);

  Eigen::Index unknowns() const { return inertia_.size(); }
  Eigen::Index per_particle() const { return per_particle_; }  ///< 3 without friction, 6 with
  Eigen::Index particles() const { return particles_; }        ///< of the backbone
  /// The free strains as columns. One unit of each displaces the backbone such that the squared displacements
  /// of its particles sum to 1 d_s^2.
  const Eigen::MatrixXd& strains() const { return strains_; }

  const Eigen::VectorXd& inertia() const { return inertia_; }  ///< the diagonal of M [rho d_s^3]
  const Sparse& damping() const { return damping_; }           ///< C [k_n time]
  const Sparse& stiffness() const { return stiffness_; }       ///< K [k_n]

  /// Removes from a motion the translation of the backbone as a whole.
  void hold_centre(Eigen::Ref<Eigen::VectorXcd> motion) const;
  void hold_centre(Eigen::Ref<Eigen::VectorXd> motion) const;

  /// Whether any contact slides.
  bool slides() const;

  /// The loading of each contact in a motion z e^(lambda t) with a real lambda: the growth of |F_t| of its
  /// spring and dashpot minus the growth of mu F_n [k_n d_s]. A contact at the Coulomb limit continues to
  /// slide if its loading is positive, and sticks if it is negative. For a contact below the limit the
  /// loading is 0.
  Eigen::VectorXd loading(const Eigen::VectorXd& motion, double lambda) const;

  /// The same packing, where contacts at the limit slide if their loading is positive, and all others stick.
  SmallMotion sliding_where(const Eigen::VectorXd& loading) const;

  /// Uncertainty of the product left . K right because the spheres are not exactly in balance [k_n]. It is
  /// the change of the prestress part of K if the force of each contact changes by the net forces of its two
  /// spheres.
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
  bool twists_;  // F_t turns with the spheres about the normal
  Eigen::MatrixXd strains_;
  Eigen::VectorXd inertia_;
  Sparse damping_, stiffness_;
};

}  // namespace furnas
