#include "engine/certificate/modes.h"

#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/certificate/compliance.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Up to this number of unknowns all eigenvalues are computed, from a dense matrix.
constexpr Index few = 60;

Stiffness::Motion motion_of(const VectorXd& v, Index particles, const MatrixXd& strains) {
  return {v.head(particles), strains * v.tail(strains.cols())};
}

VectorXd times(const Stiffness& stiffness, const MatrixXd& strains, const VectorXd& v) {
  const Stiffness::Motion force = stiffness.times(motion_of(v, stiffness.unknowns(), strains));
  VectorXd all(v.size());
  all << force.particles, strains.transpose() * force.strain;
  return all;
}

/// The spectrum of a few particles, from the dense matrix. A stiffness added to the translations moves their
/// eigenvalues to the upper end of the spectrum.
Modes all_modes(const Stiffness& stiffness, const MatrixXd& strains, int count, MatrixXd& vectors) {
  const Index particles = stiffness.unknowns();
  const Index size = particles + strains.cols();
  MatrixXd dense(size, size);
  for (Index k = 0; k < size; ++k) dense.col(k) = times(stiffness, strains, VectorXd::Unit(size, k));
  const double top = dense.norm() + 1;
  for (Index axis = 0; axis < 3; ++axis) {
    VectorXd translation = VectorXd::Zero(size);
    for (Index k = axis; k < particles; k += stiffness.per_particle()) translation[k] = 1;
    dense += (2 * top / translation.squaredNorm()) * translation * translation.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(dense);
  Modes modes;
  modes.valid = spectrum.info() == Eigen::Success;
  modes.negative = (spectrum.eigenvalues().array() < -flat_mode).count();
  const Index shown = std::min<Index>(count, size - 3);
  modes.lowest.assign(spectrum.eigenvalues().data(), spectrum.eigenvalues().data() + shown);
  vectors = spectrum.eigenvectors().leftCols(shown);

  const MatrixXd inner = dense.topLeftCorner(particles, particles);
  const MatrixXd coupling = stiffness.particles_by_strain();
  modes.relaxed = stiffness.among_strains() -
                  coupling.transpose() * inner.completeOrthogonalDecomposition().solve(coupling);
  return modes;
}

Modes softest_modes(const Stiffness& stiffness, const MatrixXd& strains, int count, MatrixXd& vectors) {
  Modes modes;
  Compliance compliance(stiffness, strains);
  modes.valid = compliance.valid();
  if (!modes.valid) return modes;
  modes.negative = compliance.negative();
  modes.relaxed = compliance.relaxed();
  const Index largest_basis = compliance.rows() - 3;
  // All negative eigenvalues are wanted, because the doubt of each is needed. The solver finds those nearest
  // to zero first.
  constexpr Index most = 400;
  const Index wanted = std::max<Index>(count, std::min<Index>(count + 2 * modes.negative, most));
  const Index shown = std::min<Index>(wanted, largest_basis - 1);
  const Index basis = std::min<Index>(largest_basis, std::max<Index>(2 * shown + 1, 40));
  Spectra::SymEigsShiftSolver<Compliance> solver(compliance, shown, basis, 0);
  solver.init();
  constexpr int most_restarts = 300;
  solver.compute(Spectra::SortRule::LargestMagn, most_restarts, 1e-10, Spectra::SortRule::SmallestAlge);
  modes.valid = solver.info() == Spectra::CompInfo::Successful;
  const VectorXd values = solver.eigenvalues();
  modes.lowest.assign(values.data(), values.data() + values.size());
  vectors = solver.eigenvectors();
  return modes;
}

}  // namespace

std::int64_t Modes::unstable() const {
  const auto seen = std::count_if(lowest.begin(), lowest.end(), [](double x) { return x < 0; });
  std::int64_t count = std::max<std::int64_t>(negative - seen, 0);
  for (std::size_t k = 0; k < lowest.size(); ++k) count += lowest[k] < flat_mode && !open(k);
  return count;
}

MatrixXd free_strains(CellFreedom freedom) {
  switch (freedom) {
    case CellFreedom::triclinic:
      return MatrixXd::Identity(6, 6);
    case CellFreedom::orthorhombic:
      return MatrixXd::Identity(6, 3);
    case CellFreedom::cubic: {
      MatrixXd swelling = MatrixXd::Zero(6, 1);
      swelling.topRows<3>().setConstant(1 / std::sqrt(3.0));
      return swelling;
    }
    case CellFreedom::fixed:
      break;
  }
  return MatrixXd(6, 0);
}

double displacement_of_strain(double volume, std::int64_t backbone) {
  return std::cbrt(volume) * std::sqrt(static_cast<double>(backbone) / 12);
}

Modes find_modes(const Stiffness& stiffness, CellFreedom freedom, int count) {
  Modes modes;
  const Index backbone = stiffness.unknowns() / stiffness.per_particle();
  if (backbone == 0) return modes;
  const MatrixXd strains = free_strains(freedom) / displacement_of_strain(stiffness.volume(), backbone);

  MatrixXd vectors;
  if (stiffness.unknowns() + strains.cols() <= few)
    modes = all_modes(stiffness, strains, count, vectors);
  else
    modes = softest_modes(stiffness, strains, count, vectors);

  for (Index k = 0; k < vectors.cols(); ++k) {
    const VectorXd v = vectors.col(k);
    const double value = modes.lowest[static_cast<std::size_t>(k)];
    modes.residual = std::max(modes.residual, (times(stiffness, strains, v) - value * v).norm());
    modes.doubt.push_back(stiffness.doubt(motion_of(v, stiffness.unknowns(), strains)));
    if (value < flat_mode) modes.unresisted.emplace_back(v.head(stiffness.unknowns()));
  }
  return modes;
}

}  // namespace furnas
