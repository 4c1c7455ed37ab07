#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/certificate/backbone.h"
#include "engine/certificate/contact_network.h"

namespace furnas {

/// The six strains e of an upper-triangular cell in the order xx yy zz xy xz yz; x moves by e x.
using Strain = Eigen::Matrix<double, 6, 1>;
using StrainMatrix = Eigen::Matrix<double, 6, 6>;

/// A contact of a backbone, with what the equations of small motions need. Motions have displacements u,
/// rotations theta and a strain e.
struct Bond {
  Eigen::Index i, j;       ///< first unknown of each particle
  Eigen::Vector3d branch;  ///< [d_s]
  Eigen::Vector3d normal;
  Eigen::Vector3d friction;                       ///< F_t on i [k_n d_s]
  Eigen::Vector3d sliding;                        ///< direction of F_t at the Coulomb limit, or 0 below it
  double push;                                    ///< F_n [k_n d_s]
  double normal_stiffness, tangential_stiffness;  ///< [k_n]
  double normal_damping, tangential_damping;      ///< m_eff gamma [k_n time]
  double lacking;       ///< how far the two spheres are from balance: net forces and net torques/R [k_n d_s]
  double arm_i, arm_j;  ///< [d_s]
  double radius_i, radius_j;

  Eigen::Vector3d force() const { return push * normal + friction; }  ///< on i [k_n d_s]
};

/// All contacts of a backbone. Each particle has `per_particle` unknowns: u, and with friction R theta.
std::vector<Bond> bonds_of(const ContactNetwork& network, const Backbone& backbone,
                           Eigen::Index per_particle);

/// A particle with only two contacts, which bridges two others. It can spin about the line through its
/// contact points without moving anything else and without changing a force.
struct Bridge {
  Eigen::Index turn;     ///< first unknown of its rotation
  Eigen::Vector3d axis;  ///< of length 1
};

/// The bridges of a backbone; none without friction.
std::vector<Bridge> bridges_of(const std::vector<Bond>& bonds, Eigen::Index per_particle,
                               Eigen::Index unknowns);

/// Motions of a bond: u_i, R_i theta_i, u_j, R_j theta_j, e.
using BondVector = Eigen::Matrix<double, 18, 1>;
using BondMatrix = Eigen::Matrix<double, 18, 18>;
/// Maps a motion of the bond linearly to a number (BondRow) or to a vector (BondRows).
using BondRow = Eigen::Matrix<double, 1, 18>;
using BondRows = Eigen::Matrix<double, 3, 18>;

/// The cross product n x ... as a matrix.
Eigen::Matrix3d crossing(const Eigen::Vector3d& n);

/// e r as a matrix that acts on the six strains.
Eigen::Matrix<double, 3, 6> affine(const Eigen::Vector3d& r);

/// Displacement of i relative to j, including the strain of the cell.
BondRows moved_of(const Eigen::Vector3d& branch);

/// Rotation of i (which = 0) or of j (which = 1).
BondRows turn_of(Eigen::Index which, double radius);

}  // namespace furnas
