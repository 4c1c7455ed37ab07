#pragma once

#include "engine/kernels/touching.h"

// The law is applied to batches of sixteen contacts. Pairs that do not touch are left out, so lanes are used
// fully even if most pairs of the list do not touch. The contacts of a batch are consecutive contacts of the
// list, so the batches depend on the contacts alone, not on the skin. Each of the sixteen places has its own
// sums, whatever the width of the processor's lanes, so the result does not depend on the instruction set
// either.
namespace furnas::HWY_NAMESPACE {

constexpr std::size_t batch = 16;  ///< contacts computed together

/// Sums for the places of a batch that share one register.
template <class R>
struct PartSum {
  Vec3<R> x, y, z;          ///< branch (x) force
  Vec3<R> diagonal, shear;  ///< of ContactWork::push: xx yy zz, yz xz xy
  Vec3<R> lost;             ///< normal damping, tangential damping, sliding
};

template <class S>
class ContactKernel {
 public:
  explicit ContactKernel(const ContactLoop<S>& loop) : loop_(loop), rows_(loop) {}

  ContactSum operator()(std::size_t begin, std::size_t end) {
    if (loop_.all)
      go_through_all(begin, end);
    else
      go_through_inner(begin);
    if (found_.count > 0) {
      places_ = places_ < found_.count ? found_.count : places_;
      for (std::size_t n = found_.count; n < batch; ++n) found_.copy(found_.count - 1, n);
      apply<false>(0, found_.count);
    }
    return total();
  }

 private:
  using Real = typename S::Real;
  using R = Lanes<Real>;

  /// Goes through all rows of particles [begin, end); fills the inner list, if wanted.
  void go_through_all(std::size_t begin, std::size_t end) {
    std::size_t i = begin;
    InnerPair* const inner = loop_.inner == nullptr ? nullptr : loop_.inner + loop_.first[begin];
    std::size_t noted = 0;
    const std::uint64_t last = loop_.first[end];
    for (std::uint64_t row = loop_.first[begin]; row < last; row += block) {
      rows_.look(i, row, last - row < block ? last : row + block, found_, opener());
      if (inner != nullptr) noted += rows_.note_inner(row, inner + noted);
      apply_whole_batches();
    }
    if (inner != nullptr) loop_.inner_count[begin / contact_piece] = static_cast<std::uint32_t>(noted);
  }

  /// Goes through the inner list of the piece of particles that starts at `begin`.
  void go_through_inner(std::size_t begin) {
    const InnerPair* inner = loop_.inner + loop_.first[begin];
    for (std::size_t left = loop_.inner_count[begin / contact_piece]; left > 0;) {
      const std::size_t here = left < block ? left : block;
      rows_.look(inner, here, found_, opener());
      apply_whole_batches();
      inner += here, left -= here;
    }
  }

  /// The function to call for contacts that open.
  auto opener() {
    return [this](std::size_t a, std::size_t b, std::uint64_t k, const Vec3<double>& branch) {
      open(a, b, k, branch);
    };
  }

  void apply_whole_batches() {
    std::size_t done = 0;
    for (; done + batch <= found_.count; done += batch) apply<true>(done, batch);
    if (done == 0) return;
    places_ = batch;
    found_.drop_until(done);
  }

  static constexpr std::size_t lanes = R::count;
  static constexpr std::size_t parts = batch / lanes;
  static_assert(batch % lanes == 0);

  /// A vector and a number for each of the two particles.
  struct Pair {
    Vec3<R> i, j;
    R i_last, j_last;
  };

  /// Loads a group of four numbers from the records of both particles of each contact; `group` returns its
  /// address.
  template <class Record, class Where>
  HWY_INLINE Pair take(const Record* records, std::size_t at, Where&& group) const {
    const Group<Real> i =
        load_groups<Real>([&](std::size_t l) { return group(record<8>(records, found_.i[at + l])); });
    const Group<Real> j =
        load_groups<Real>([&](std::size_t l) { return group(record<8>(records, found_.j[at + l])); });
    return {{i.a, i.b, i.c}, {j.a, j.b, j.c}, i.d, j.d};
  }

