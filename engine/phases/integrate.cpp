#include "engine/phases/integrate.h"

#include <cmath>

#include "engine/base/parallel.h"

namespace furnas {
namespace {

constexpr std::size_t chunk = 256;

/// v' = -(e + tr(e)/(3 N)) v over half a step, the splitting of Martyna, Tuckerman, Tobias and Klein
/// (Mol. Phys. 87 (1996) 1117): half the diagonal, the shear, half the diagonal. The shear is exact to its
/// second order, where it ends, so that a step taken back undoes it; LAMMPS ends it at the first.
class CellDrag {
 public:
  CellDrag(const Barostat& bath, const Triangle& rate, std::size_t count, double time_step)
      : half_(0.5 * time_step), rate_(rate) {
    if (!bath.legacy) rate_.xz -= 0.5 * half_ * rate.xy * rate.yz;
    const double common = rate.trace() / (3 * static_cast<double>(count));
    factor_ = {std::exp(-0.5 * half_ * (rate.xx + common)), std::exp(-0.5 * half_ * (rate.yy + common)),
               std::exp(-0.5 * half_ * (rate.zz + common))};
  }

  template <class R>
  Vec3<R> operator()(const Vec3<R>& velocity) const {
    Vec3<double> v{velocity.x * factor_.x, velocity.y * factor_.y, velocity.z * factor_.z};
    v.x -= half_ * (v.y * rate_.xy + v.z * rate_.xz);
    v.y -= half_ * (v.z * rate_.yz);
    return {R(v.x * factor_.x), R(v.y * factor_.y), R(v.z * factor_.z)};
  }

 private:
  double half_;
  Triangle rate_;
  Vec3<double> factor_;
};

template <class R, bool spins>
void half_kick(Particle<R, spins>& p, const Load<R, spins>& load, R half_step) {
  p.velocity += (half_step * p.inverse_mass) * load.force;
  if constexpr (spins) p.spin += (half_step * p.inverse_inertia) * load.torque;
}

template <class R, bool spins>
Load<R, spins> sum_of_rows(const PairList& pairs, const std::vector<Row<R, spins>>& rows, std::size_t i,
                           R radius) {
  Load<R, spins> sum{};
  const auto add = [&](const Row<R, spins>& row, bool owner) {
    sum.force += owner ? row.force : -row.force;
    if constexpr (spins) sum.torque -= (radius - row.shortening) * row.couple;
  };
  for (std::uint64_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) add(rows[k], true);
  for (std::uint64_t k = pairs.incoming_first[i]; k < pairs.incoming_first[i + 1]; ++k)
    add(rows[pairs.incoming[k]], false);
  return sum;
}

}  // namespace

template <class Scene>
void kick_and_drift(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    LongestWay& longest_way) {
  using Real = typename Scene::Real;
  const CellDrag drag(bath, cell.rate, particles.size(), time_step);
  const Triangle to_fraction_step = inverse(cell.edges);
  longest_way.assign(pairs.classes.size(), 0);
  for (std::size_t c = 0; c < pairs.classes.size(); ++c) {
    const SizeClass& group = pairs.classes[c];
    std::vector<double> longest((group.last - group.first + chunk - 1) / chunk);
    for_chunks(group.last - group.first, chunk, [&](std::size_t begin, std::size_t end, std::size_t piece) {
      double top = 0;
      for (std::size_t i = group.first + begin; i < group.first + end; ++i) {
        auto& p = particles[i];
        p.velocity = drag(p.velocity);
        half_kick(p, loads[i], Real(0.5 * time_step));
        const Vec3<double> v{p.velocity.x, p.velocity.y, p.velocity.z};
        const Vec3<double> s = to_fraction_step * (v * time_step);
        const Fraction moved = to_fraction(s);
        p.position = {p.position.x + moved.x, p.position.y + moved.y, p.position.z + moved.z};
        const Vec3<double> way = pairs.edges * s;
        top = std::max(top, dot(way, way));
      }
      longest[piece] = top;
    });
    for (double top : longest) longest_way[c] = std::max(longest_way[c], top);
  }
}

template <class Scene>
void gather_and_kick(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                     const std::vector<Row<typename Scene::Real, Scene::spins>>& rows,
                     std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                     std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                     Eigen::Matrix3d& motion) {
  using Real = typename Scene::Real;
  struct Motion {
    double xx{}, yy{}, zz{}, yz{}, xz{}, xy{};
    void operator+=(const Motion& b) {
      xx += b.xx, yy += b.yy, zz += b.zz, yz += b.yz, xz += b.xz, xy += b.xy;
    }
  };
  const CellDrag drag(bath, cell.rate, particles.size(), time_step);
  const auto sum = ordered_sum<Motion>(particles.size(), chunk, [&](std::size_t begin, std::size_t end) {
    Motion part;
    for (std::size_t i = begin; i < end; ++i) {
      auto& p = particles[i];
      loads[i] = sum_of_rows(pairs, rows, i, p.radius);
      half_kick(p, loads[i], Real(0.5 * time_step));
      p.velocity = drag(p.velocity);
      const Vec3<double> v{p.velocity.x, p.velocity.y, p.velocity.z};
      const double m = 1 / static_cast<double>(p.inverse_mass);
      part += {m * v.x * v.x, m * v.y * v.y, m * v.z * v.z, m * v.y * v.z, m * v.x * v.z, m * v.x * v.y};
    }
    return part;
  });
  motion << sum.xx, sum.xy, sum.xz, sum.xy, sum.yy, sum.yz, sum.xz, sum.yz, sum.zz;
}

#define FURNAS_INSTANTIATE(Law)                                                                              \
  template void kick_and_drift<Scene<Law, double>>(const Barostat&, const double&, const Cell&,              \
                                                   const PairList&,                                          \
                                                   const std::vector<Load<double, Law::spins>>&,             \
                                                   std::vector<Particle<double, Law::spins>>&, LongestWay&); \
  template void gather_and_kick<Scene<Law, double>>(                                                         \
      const Barostat&, const double&, const Cell&, const PairList&,                                          \
      const std::vector<Row<double, Law::spins>>&, std::vector<Load<double, Law::spins>>&,                   \
      std::vector<Particle<double, Law::spins>>&, Eigen::Matrix3d&);
FURNAS_FOR_EACH_LAW(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
