#pragma once

#include <Eigen/Core>

namespace furnas {

/// The two parts of the stress times the volume, P V.
struct Stress {
  /// Sum over contacts of branch (x) force, row = branch; symmetric when torques balance [k_n d_s^2].
  Eigen::Matrix3d contacts = Eigen::Matrix3d::Zero();
  /// Sum over particles of m v (x) v of the peculiar velocities [k_n d_s^2].
  Eigen::Matrix3d motion = Eigen::Matrix3d::Zero();

  Eigen::Matrix3d total() const { return contacts + motion; }
};

}  // namespace furnas
