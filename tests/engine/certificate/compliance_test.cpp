#include "engine/certificate/compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using Eigen::MatrixXd;

// The spheres of a squeezed packing hold each other by friction; the weaker its springs, the more motions
// buckle: none; so few that the factor holds some unknowns and takes that back; so many that it gives up. All
// three ways count what the dense matrix of the same particles counts, and invert it as that is inverted.
TEST(Compliance, CountsAndInvertsWhatIsNotDefinite) {
  struct Way {
    double tangential;
    Eigen::Index least, most;  // negative eigenvalues
  };
  const Packing packing = squeezed(0);
  for (const auto& [tangential, least, most] : {Way{1, 0, 0}, {0.09, 1, 9}, {0.05, 5, 1000}}) {
    const ContactNetwork network = contact_network(
        packing, {.law = HookeSynchronized{{.tangential_stiffness = tangential, .friction = 1e9}}});
    const Backbone backbone = find_backbone(network, packing.species, {0, 4});
    const Stiffness stiffness(network, backbone, 0);
    const Compliance compliance(stiffness, MatrixXd(6, 0));
    ASSERT_TRUE(compliance.valid());

    const Eigen::Index rest = stiffness.unknowns() - 3;  // the first particle's place is held
    const MatrixXd particles = stiffness.among_particles();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> dense(particles.bottomRightCorner(rest, rest));
    const auto negative = (dense.eigenvalues().array() < 0).count();
    EXPECT_GE(negative, least);
    EXPECT_LE(negative, most);
    EXPECT_EQ(compliance.negative(), negative);

    const MatrixXd coupling =
        dense.eigenvectors().transpose() * stiffness.particles_by_strain().bottomRows(rest);
    const StrainMatrix relaxed =
        stiffness.among_strains() -
        coupling.transpose() * dense.eigenvalues().cwiseInverse().asDiagonal() * coupling;
    // The eigenvalues nearest to 0 are some 1e-4 of the largest, known to 1e-15 of that.
    EXPECT_LT((compliance.relaxed() - relaxed).norm(), 1e-9 * relaxed.norm()) << tangential;
  }
}

}  // namespace
}  // namespace furnas
