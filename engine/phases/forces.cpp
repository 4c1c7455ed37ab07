#include "engine/phases/forces.h"

#include "engine/base/parallel.h"
#include "engine/kernels/kernels.h"

namespace furnas {
namespace {

// Pieces of particles, not of rows, so that the order of the sums does not depend on the skin.
constexpr std::size_t chunk = 128;

}  // namespace

template <class Scene>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    Rows<typename Scene::Real, Scene::spins>& rows, Memory<typename Scene::Real>& memory,
                    Eigen::Matrix3d& stress, ContactWork& work) {
  const ContactLoop<Scene> loop{&std::get<typename Scene::Law>(model.law),
                                cell.edges,
                                cell.rate,
                                time_step,
                                model.affine_velocity,
                                particles.data(),
                                loads.data(),
                                pairs.first.data(),
                                pairs.partner.data(),
                                pairs.quarter.empty() ? nullptr : pairs.quarter.data(),
                                pairs.rows(),
                                rows.data(),
                                memory.springs.data(),
                                memory.touching.data(),
                                memory.contacts.data()};
  const auto kernel = kernels<Scene>().contacts;
  const auto sum = ordered_sum<ContactSum>(
      particles.size(), chunk, [&](std::size_t begin, std::size_t end) { return kernel(loop, begin, end); });
  stress << sum.x.x, sum.x.y, sum.x.z, sum.y.x, sum.y.y, sum.y.z, sum.z.x, sum.z.y, sum.z.z;
  work = sum.work;
}

#define FURNAS_INSTANTIATE(Law, Real)                                                             \
  template void contact_forces<Scene<Law, Real>>(                                                 \
      const Model&, const double&, const Cell&, const PairList&,                                  \
      const std::vector<Particle<Real, Law::spins>>&, const std::vector<Load<Real, Law::spins>>&, \
      Rows<Real, Law::spins>&, Memory<Real>&, Eigen::Matrix3d&, ContactWork&);
FURNAS_FOR_EACH_SCENE(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
