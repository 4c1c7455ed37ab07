#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/model.h"
#include "engine/state/packing.h"

/// The same packing described in other ways: what must not change is the physics.
namespace furnas::test {

Vec3<double> operator*(const Eigen::Matrix3d& matrix, const Vec3<double>& v);

/// The packing turned by `turn`, orthogonal, its cell as it was; a reflection turns spins and torques the
/// other way. Places, which are relative to the cell, stay.
Packing turned(const Packing& packing, const Eigen::Matrix3d& turn);

/// Numbers places and the images of contacts by edges edges * m of the same lattice, m an integer matrix of
/// determinant +-1. Neither the edges nor what has a direction in space changes; the count of crossed cells
/// starts anew.
void number_places_by(Packing& packing, const Eigen::Matrix3i& m);

struct Redescribed {
  Packing packing;
  Eigen::Matrix3d turn;  ///< by which it was turned or reflected
};

/// The packing with the edges edges * m, turned so that they are upper triangular again. The cell rests.
Redescribed with_edges(const Packing& packing, const Eigen::Matrix3i& m);

/// All 48 ways to rename and reverse the three axes.
std::vector<Eigen::Matrix3i> signed_permutations();

/// The packing with particle k under the number number[k]; the order in memory stays.
Packing renumbered(const Packing& packing, const std::vector<std::uint32_t>& number);

/// Lengths in units of 2^-length, masses in units of 2^-mass, mass even. The unit of time, 2^(-mass/2),
/// follows from k_n = 1.
struct Units {
  int length, mass;
};
Packing in_units(const Packing& packing, const Units& units);
Model in_units(const Model& model, const Units& units);

/// Eight copies of the packing in a cell of twice the edges; copy c of particle k has the number 8 k + c.
/// Places in 2^-64 of an edge must be even. The new packing has an order in memory of its own.
Packing doubled(const Packing& packing);

/// Velocities and spins reversed.
Packing reversed(const Packing& packing);

/// Expects the same contacts, i.e. as many with the same particles and the branch of `p` turned, and that
/// forces and histories agree.
void expect_same_contacts(const Packing& p, const Packing& q, double tolerance,
                          const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity());

}  // namespace furnas::test
