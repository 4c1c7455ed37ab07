#pragma once

#include <array>
#include <cstring>

#include "engine/kernels/groups.h"
#include "engine/kernels/kernels.h"

namespace furnas::HWY_NAMESPACE {

/// Whether none of `count` particles has a load.
template <std::size_t count>
HWY_INLINE bool none_has_load(const std::uint8_t* marks) {
  std::uint64_t words[(count + 7) / 8]{};
  std::memcpy(words, marks, count);
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  return (any & has_load * 0x0101010101010101) == 0;
}

/// Whether all of `count` particles sleep.
template <std::size_t count>
HWY_INLINE bool all_sleep(const std::uint8_t* marks) {
  static constexpr auto asleep = [] {
    std::array<std::uint8_t, count> all{};
    all.fill(sleeps);
    return all;
  }();
  return std::memcmp(marks, asleep.data(), count) == 0;
}

/// v -> factor (shear (factor v)): the effect of the cell's rate on velocities, with the constants of
/// CellDragStep.
template <class R>
class CellDrag {
 public:
  explicit CellDrag(const CellDragStep& d)
      : factor_{R(d.factor.x), R(d.factor.y), R(d.factor.z)}, yz_(d.yz), xz_(d.xz), xy_(d.xy) {}

  HWY_INLINE Vec3<R> operator()(const Vec3<R>& v) const {
    const Vec3<R> u{v.x * factor_.x, v.y * factor_.y, v.z * factor_.z};
    return {(u.x - (u.y * xy_ + u.z * xz_)) * factor_.x, (u.y - u.z * yz_) * factor_.y, u.z * factor_.z};
  }

 private:
  Vec3<R> factor_;
  R yz_, xz_, xy_;
};

/// Velocities, spins and inverse masses of the particles in the lanes. If there are fewer particles than
/// lanes, `whole` is false, and the remaining lanes repeat the last of the `count` particles. If `free` is
/// true, the particles have no load, and their spins, which do not change, are not loaded.
template <class S, bool whole, bool free = false>
struct Moving {
  using Real = typename S::Real;
  using R = Lanes<Real>;

  Vec3<R> velocity, spin;
  R inverse_mass, inverse_inertia;

  HWY_INLINE Moving(const Particle<Real, S::spins>* particles, std::size_t count) {
    const auto v = take(particles, count, [](const auto& p) { return &p.velocity.x; });
    velocity = {v.a, v.b, v.c}, inverse_mass = v.d;
    if constexpr (turns) {
      const auto w = take(particles, count, [](const auto& p) { return &p.spin.x; });
      spin = {w.a, w.b, w.c}, inverse_inertia = w.d;
    }
  }

  /// Half a kick.
  HWY_INLINE void kick(const Load<Real, S::spins>* loads, std::size_t count, const R& half_step) {
    if constexpr (free) {
      velocity += Vec3<R>{};  // like a kick with a zero load: -0 becomes 0
      return;
    }
    const auto f = take(loads, count, [](const auto& load) { return &load.force.x; });
    velocity += (half_step * inverse_mass) * Vec3<R>{f.a, f.b, f.c};
    if constexpr (turns) {
      const auto t = take(loads, count, [](const auto& load) { return &load.torque.x; });
      spin += (half_step * inverse_inertia) * Vec3<R>{t.a, t.b, t.c};
    }
  }

  /// Whether all bits of all velocities are 0. A velocity of -0 does not count as rest, because a kick
  /// without load changes it to 0.
  HWY_INLINE bool rest() const {
    const Tag<hwy::MakeUnsigned<Real>> bits;
    const auto of = [&](const R& v) { return hn::BitCast(bits, v.v); };
    const auto any = hn::Or(hn::Or(of(velocity.x), of(velocity.y)), of(velocity.z));
    return hn::AllTrue(bits, hn::Eq(any, hn::Zero(bits)));
  }

  HWY_INLINE void store(Particle<Real, S::spins>* particles, std::size_t count) const {
    const std::size_t all = whole ? R::count : count;
    store_groups<Real>({velocity.x, velocity.y, velocity.z, inverse_mass}, all,
                       [=](std::size_t l) { return &particles[l].velocity.x; });
    if constexpr (turns)
      store_groups<Real>({spin.x, spin.y, spin.z, inverse_inertia}, all,
                         [=](std::size_t l) { return &particles[l].spin.x; });
  }

