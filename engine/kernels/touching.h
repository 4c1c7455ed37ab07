#pragma once

#ifdef __BMI2__
#include <immintrin.h>
#endif

#include <atomic>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "engine/kernels/groups.h"
#include "engine/kernels/kernels.h"

namespace furnas::HWY_NAMESPACE {

/// Number of candidates (pairs of the list) that are tested together.
constexpr std::size_t block = 128;
constexpr std::size_t margin = 16;  ///< space behind the last candidate, for whole registers

/// The contacts found, in the order of their rows.
template <class Real>
struct Found {
  std::size_t count = 0;
  Real x[block + 2 * margin], y[block + 2 * margin], z[block + 2 * margin];  ///< branch [d_s]
  Real distance[block + 2 * margin];                                         ///< |branch| [d_s]
  Real overlap[block + 2 * margin];                                          ///< [d_s]
  std::uint64_t i[block + 2 * margin], j[block + 2 * margin];                ///< particles, times 8
  std::uint64_t row[block + 2 * margin];                                     ///< row of the list, times 4

  /// Drops the contacts before `from` and moves the others to the front.
  void drop_until(std::size_t from) {
    const std::size_t left = count - from;
    const auto shift = [&](auto* values) { std::memmove(values, values + from, left * sizeof(*values)); };
    shift(x), shift(y), shift(z), shift(distance), shift(overlap), shift(i), shift(j), shift(row);
    count = left;
  }

  /// Copies the contact at `from` to place `n`.
  void copy(std::size_t from, std::size_t n) {
    x[n] = x[from], y[n] = y[from], z[n] = z[from], distance[n] = distance[from], overlap[n] = overlap[from];
    i[n] = i[from], j[n] = j[from], row[n] = row[from];
  }
};

/// Record number `times`/factor of an array. Indices are stored times `factor`, because processors can add a
/// register times 2, 4 or 8 to an address without extra cost.
template <std::size_t factor, class Record>
HWY_INLINE Record& record(Record* records, std::uint64_t times) {
  static_assert(sizeof(Record) % factor == 0);
  using Byte = std::conditional_t<std::is_const_v<Record>, const char, char>;
  return *reinterpret_cast<Record*>(reinterpret_cast<Byte*>(records) + times * (sizeof(Record) / factor));
}

/// Finds the rows of the list whose particles touch. Differences, squares and overlaps have double precision,
/// whatever the precision of the forces.
template <class S>
class TouchingRows {
 public:
  using Real = typename S::Real;

  explicit TouchingRows(const ContactLoop<S>& loop) : loop_(loop) {}

  /// Tests rows [row, stop), at most a block; the first row belongs to particle `i` or a later one. Appends
  /// the rows that touch to `found`. Calls parted(i, j, row, branch) for rows that touched at the last step
  /// but do not touch now.
  template <class Parted>
  void look(std::size_t& i, std::uint64_t row, std::uint64_t stop, Found<Real>& found, Parted&& parted) {
    fetch(stop, stop + block < loop_.rows_end ? stop + block : loop_.rows_end);
    name_owners(i, row, stop);
    count_ = stop - row;
    for (std::size_t n = 0; n < count_; ++n) j_[n] = std::uint64_t{8} * loop_.partner[row + n];
    static_assert(sizeof(Quarter) == sizeof(quarter_[0]));
    if (loop_.quarter != nullptr) std::memcpy(quarter_, loop_.quarter + row, count_ * sizeof(Quarter));
    take();
    compare<false>(row);
    note_changes(row, parted);
    append(found);
  }

  /// The same for `count` entries of the inner list, at most a block.
  template <class Parted>
  void look(const InnerPair* inner, std::size_t count, Found<Real>& found, Parted&& parted) {
    count_ = count;
    for (std::size_t n = 0; n < count; ++n) {
      i_[n] = std::uint64_t{8} * inner[n].i;
      j_[n] = std::uint64_t{8} * inner[n].j;
      row_[n] = std::uint64_t{4} * inner[n].row;
      if (loop_.quarter != nullptr) std::memcpy(quarter_ + n, loop_.quarter + inner[n].row, sizeof(Quarter));
    }
    take();
    compare<true>(0);
    for (std::size_t n = 0; n < count; ++n) note_change(n, inner[n].row, parted);
    append(found);
  }

