#include "engine/phases/integrate.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/kernels/kernels.h"

namespace furnas {
namespace {

constexpr std::size_t chunk = 256;

/// v' = -(e + tr(e)/(3 N)) v over half a step, the splitting of Martyna, Tuckerman, Tobias and Klein (Mol.
/// Phys. 87 (1996) 1117): half the diagonal, the shear, half the diagonal. The series of the shear ends at
/// second order, because higher powers vanish. It is therefore exact, and a step backwards undoes a step
/// forwards. LAMMPS ends the series at first order.
CellDragStep cell_drag(const Barostat& bath, const Triangle& rate, std::size_t count, double time_step) {
  const double half = 0.5 * time_step;
  const double common = rate.trace() / (3 * static_cast<double>(count));
  const double xz = bath.legacy ? rate.xz : rate.xz - 0.5 * half * rate.xy * rate.yz;
  const auto factor = [&](double e) { return std::exp(-0.5 * half * (e + common)); };
  return {{factor(rate.xx), factor(rate.yy), factor(rate.zz)}, half * rate.yz, half * xz, half * rate.xy};
}

}  // namespace

template <class Numerics>
void kick_and_drift(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                    const ContactState<typename Numerics::Real>& contact_state,
                    const std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                    std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                    SquaredDisplacement& squared_displacement) {
  const DriftLoop<Numerics> loop{.time_step = time_step,
                                 .drag = cell_drag(bath, cell.rate, particles.size(), time_step),
                                 .to_fraction = inverse(cell.edges),
                                 .list_edges = pairs.edges,
                                 .loaded = contact_state.loaded.data(),
                                 .loads = loads.data(),
                                 .particles = particles.data()};
  const auto kernel = kernels<Numerics>().drift;
  squared_displacement.assign(pairs.classes.size(), 0);
  for (std::size_t c = 0; c < pairs.classes.size(); ++c) {
    const SizeClass& group = pairs.classes[c];
    std::vector<double> largest((group.last - group.first + chunk - 1) / chunk);
    for_chunks(group.last - group.first, chunk, [&](std::size_t begin, std::size_t end, std::size_t piece) {
      largest[piece] = kernel(loop, group.first + begin, group.first + end);
    });
    for (double top : largest) squared_displacement[c] = std::max(squared_displacement[c], top);
  }
}

template <class Numerics>
void gather_and_kick(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                     const Rows<typename Numerics::Real, Numerics::spins>& rows,
                     ContactState<typename Numerics::Real>& contact_state,
                     std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                     std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                     Eigen::Matrix3d& motion) {
  const GatherLoop<Numerics> loop{.time_step = time_step,
                                  .drag = cell_drag(bath, cell.rate, particles.size(), time_step),
                                  .first = pairs.first.data(),
                                  .incoming_first = pairs.incoming_first.data(),
                                  .incoming = pairs.incoming.data(),
                                  .rows_end = pairs.rows(),
                                  .rows = rows.data(),
                                  .contacts = contact_state.contacts.data(),
                                  .loaded = contact_state.loaded.data(),
                                  .loads = loads.data(),
                                  .particles = particles.data()};
  const auto kernel = kernels<Numerics>().gather;
  const auto sum = ordered_sum<Triangle>(
      particles.size(), chunk, [&](std::size_t begin, std::size_t end) { return kernel(loop, begin, end); });
  motion << sum.xx, sum.xy, sum.xz, sum.xy, sum.yy, sum.yz, sum.xz, sum.yz, sum.zz;
}

#define FURNAS_INSTANTIATE(Law, Real)                                                                      \
  template void kick_and_drift<Numerics<Law, Real>>(                                                       \
      const Barostat&, const double&, const Cell&, const PairList&, const ContactState<Real>&,             \
      const std::vector<Load<Real, Law::spins>>&, std::vector<Particle<Real, Law::spins>>&,                \
      SquaredDisplacement&);                                                                               \
  template void gather_and_kick<Numerics<Law, Real>>(                                                      \
      const Barostat&, const double&, const Cell&, const PairList&, const Rows<Real, Law::spins>&,         \
      ContactState<Real>&, std::vector<Load<Real, Law::spins>>&, std::vector<Particle<Real, Law::spins>>&, \
      Eigen::Matrix3d&);
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
