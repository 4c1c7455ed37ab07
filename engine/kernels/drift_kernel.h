#pragma once

#include "engine/kernels/groups.h"
#include "engine/kernels/kernels.h"

namespace furnas::HWY_NAMESPACE {

/// v -> factor (shear (factor v)): the cell's drag on velocities, as CellDragStep holds it.
template <class R>
HWY_INLINE Vec3<R> dragged(const CellDragStep& d, const Vec3<R>& v) {
  const Vec3<R> factor{R(d.factor.x), R(d.factor.y), R(d.factor.z)};
  const Vec3<R> u{v.x * factor.x, v.y * factor.y, v.z * factor.z};
  return {(u.x - (u.y * R(d.xy) + u.z * R(d.xz))) * factor.x, (u.y - u.z * R(d.yz)) * factor.y,
          u.z * factor.z};
}

/// The particles of some lanes: what is kicked, and by what. If they are not as many as lanes, `whole` is
/// false, and lanes behind the last of the `count` particles repeat it.
template <class S, bool whole>
struct Moving {
  using Real = typename S::Real;
  using R = Lanes<Real>;

  Vec3<R> velocity, spin;
  R inverse_mass, inverse_inertia;

  HWY_INLINE Moving(const Particle<Real, S::spins>* particles, std::size_t count) {
    const auto v = take(particles, count, [](const auto& p) { return &p.velocity.x; });
    velocity = {v.a, v.b, v.c}, inverse_mass = v.d;
    if constexpr (S::spins) {
      const auto w = take(particles, count, [](const auto& p) { return &p.spin.x; });
      spin = {w.a, w.b, w.c}, inverse_inertia = w.d;
    }
  }

  /// Half a kick.
  HWY_INLINE void kick(const Load<Real, S::spins>* loads, std::size_t count, const R& half_step) {
    const auto f = take(loads, count, [](const auto& load) { return &load.force.x; });
    velocity += (half_step * inverse_mass) * Vec3<R>{f.a, f.b, f.c};
    if constexpr (S::spins) {
      const auto t = take(loads, count, [](const auto& load) { return &load.torque.x; });
      spin += (half_step * inverse_inertia) * Vec3<R>{t.a, t.b, t.c};
    }
  }

  HWY_INLINE void store(Particle<Real, S::spins>* particles, std::size_t count) const {
    const std::size_t all = whole ? R::count : count;
    store_groups<Real>({velocity.x, velocity.y, velocity.z, inverse_mass}, all,
                       [=](std::size_t l) { return &particles[l].velocity.x; });
    if constexpr (S::spins)
      store_groups<Real>({spin.x, spin.y, spin.z, inverse_inertia}, all,
                         [=](std::size_t l) { return &particles[l].spin.x; });
  }

 private:
  template <class Record, class Where>
  static HWY_INLINE Group<Real> take(const Record* records, std::size_t count, Where&& group) {
    return load_groups<Real>(
        [&](std::size_t l) { return group(records[whole || l < count ? l : count - 1]); });
  }
};

/// Half a kick and the drift of some particles; see DriftLoop. Answers the square of the longest way.
template <class S>
class DriftKernel {
 public:
  explicit DriftKernel(const DriftLoop<S>& loop) : loop_(loop) {}

  double operator()(std::size_t begin, std::size_t end) {
    D longest;
    for (; begin + lanes <= end; begin += lanes) take_on<true>(begin, lanes, longest);
    if (begin < end) take_on<false>(begin, end - begin, longest);
    double squares[D::count];
    longest.to(squares);
    double top = 0;
    for (double square : squares) top = top < square ? square : top;
    return top;
  }

 private:
  using Real = typename S::Real;
  using R = Lanes<Real>;
  using D = Lanes<double>;
  static constexpr std::size_t lanes = R::count;

  template <bool whole>
  HWY_INLINE void take_on(std::size_t i, std::size_t count, D& longest) const {
    Particle<Real, S::spins>* const here = loop_.particles + i;
    if constexpr (whole) fetch_to_write(here + 3 * lanes, lanes);  // an address that is none does no harm
    Moving<S, whole> m(here, count);
    m.velocity = dragged(loop_.drag, m.velocity);
    m.kick(loop_.loads + i, count, R(0.5 * loop_.time_step));
    m.store(here, count);
    Real x[lanes], y[lanes], z[lanes];
    m.velocity.x.to(x), m.velocity.y.to(y), m.velocity.z.to(z);
    for (std::size_t l = 0; l < (whole ? lanes : count); l += D::count)
      longest = larger(longest, move(here, l, whole ? lanes : count, x, y, z));
  }

  static HWY_INLINE D wide(const double* v) { return D::from(v); }
  static HWY_INLINE D wide(const float* v) {
    return D(hn::PromoteTo(Tag<double>(), hn::LoadU(hn::Rebind<float, Tag<double>>(), v)));
  }

  /// Moves particles [first, first + lanes of D) as far as they are below `count`; the squares of their ways
  /// in the cell of the list.
  HWY_INLINE D move(Particle<Real, S::spins>* here, std::size_t first, std::size_t count, const Real* x,
                    const Real* y, const Real* z) const {
    const Triangle& g = loop_.to_fraction;
    const D dt(loop_.time_step);
    const Vec3<D> v = Vec3<D>{wide(x + first), wide(y + first), wide(z + first)} * dt;
    const Vec3<D> s{D(g.xx) * v.x + D(g.xy) * v.y + D(g.xz) * v.z, D(g.yy) * v.y + D(g.yz) * v.z,
                    D(g.zz) * v.z};
    // A way of half a cell or more is wrapped: integers cannot hold it.
    double part[3][D::count];
    (s.x - D(hn::Round(s.x.v))).to(part[0]);
    (s.y - D(hn::Round(s.y.v))).to(part[1]);
    (s.z - D(hn::Round(s.z.v))).to(part[2]);
    for (std::size_t l = 0; l < D::count && first + l < count; ++l) {
      Fraction& p = here[first + l].position;
      p.x += part_to_fixed(part[0][l]);
      p.y += part_to_fixed(part[1][l]);
      p.z += part_to_fixed(part[2][l]);
    }
    const Triangle& h = loop_.list_edges;
    const Vec3<D> way{D(h.xx) * s.x + D(h.xy) * s.y + D(h.xz) * s.z, D(h.yy) * s.y + D(h.yz) * s.z,
                      D(h.zz) * s.z};
    return dot(way, way);
  }

  const DriftLoop<S>& loop_;
};

}  // namespace furnas::HWY_NAMESPACE