  /// Adds to the inner list the tested rows whose gap is below the inner skin; `row` is the first of the rows
  /// tested last. Returns how many were added.
  std::size_t note_inner(std::uint64_t row, InnerPair* inner) const {
    const D wider(1 + loop_.inner_skin.relative);
    const D fixed(loop_.inner_skin.fixed);
    std::size_t noted = 0;
    for (std::size_t n = 0; n < count_; n += lanes) {
      const D reach = wider * D::from(reach_ + n) + fixed;
      unsigned bits = bits_of(D::from(square_ + n) < reach * reach);
      for (; bits != 0; bits &= bits - 1) {
        const std::size_t k = n + static_cast<std::size_t>(__builtin_ctz(bits));
        if (k >= count_) break;
        inner[noted++] = {static_cast<RowNumber>(row + k), static_cast<std::uint32_t>(i_[k] / 8),
                          static_cast<std::uint32_t>(j_[k] / 8)};
      }
    }
    return noted;
  }

 private:
  using D = Lanes<double>;
  static constexpr std::size_t lanes = D::count;

  /// Prefetches the records of the partners in the next rows. These records may lie anywhere in memory.
  /// Without prefetching, the processor would wait for each record that is not in its cache or was written by
  /// another core.
  void fetch(std::uint64_t row, std::uint64_t stop) const {
    fetch_to_write(loop_.rows + row, stop - row);
    if constexpr (S::spins) fetch_to_write(loop_.springs + row, stop - row);
    for (; row < stop; ++row) {
      const std::uint32_t j = loop_.partner[row];
      __builtin_prefetch(loop_.particles + j);
      if constexpr (S::Law::synchronized) __builtin_prefetch(loop_.loads + j);
    }
  }

  /// Computes the differences of the positions of the candidates.
  void take() {
    for (std::size_t n = 0; n < count_; ++n) {
      const auto& p = record<8>(loop_.particles, i_[n]);
      const auto& q = record<8>(loop_.particles, j_[n]);
      fixed_[0][n] = static_cast<std::int64_t>(p.position.x - q.position.x);
      fixed_[1][n] = static_cast<std::int64_t>(p.position.y - q.position.y);
      fixed_[2][n] = static_cast<std::int64_t>(p.position.z - q.position.z);
      reach_[n] = static_cast<double>(p.radius) + static_cast<double>(q.radius);
    }
    for (std::size_t k = count_; k < count_ + lanes; ++k) {
      fixed_[0][k] = fixed_[1][k] = fixed_[2][k] = 0;
      quarter_[k] = 0;
      reach_[k] = 0;  // padding of the lanes, which never touches because 0 < 0 is false
    }
  }

  /// Writes the owner of each row, particle i. Each owner is written to eight places at once, and the next
  /// owner overwrites the surplus. A loop over the few rows of each particle would cost one mispredicted
  /// branch per particle.
  void name_owners(std::size_t& i, std::uint64_t row, std::uint64_t stop) {
    std::uint64_t next = row;
    while (loop_.first[i + 1] <= next) ++i;
    while (true) {
      const std::uint64_t end = loop_.first[i + 1] < stop ? loop_.first[i + 1] : stop;
      const auto owner = hn::Set(Tag<std::uint64_t>(), 8 * i);
      do {
        for (std::size_t k = 0; k < 8; k += lanes)
          hn::StoreU(owner, Tag<std::uint64_t>(), i_ + (next - row) + k);
        next += 8;
      } while (next < end);
      next = end;
      if (next == stop) return;
      ++i;
    }
  }

