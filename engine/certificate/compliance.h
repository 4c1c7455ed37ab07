#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "engine/certificate/stiffness.h"

namespace furnas {

/// The inverse of the stiffness on all motions of a packing except translations, and the number of negative
/// eigenvalues of the stiffness. Serves as an operator for the library Spectra.
///
/// One particle is fixed. This removes the translations and changes no sign of an eigenvalue. The matrix of
/// the other particles is factored by CHOLMOD (L L^T). The strains are eliminated by their Schur complement:
/// the stiffness against a strain when the particles have relaxed. A Cholesky factor that exists proves that
/// no eigenvalue is negative. If CHOLMOD meets a pivot that is not positive, springs are added to the
/// unknowns of its particle, and the factorization is restarted. Negative eigenvalues are then counted from a
/// small dense matrix (Haynsworth's inertia additivity), and the added springs are removed from the inverse
/// (Woodbury's identity). If it was restarted forty times, the negative eigenvalues are counted by the signs
/// of the pivots of L D L^T instead (Sylvester's law of inertia).
class Compliance {
 public:
  using Scalar = double;

  /// `strains`: its columns are the strains that the cell is free to make, in the units of the unknowns.
  /// `stiffness` must outlive the object and have at least two particles.
  Compliance(const Stiffness& stiffness, Eigen::MatrixXd strains);
  ~Compliance();

  /// Whether the stiffness could be factored. If not, the other results have no meaning.
  bool valid() const { return valid_; }

  /// Number of negative eigenvalues of the stiffness of particles and free strains.
  Eigen::Index negative() const { return negative_; }

  /// Stiffness against the six strains when the particles relax to balance [k_n d_s^2].
  const StrainMatrix& relaxed() const { return relaxed_; }

  Eigen::Index rows() const;
  Eigen::Index cols() const { return rows(); }
  void set_shift(double shift) const;
  void perform_op(const double* in, double* out) const;

 private:
  class Factor;
  Eigen::MatrixXd particles_follow(const Eigen::MatrixXd& forces) const;

  Eigen::Index unknowns_;
  Eigen::Index per_particle_;
  Eigen::MatrixXd strains_;
  std::unique_ptr<Factor> factor_;
  Eigen::MatrixXd answer_;  // displacement of the particles by each free strain
  Eigen::MatrixXd schur_;   // inverse stiffness of the free strains
  StrainMatrix relaxed_ = StrainMatrix::Zero();
  Eigen::Index negative_ = 0;
  bool valid_ = false;
};

}  // namespace furnas