 private:
  static constexpr bool turns = S::spins && !free;

  template <class Record, class Where>
  static HWY_INLINE Group<Real> take(const Record* records, std::size_t count, Where&& group) {
    return load_groups<Real>(
        [&](std::size_t l) { return group(records[whole || l < count ? l : count - 1]); });
  }
};

/// Half a kick and the drift of particles [begin, end); see DriftLoop. Returns the square of the largest
/// displacement.
template <class S>
class DriftKernel {
 public:
  explicit DriftKernel(const DriftLoop<S>& loop) : loop_(loop), drag_(loop.drag) {}

  double operator()(std::size_t begin, std::size_t end) {
    D largest;
    for (; begin + lanes <= end; begin += lanes) {
      if (all_sleep<lanes>(loop_.loaded + begin)) continue;
      none_has_load<lanes>(loop_.loaded + begin) ? take_on<true, true>(begin, lanes, largest)
                                                 : take_on<true, false>(begin, lanes, largest);
    }
    if (begin < end) take_on<false, false>(begin, end - begin, largest);
    double squares[D::count];
    largest.to(squares);
    double top = 0;
    for (double square : squares) top = top < square ? square : top;
    return top;
  }

 private:
  using Real = typename S::Real;
  using R = Lanes<Real>;
  using D = Lanes<double>;
  static constexpr std::size_t lanes = R::count;

  template <bool whole, bool free>
  HWY_INLINE void take_on(std::size_t i, std::size_t count, D& largest) const {
    Particle<Real, S::spins>* const here = loop_.particles + i;
    if constexpr (whole) fetch_to_write(here + 3 * lanes, lanes);  // a prefetch beyond the array does no harm
    Moving<S, whole, free> m(here, count);
    m.velocity = drag_(m.velocity);
    m.kick(loop_.loads + i, count, R(0.5 * loop_.time_step));
    m.store(here, count);
    Real x[lanes], y[lanes], z[lanes];
    m.velocity.x.to(x), m.velocity.y.to(y), m.velocity.z.to(z);
    for (std::size_t l = 0; l < (whole ? lanes : count); l += D::count)
      largest = larger(largest, move(here, l, whole ? lanes : count, x, y, z));
  }

  static HWY_INLINE D wide(const double* v) { return D::from(v); }
  static HWY_INLINE D wide(const float* v) {
    return D(hn::PromoteTo(Tag<double>(), hn::LoadU(hn::Rebind<float, Tag<double>>(), v)));
  }

  /// Moves the particles [first, first + lanes of D) with an index below `count`. Returns the squares of
  /// their displacements, measured in the cell at the time when the list was built.
  HWY_INLINE D move(Particle<Real, S::spins>* here, std::size_t first, std::size_t count, const Real* x,
                    const Real* y, const Real* z) const {
    const D dt(loop_.time_step);
    const Vec3<D> v = Vec3<D>{wide(x + first), wide(y + first), wide(z + first)} * dt;
    const Vec3<D> s = times(loop_.to_fraction, v);
    std::int64_t fixed[3][D::count];
    to_fixed(s.x, fixed[0]), to_fixed(s.y, fixed[1]), to_fixed(s.z, fixed[2]);
    for (std::size_t l = 0; l < D::count && first + l < count; ++l) {
      Fraction& p = here[first + l].position;
      p.x += static_cast<std::uint64_t>(fixed[0][l]);
      p.y += static_cast<std::uint64_t>(fixed[1][l]);
      p.z += static_cast<std::uint64_t>(fixed[2][l]);
    }
    const Vec3<D> moved = times(loop_.list_edges, s);
    return dot(moved, moved);
  }

  /// furnas::to_fixed() of each lane. A displacement of half a cell or more is wrapped, because the integers
  /// cannot represent it.
  static HWY_INLINE void to_fixed(const D& s, std::int64_t* fixed) {
    const D whole(hn::Round(((s - D(hn::Round(s.v))) * D(two_to_64)).v));
    const D half(0.5 * two_to_64);
    const Tag<std::int64_t> d;
    hn::StoreU(hn::ConvertTo(d, select(whole < half, whole, -half).v), d, fixed);
  }

  const DriftLoop<S>& loop_;
  const CellDrag<R> drag_;
};

}  // namespace furnas::HWY_NAMESPACE
