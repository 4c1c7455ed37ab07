#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "engine/certificate/stiffness.h"

namespace furnas {

/// The inverse of the stiffness on all motions of a packing that are no mere translation, and the number of
/// its negative eigenvalues; an operator for Spectra.
///
/// One particle is held, which takes the translations out and changes no sign. The matrix of the others is
/// factored by CHOLMOD (L L^T); the strains follow by their Schur complement, the inverse of which is what a
/// strain costs when the particles have followed. A Cholesky factor that exists proves that no eigenvalue is
/// negative. Where CHOLMOD meets a pivot that is not positive, that unknown is held by an added spring and
/// the factorization restarted; negative eigenvalues are then counted from a small dense matrix (Haynsworth's
/// inertia additivity), and the added springs are taken out of the inverse again (Woodbury's identity). When
/// more than four such springs are needed, the negative eigenvalues are counted by the signs of the pivots of
/// L D L^T instead (Sylvester's law of inertia).
class Compliance {
 public:
  using Scalar = double;

  /// `strains`: its columns are the strains that the cell is free to make, in the units in which they enter.
  /// `stiffness` must live as long, and have at least two particles.
  Compliance(const Stiffness& stiffness, Eigen::MatrixXd strains);
  ~Compliance();

  /// Whether the stiffness could be factored. Nothing else means anything otherwise.
  bool valid() const { return valid_; }

  /// Negative eigenvalues, of the particles and the free strains.
  Eigen::Index negative() const { return negative_; }

  /// What all six strains cost when the particles follow in balance [k_n d_s^2].
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
  Eigen::MatrixXd answer_;  // of the particles to each free strain
  Eigen::MatrixXd schur_;   // the inverse of what the free strains cost
  StrainMatrix relaxed_ = StrainMatrix::Zero();
  Eigen::Index negative_ = 0;
  bool valid_ = false;
};

}  // namespace furnas
