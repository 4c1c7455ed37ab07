#pragma once

#include "engine/kernels/drift_kernel.h"

namespace furnas::HWY_NAMESPACE {

/// Sums the rows of each particle, then half a kick and the cell's drag; see GatherLoop. Returns the sum of m
/// v (x) v.
template <class S>
class GatherKernel {
 public:
  explicit GatherKernel(const GatherLoop<S>& loop) : loop_(loop), drag_(loop.drag) {}

  Triangle operator()(std::size_t begin, std::size_t end) {
    Vec3<R> diagonal[parts], shear[parts];
    for (std::size_t i = begin; i < end; i += batch) {
      const std::size_t stop = end - i < batch ? end : i + batch;
      if (i + batch == stop && all_sleep<batch>(loop_.loaded + i)) continue;
      if (stop + 3 * batch <= end) fetch_to_write(loop_.particles + stop + 2 * batch, batch);
      // In a gas most particles touch nothing; the same is true of rattlers.
      if (i + batch == stop && none_has_load<batch>(loop_.loaded + i)) {
        bool rest = true;
        for (std::size_t part = 0; part < parts; ++part)
          rest &= kick<true, true>(i + part * lanes, lanes, diagonal[part], shear[part]);
        if (rest) std::memset(loop_.loaded + i, sleeps, batch);
        continue;
      }
      fetch(loop_.incoming_first[stop]);
      if (stop + 3 * batch <= end) fetch_to_write(loop_.loads + stop + 2 * batch, batch);
      for (std::size_t k = i; k < stop; ++k) sum_rows(k);
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t at = i + part * lanes;
        if (at + lanes <= stop)
          kick<true, false>(at, lanes, diagonal[part], shear[part]);
        else if (at < stop)
          kick<false, false>(at, stop - at, diagonal[part], shear[part]);
      }
    }
    const Vec3<double> d = over_places(diagonal);
    const Vec3<double> s = over_places(shear);
    return {d.x, d.y, d.z, s.x, s.y, s.z};
  }

 private:
  using Real = typename S::Real;
  using R = Lanes<Real>;
  using RowOf = Row<Real, S::spins>;
  static constexpr std::size_t batch = 16;
  static constexpr std::size_t lanes = R::count;
  static constexpr std::size_t parts = batch / lanes;
  static constexpr std::size_t numbers = sizeof(RowOf) / sizeof(Real);

  /// Numbers of one row in one or more registers.
  using Tags = hn::CappedTag<Real, numbers>;
  static constexpr std::size_t width = HWY_MIN(numbers, HWY_LANES(Real));
  static constexpr std::size_t registers = numbers / width;

  /// Factors that turn the numbers of a row into the force and the torque on a particle: 1 or -1 for the
  /// force, minus the lever arm for the couple. The products of the fourth number of each group are not used.
  static HWY_INLINE hn::Vec<Tags> factor(Real sign, const Real* minus_arm, std::size_t r) {
    const Tags d;
    if constexpr (!S::spins) {
      (void)minus_arm, (void)r;
      return hn::Set(d, sign);
    } else if constexpr (width == 8) {
      return hn::IfThenElse(hn::FirstN(d, 4), hn::Set(d, sign), hn::Set(d, *minus_arm));
    } else {
      return hn::Set(d, r * width < 4 ? sign : *minus_arm);
    }
  }

  /// Adds the force and torque of a row to the sums of a particle.
  static HWY_INLINE void add_row(const RowOf& row, Real sign, const Real* minus_arm, hn::Vec<Tags>* sum) {
    const Tags d;
    for (std::size_t r = 0; r < registers; ++r)
      sum[r] = hn::Add(sum[r], hn::Mul(hn::LoadU(d, &row.force.x + r * width), factor(sign, minus_arm, r)));
  }

  /// Prefetches the next rows; see TouchingRows::fetch.
  HWY_INLINE void fetch(std::uint64_t incoming) const {
    const std::uint64_t end = incoming + 4 * batch < loop_.rows_end ? incoming + 4 * batch : loop_.rows_end;
    for (; incoming < end; ++incoming) __builtin_prefetch(loop_.rows + loop_.incoming[incoming]);
  }

  HWY_INLINE void sum_rows(std::size_t i) const {
    const bool touches = loop_.contacts[i].load(std::memory_order_relaxed) != 0;
    loop_.loaded[i] = touches ? has_load : no_load;
    if (!touches) {
      loop_.loads[i] = {};
      return;
    }
    const auto arm_i = [](const RowOf& row) -> const Real* {
      if constexpr (S::spins)
        return &row.minus_arm_i;
      else
        return nullptr;
    };
    const auto arm_j = [](const RowOf& row) -> const Real* {
      if constexpr (S::spins)
        return &row.minus_arm_j;
      else
        return nullptr;
    };
    const Tags d;
    hn::Vec<Tags> sum[registers];
    for (auto& s : sum) s = hn::Zero(d);
    for (std::uint64_t k = loop_.first[i]; k < loop_.first[i + 1]; ++k)
      add_row(loop_.rows[k], Real(1), arm_i(loop_.rows[k]), sum);
    for (std::uint64_t n = loop_.incoming_first[i]; n < loop_.incoming_first[i + 1]; ++n) {
      const RowOf& row = loop_.rows[loop_.incoming[n]];
      add_row(row, Real(-1), arm_j(row), sum);
    }
    for (std::size_t r = 0; r < registers; ++r) hn::StoreU(sum[r], d, &loop_.loads[i].force.x + r * width);
  }

  /// Half a kick and the cell's drag for `count` particles, and their contribution to the sums. Returns
  /// whether all of them are now at rest.
  template <bool whole, bool free>
  HWY_INLINE bool kick(std::size_t at, std::size_t count, Vec3<R>& diagonal, Vec3<R>& shear) const {
    Moving<S, whole, free> m(loop_.particles + at, count);
    m.kick(loop_.loads + at, count, R(0.5 * loop_.time_step));
    m.velocity = drag_(m.velocity);
    m.store(loop_.particles + at, count);
    const R mass = R(1) / m.inverse_mass;
    const Vec3<R>& v = m.velocity;
    Vec3<R> d{mass * v.x * v.x, mass * v.y * v.y, mass * v.z * v.z};
    Vec3<R> s{mass * v.y * v.z, mass * v.x * v.z, mass * v.x * v.y};
    if constexpr (!whole) {
      Real counts[lanes];
      for (std::size_t l = 0; l < lanes; ++l) counts[l] = l < count ? Real(1) : Real(0);
      const auto counted = R::from(counts) > R(0);
      d = select(counted, d, Vec3<R>{});
      s = select(counted, s, Vec3<R>{});
    }
    diagonal += d;
    shear += s;
    return m.rest();
  }

  static Vec3<double> over_places(const Vec3<R>* sums) {
    Vec3<double> total{};
    for (std::size_t part = 0; part < parts; ++part) {
      Real x[lanes], y[lanes], z[lanes];
      sums[part].x.to(x), sums[part].y.to(y), sums[part].z.to(z);
      for (std::size_t l = 0; l < lanes; ++l) total += {double(x[l]), double(y[l]), double(z[l])};
    }
    return total;
  }

  const GatherLoop<S>& loop_;
  const CellDrag<R> drag_;
};

}  // namespace furnas::HWY_NAMESPACE