  /// Writes a vector and a number to each of the `valid` rows.
  template <class Where>
  HWY_INLINE void put(const Vec3<R>& v, const R& last, std::size_t at, std::size_t valid,
                      Where&& group) const {
    store_groups<Real>({v.x, v.y, v.z, last}, valid,
                       [&](std::size_t l) { return group(found_.row[at + l]); });
  }

  /// Difference of the cell's flow between the two ends of a branch.
  template <class T>
  static HWY_INLINE Vec3<T> flow(const Triangle& e, const Vec3<T>& b) {
    return times(e, b);
  }

  /// Computes rows, histories and sums of a batch, of which the first `valid` contacts count.
  template <bool whole>
  [[gnu::flatten]] void apply(std::size_t from, std::size_t valid) {
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t at = from + part * lanes;
      const std::size_t done = part * lanes;
      const std::size_t here = whole || valid >= done + lanes ? lanes : valid > done ? valid - done : 0;
      apply_part<whole>(at, here, sums_[part]);
    }
  }

  template <bool whole>
  HWY_INLINE void apply_part(std::size_t at, std::size_t valid, PartSum<R>& sum) {
    Touch<R> touch;
    touch.branch = {R::from(found_.x + at), R::from(found_.y + at), R::from(found_.z + at)};
    touch.distance = R::from(found_.distance + at);
    touch.overlap = R::from(found_.overlap + at);
    touch.time_step = R(loop_.time_step);
    see(at, touch);

    Spring<Real>* const springs = loop_.springs;
    const auto history_at = [springs](std::uint64_t row) { return &record<4>(springs, row).history.x; };
    Vec3<R> history{};
    if constexpr (S::spins) {
      const Group<Real> g = load_groups<Real>([&](std::size_t l) { return history_at(found_.row[at + l]); });
      history = {g.a, g.b, g.c};
    }
    const Reaction<R> reaction = (*loop_.law)(touch, history);
    const Vec3<R> normal = touch.branch * (R(1) / touch.distance);

    auto* const rows = loop_.rows;
    const auto force_at = [rows](std::uint64_t row) { return &record<4>(rows, row).force.x; };
    if constexpr (S::spins) {
      put(reaction.force, reaction.shortening - touch.radius_i, at, valid, force_at);
      put(cross(normal, reaction.force), reaction.shortening - touch.radius_j, at, valid,
          [rows](std::uint64_t row) { return &record<4>(rows, row).couple.x; });
      put(history, R(0), at, valid, history_at);
    } else {
      put(reaction.force, R(0), at, valid, force_at);
    }
    add<whole>(reaction, normal, touch.branch, valid, sum);
  }

  /// The relative motion of the particles.
  HWY_INLINE void see(std::size_t at, Touch<R>& touch) const {
    const Pair v = take(loop_.particles, at, [](const auto& p) { return &p.velocity.x; });
    touch.midway.velocity = v.i - v.j;
    touch.drift = touch.midway.velocity + flow(loop_.rate, touch.branch);
    if (loop_.affine) touch.midway.velocity = touch.drift;
    touch.reduced_mass = R(1) / (v.i_last + v.j_last);

    // Loads the radius with the three numbers behind it, which are not used. Inserting single radii into the
    // lanes would be slower.
    const auto radii = [&](const std::uint64_t* of) {
      return load_groups<Real>([&](std::size_t l) { return &record<8>(loop_.particles, of[at + l]).radius; })
          .a;
    };
    touch.radius_i = radii(found_.i);
    touch.radius_j = radii(found_.j);

    Pair w;
    if constexpr (S::spins) {
      w = take(loop_.particles, at, [](const auto& p) { return &p.spin.x; });
      touch.midway.spin_i = w.i;
      touch.midway.spin_j = w.j;
    }
    if constexpr (S::Law::synchronized) {
      // The motion at the end of the step, predicted with the forces at its start; second order in the step.
      const R half(0.5 * loop_.time_step);
      const Pair f = take(loop_.loads, at, [](const auto& load) { return &load.force.x; });
      touch.now.velocity = touch.midway.velocity + half * (v.i_last * f.i - v.j_last * f.j);
      if constexpr (S::spins) {
        const Pair t = take(loop_.loads, at, [](const auto& load) { return &load.torque.x; });
        touch.now.spin_i = w.i + (half * w.i_last) * t.i;
        touch.now.spin_j = w.j + (half * w.j_last) * t.j;
      }
    }
  }

