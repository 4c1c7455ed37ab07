#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/certificate/backbone.h"
#include "engine/state/packing.h"

namespace furnas {

/// The motions of a packing that no spring resists, to be set going so that a run can follow them to another
/// state of rest. In a packing that a run has brought to rest such a motion grows from rounding errors, which
/// takes more time than the run waits.
class Kick {
 public:
  Kick() = default;
  explicit Kick(std::size_t particles) : velocity_(particles), spin_(particles) {}

  /// Adds a motion of the backbone: u and, with friction, R theta of each of its particles. The particle that
  /// moves most moves by 1.
  void add(const Eigen::VectorXd& motion, const Backbone& backbone, const std::vector<double>& radius);

  /// Number of motions.
  std::int64_t motions() const { return motions_; }

  /// Adds the motions to the velocities and spins of a packing; in each motion the particle that moves most
  /// gets this speed [d_s/time].
  void give(Packing& packing, double speed) const;

 private:
  std::int64_t motions_ = 0;
  std::vector<Vec3<double>> velocity_, spin_;  // of each particle, for a speed of 1
};

/// The speed of a kick at this pressure [k_n/d_s]: 1e-4 from a pressure of 1e-4 on, with which a sphere moves
/// by a few hundredths of a diameter in a window of the default criteria of rest; below, it falls with the
/// pressure, so that the energy of a small sphere is about that of a contact [d_s/time].
inline double kick_speed(double pressure) { return std::min(pressure, 1e-4); }

}  // namespace furnas