  /// s_i - s_j along an axis, for the image that the row means.
  template <int axis>
  HWY_INLINE D difference(std::size_t n) const {
    const D d(hn::Mul(hn::ConvertTo(Tag<double>(), hn::LoadU(Tag<std::int64_t>(), fixed_[axis] + n)),
                      hn::Set(Tag<double>(), 1 / two_to_64)));
    if (loop_.quarter == nullptr) return d;
    // The four bytes of a quarter are loaded as one number; two shifts extract the byte of the axis with its
    // sign.
    const hn::Rebind<std::int32_t, Tag<double>> words;
    const auto all = hn::LoadU(words, quarter_ + n);
    const auto one = hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * axis>(all));
    const D quarter = D(0.25) * D(hn::PromoteTo(Tag<double>(), one));
    return d + D(hn::Round((quarter - d).v));
  }

  /// Computes the branches of all candidates, and stores those shorter than R_i + R_j consecutively in
  /// `touch_`. The row numbers are those in `row_` if `named`, else they begin at `first`.
  template <bool named>
  void compare(std::uint64_t first) {
    const Triangle h = loop_.edges;  // a copy, so that the compiler knows that no store below changes it
    touching_ = 0;
    // Row numbers times 4. Iota is called only once, because Highway 1.0.3 writes its lanes one by one to
    // memory.
    const Tag<std::uint64_t> whole;
    auto here = hn::ShiftLeft<2>(hn::Iota(whole, first));
    const auto next = hn::Set(whole, 4 * lanes);
    for (std::size_t n = 0; n < count_; n += lanes) {
      const auto [x, y, z] = times(h, Vec3<D>{difference<0>(n), difference<1>(n), difference<2>(n)});
      const D square = x * x + y * y + z * z;
      const D reach = D::from(reach_ + n);
      const unsigned touch = bits_of(square < reach * reach);
      square.to(square_ + n);
      bits_[n / lanes] = static_cast<std::uint8_t>(touch);
      pack(x, touch, touch_.x + touching_), pack(y, touch, touch_.y + touching_),
          pack(z, touch, touch_.z + touching_);
      pack(square, touch, touch_.square + touching_), pack(reach, touch, touch_.reach + touching_);
      pack(D::from_bits(i_ + n), touch, touch_.i + touching_),
          pack(D::from_bits(j_ + n), touch, touch_.j + touching_);
      pack(named ? D::from_bits(row_ + n) : D(hn::BitCast(Tag<double>(), here)), touch,
           touch_.row + touching_);
      here = hn::Add(here, next);
      touching_ += static_cast<std::size_t>(__builtin_popcount(touch));
    }
  }

  static HWY_INLINE unsigned bits_of(const Truths<double>& truths) {
    std::uint8_t bits[8];
    hn::StoreMaskBits(Tag<double>(), truths.mask, bits);
    return bits[0];
  }

  /// Updates the flags of the rows and the contact counts of the particles, and reports contacts that opened.
  /// Counts are written only when a contact forms or opens, so that their cache lines can stay in the caches
  /// of several cores.
  template <class Parted>
  void note_changes(std::uint64_t first, Parted& parted) {
    std::uint8_t* flags = loop_.touching + first;
    for (std::size_t n = 0; n < count_; n += lanes) {
      const std::size_t here = count_ - n < lanes ? count_ - n : lanes;
      const std::uint64_t now = spread(bits_[n / lanes]);
      std::uint64_t before = now;
      if (here == 8)
        std::memcpy(&before, flags + n, 8);
      else
        for (std::size_t k = 0; k < here; ++k) reinterpret_cast<std::uint8_t*>(&before)[k] = flags[n + k];
      if (before == now) continue;
      for (std::size_t k = n; k < n + here; ++k) note_change(k, first + k, parted);
    }
  }

  /// The same for candidate `n`, which belongs to row `row`.
  template <class Parted>
  void note_change(std::size_t n, std::uint64_t row, Parted& parted) {
    const std::uint8_t touches = (bits_[n / lanes] >> n % lanes) & 1;
    if (loop_.touching[row] == touches) return;
    const std::uint64_t i = i_[n] / 8;
    const std::uint64_t j = j_[n] / 8;
    if (touches == 0) parted(i, j, row, branch(n));
    const std::uint32_t more = touches != 0 ? 1 : ~std::uint32_t{0};
    for (const std::uint64_t k : {i, j}) {
      loop_.contacts[k].fetch_add(more, std::memory_order_relaxed);
      std::atomic_ref(loop_.loaded[k]).store(has_load, std::memory_order_relaxed);
    }
    loop_.touching[row] = touches;
  }

