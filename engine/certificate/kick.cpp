#include "engine/certificate/kick.h"

#include <algorithm>
#include <cmath>

namespace furnas {

void Kick::add(const Eigen::VectorXd& motion, const Backbone& backbone, const std::vector<double>& radius) {
  const auto count = static_cast<Eigen::Index>(backbone.particles.size());
  if (count == 0) return;
  const Eigen::Index each = motion.size() / count;
  double most = 0;
  for (Eigen::Index n = 0; n < count; ++n) most = std::max(most, motion.segment(each * n, each).norm());
  if (!(most > 0)) return;
  const auto part = [&](Eigen::Index from) {
    return Vec3<double>{motion[from], motion[from + 1], motion[from + 2]};
  };
  for (Eigen::Index n = 0; n < count; ++n) {
    const std::uint32_t k = backbone.particles[static_cast<std::size_t>(n)];
    velocity_[k] += part(each * n) * (1 / most);
    if (each == 6) spin_[k] += part(each * n + 3) * (1 / (most * radius[k]));
  }
  ++motions_;
}

void Kick::give(Packing& packing, double speed) const {
  for (std::size_t k = 0; k < velocity_.size(); ++k) {
    packing.velocity[k] += speed * velocity_[k];
    packing.spin[k] += speed * spin_[k];
  }
}

}  // namespace furnas