  /// Adds to the sums. The flow of the cell does work on damping and friction only if relative velocities
  /// include the flow.
  template <bool whole>
  HWY_INLINE void add(const Reaction<R>& r, const Vec3<R>& normal, const Vec3<R>& b, std::size_t valid,
                      PartSum<R>& sum) const {
    const Vec3<R> push = loop_.affine ? r.force : r.normal_spring * normal;
    PartSum<R> more{b.x * r.force,
                    b.y * r.force,
                    b.z * r.force,
                    {push.x * b.x, push.y * b.y, push.z * b.z},
                    {push.y * b.z, push.x * b.z, push.x * b.y},
                    {r.losses.normal_damping, r.losses.tangential_damping, r.losses.sliding}};
    if constexpr (!whole) {
      Real counts[lanes];
      for (std::size_t l = 0; l < lanes; ++l) counts[l] = l < valid ? Real(1) : Real(0);
      const auto counted = R::from(counts) > R(0);
      const auto only = [&](Vec3<R>& v) { v = select(counted, v, Vec3<R>{}); };
      only(more.x), only(more.y), only(more.z), only(more.diagonal), only(more.shear), only(more.lost);
    }
    sum.x += more.x, sum.y += more.y, sum.z += more.z;
    sum.diagonal += more.diagonal, sum.shear += more.shear, sum.lost += more.lost;
  }

  /// Books the energy that is left in the tangential spring of a contact that opens. During half of this step
  /// the spring has still done work.
  void open(std::size_t a, std::size_t b, std::uint64_t row, const Vec3<double>& branch) {
    loop_.rows[row] = {};
    if constexpr (S::spins) {
      Vec3<Real>& xi = loop_.springs[row].history;
      const auto& i = loop_.particles[a];
      const auto& j = loop_.particles[b];
      const auto wide = [](const Vec3<Real>& v) { return Vec3<double>{v.x, v.y, v.z}; };
      const Vec3<double> normal = branch * (1 / std::sqrt(dot(branch, branch)));
      RelativeMotion<double> motion{wide(i.velocity) - wide(j.velocity), wide(i.spin), wide(j.spin)};
      if (loop_.affine) motion.velocity += flow(loop_.rate, branch);
      const Vec3<double> slip = slip_velocity(motion, normal, double(i.radius), double(j.radius));
      const Touch<double> touch =
          resting_touch(i.radius, j.radius, 1 / (double(i.inverse_mass) + j.inverse_mass), 0);
      opening_ += loop_.law->energy(touch, wide(xi)).tangential +
                  0.5 * loop_.time_step * loop_.law->stiffness(touch).tangential * dot(wide(xi), slip);
      xi = {};
    }
  }

  /// The sum over the places of a batch, in their order.
  Vec3<double> over_places(Vec3<R> PartSum<R>::*what) const {
    Vec3<double> total{};
    for (std::size_t part = 0; part * lanes < places_; ++part) {
      const Vec3<R>& v = sums_[part].*what;
      Real x[lanes], y[lanes], z[lanes];
      v.x.to(x), v.y.to(y), v.z.to(z);
      for (std::size_t l = 0; l < lanes && part * lanes + l < places_; ++l)
        total += {double(x[l]), double(y[l]), double(z[l])};
    }
    return total;
  }

  ContactSum total() const {
    ContactSum out;
    out.x = over_places(&PartSum<R>::x);
    out.y = over_places(&PartSum<R>::y);
    out.z = over_places(&PartSum<R>::z);
    const Vec3<double> diagonal = over_places(&PartSum<R>::diagonal);
    const Vec3<double> shear = over_places(&PartSum<R>::shear);
    const Vec3<double> lost = over_places(&PartSum<R>::lost);
    out.work = {{diagonal.x, diagonal.y, diagonal.z, shear.x, shear.y, shear.z},
                {lost.x, lost.y, lost.z, opening_}};
    return out;
  }

  const ContactLoop<S>& loop_;
  TouchingRows<S> rows_;
  Found<Real> found_;
  PartSum<R> sums_[parts];
  std::size_t places_ = 0;  ///< number of places of a batch that have been used
  double opening_ = 0;
};

}  // namespace furnas::HWY_NAMESPACE