  /// Expands each of eight bits to a byte.
  static HWY_INLINE std::uint64_t spread(std::uint8_t bits) {
#ifdef __BMI2__
    return _pdep_u64(bits, 0x0101010101010101);
#else
    std::uint64_t bytes = 0;
    for (int k = 0; k < 8; ++k) bytes |= static_cast<std::uint64_t>((bits >> k) & 1) << (8 * k);
    return bytes;
#endif
  }

  /// Branch of one candidate, as in compare().
  Vec3<double> branch(std::size_t n) const {
    double s[3];
    for (int a = 0; a < 3; ++a) {
      s[a] = static_cast<double>(fixed_[a][n]) * (1 / two_to_64);
      if (loop_.quarter != nullptr)
        s[a] += std::nearbyint(0.25 * static_cast<std::int8_t>(quarter_[n] >> 8 * a) - s[a]);
    }
    return times(loop_.edges, Vec3<double>{s[0], s[1], s[2]});
  }

  static HWY_INLINE void narrow(const D& value, double* to) { value.to(to); }
  static HWY_INLINE void narrow(const D& value, float* to) {
    const hn::Rebind<float, Tag<double>> half;
    hn::StoreU(hn::DemoteTo(half, value.v), half, to);
  }

  void append(Found<Real>& found) {
    for (std::size_t k = touching_; k < touching_ + lanes; ++k)  // fills the last register
      touch_.x[k] = touch_.y[k] = touch_.z[k] = touch_.square[k] = touch_.reach[k] = 1;
    for (std::size_t n = 0; n < touching_; n += lanes) {
      const std::size_t to = found.count + n;
      const D reach = D::from(touch_.reach + n);
      D square = D::from(touch_.square + n);
      // If the centres coincide, there is no normal; the branch is then taken along x.
      const auto coincide = square == D(0);
      const D x = select(coincide, D(1e-9) * reach, D::from(touch_.x + n));
      square = select(coincide, x * x, square);
      const D distance = sqrt(square);
      narrow(x, found.x + to);
      narrow(D::from(touch_.y + n), found.y + to);
      narrow(D::from(touch_.z + n), found.z + to);
      narrow(distance, found.distance + to);
      narrow(reach - distance, found.overlap + to);
    }
    std::memcpy(found.i + found.count, touch_.i, touching_ * 8);
    std::memcpy(found.j + found.count, touch_.j, touching_ * 8);
    std::memcpy(found.row + found.count, touch_.row, touching_ * 8);
    found.count += touching_;
  }

  const ContactLoop<S>& loop_;
  std::size_t count_ = 0;                                ///< candidates of the block
  std::size_t touching_ = 0;                             ///< candidates that touch
  std::int64_t fixed_[3][block + margin];                ///< s_i - s_j [2^-64]
  std::int32_t quarter_[block + margin];                 ///< of the image that the row means, as bytes
  double reach_[block + margin];                         ///< R_i + R_j [d_s]
  std::uint64_t i_[block + margin], j_[block + margin];  ///< particles, times 8
  std::uint64_t row_[block + margin];                    ///< rows of the inner list, times 4
  double square_[block + margin];                        ///< |branch|^2 [d_s^2]
  std::uint8_t bits_[block / lanes + 8];                 ///< which lanes touch
  struct Touching {
    double x[block + margin], y[block + margin], z[block + margin];    ///< branch [d_s]
    double square[block + margin], reach[block + margin];              ///< as above
    double i[block + margin], j[block + margin], row[block + margin];  ///< bits of whole numbers
  } touch_;  ///< candidates that touch, stored consecutively
};

}  // namespace furnas::HWY_NAMESPACE
