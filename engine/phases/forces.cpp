#include "engine/phases/forces.h"

#include "engine/base/parallel.h"
#include "engine/kernels/kernels.h"
#include "engine/search/near_rows.h"

namespace furnas {

template <class Scene>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    Rows<typename Scene::Real, Scene::spins>& rows, Memory<typename Scene::Real>& memory,
                    NearRows& near, Eigen::Matrix3d& stress, ContactWork& work) {
  const bool all = near.worn;
  if (all && near.kept) {
    near.rows.resize(pairs.rows());
    near.count.resize((particles.size() + contact_piece - 1) / contact_piece);
  }
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
                                memory.contacts.data(),
                                memory.loaded.data(),
                                all,
                                near.skin,
                                near.kept ? near.rows.data() : nullptr,
                                near.count.data()};
  const auto kernel = kernels<Scene>().contacts;
  const auto sum =
      ordered_sum<ContactSum>(particles.size(), contact_piece,
                              [&](std::size_t begin, std::size_t end) { return kernel(loop, begin, end); });
  stress << sum.x.x, sum.x.y, sum.x.z, sum.y.x, sum.y.y, sum.y.z, sum.z.x, sum.z.y, sum.z.z;
  work = sum.work;
  if (all) weigh_near_rows(pairs, near);
}

#define FURNAS_INSTANTIATE(Law, Real)                                                             \
  template void contact_forces<Scene<Law, Real>>(                                                 \
      const Model&, const double&, const Cell&, const PairList&,                                  \
      const std::vector<Particle<Real, Law::spins>>&, const std::vector<Load<Real, Law::spins>>&, \
      Rows<Real, Law::spins>&, Memory<Real>&, NearRows&, Eigen::Matrix3d&, ContactWork&);
FURNAS_FOR_EACH_SCENE(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
