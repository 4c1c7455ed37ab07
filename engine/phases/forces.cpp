#include "engine/phases/forces.h"

#include "engine/base/parallel.h"
#include "engine/base/refill.h"
#include "engine/kernels/kernels.h"
#include "engine/search/inner_skin.h"

namespace furnas {

template <class Numerics>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                    const std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                    Rows<typename Numerics::Real, Numerics::spins>& rows,
                    ContactState<typename Numerics::Real>& contact_state, InnerList& inner,
                    Eigen::Matrix3d& stress, ContactWork& work) {
  const bool all = inner.outdated;
  if (all && inner.kept) {
    refill(inner.rows, pairs.rows());
    inner.count.resize((particles.size() + contact_piece - 1) / contact_piece);
  }
  const ContactLoop<Numerics> loop{.law = &std::get<typename Numerics::Law>(model.law),
                                   .edges = cell.edges,
                                   .rate = cell.rate,
                                   .time_step = time_step,
                                   .affine = model.affine_velocity,
                                   .particles = particles.data(),
                                   .loads = loads.data(),
                                   .first = pairs.first.data(),
                                   .partner = pairs.partner.data(),
                                   .quarter = pairs.quarter.empty() ? nullptr : pairs.quarter.data(),
                                   .rows_end = pairs.rows(),
                                   .rows = rows.data(),
                                   .springs = contact_state.springs.data(),
                                   .touching = contact_state.touching.data(),
                                   .contacts = contact_state.contacts.data(),
                                   .loaded = contact_state.loaded.data(),
                                   .all = all,
                                   .inner_skin = inner.skin,
                                   .inner = inner.kept ? inner.rows.data() : nullptr,
                                   .inner_count = inner.count.data()};
  const auto kernel = kernels<Numerics>().contacts;
  const auto sum =
      ordered_sum<ContactSum>(particles.size(), contact_piece,
                              [&](std::size_t begin, std::size_t end) { return kernel(loop, begin, end); });
  stress << sum.x.x, sum.x.y, sum.x.z, sum.y.x, sum.y.y, sum.y.z, sum.z.x, sum.z.y, sum.z.z;
  work = sum.work;
  if (all) drop_inner_list_if_needless(pairs, inner);
}

#define FURNAS_INSTANTIATE(Law, Real)                                                             \
  template void contact_forces<Numerics<Law, Real>>(                                              \
      const Model&, const double&, const Cell&, const PairList&,                                  \
      const std::vector<Particle<Real, Law::spins>>&, const std::vector<Load<Real, Law::spins>>&, \
      Rows<Real, Law::spins>&, ContactState<Real>&, InnerList&, Eigen::Matrix3d&, ContactWork&);
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
