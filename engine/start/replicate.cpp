#include "engine/start/replicate.h"

#include <limits>
#include <string>

#include "engine/base/require.h"
#include "engine/search/size_classes.h"

namespace furnas {
namespace {

/// A place along one edge: a cell and the fraction within it, in units of 2^-64.
struct Place {
  std::int32_t cell;
  std::uint64_t fraction;
};

/// (cell + fraction)/times, rounded down to a fraction of the larger cell: floor((cell 2^64 +
/// fraction)/times).
std::uint64_t divided(const Place& place, std::int32_t times) {
  const auto n = static_cast<std::uint64_t>(times);
  const auto m = static_cast<std::uint64_t>(place.cell);
  // 2^64 = quotient n + rest, though it has no 64 bits itself; for n = 1 only m = 0 exists.
  const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t quotient = largest / n + (largest % n + 1) / n;
  const std::uint64_t rest = (largest % n + 1) % n;
  return m * quotient + place.fraction / n + (place.fraction % n + m * rest) / n;
}

/// Cells between the difference of two fractions and the nearest image of it.
std::int32_t cells_to_nearest(std::uint64_t i, std::uint64_t j) {
  const bool nearest_is_negative = static_cast<std::int64_t>(i - j) < 0;
  return (i < j && !nearest_is_negative ? 1 : 0) - (i >= j && nearest_is_negative ? 1 : 0);
}

std::int32_t floored_quotient(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// One edge of the packing and of its replicate.
struct Edge {
  std::uint64_t Fraction::*component;
  std::size_t axis;
  std::int32_t times;

  std::uint64_t fraction(const Fraction& s, std::int32_t cell) const {
    return divided({cell, s.*component}, times);
  }
  /// Cells crossed by the copy in `cell`: so that the copies of a way are whole cells of the old packing
  /// apart.
  std::int32_t image(const Image& image, std::int32_t cell) const {
    return floored_quotient(image[axis] - cell + times - 1, times);
  }
};

Ledger times_as_much(double factor, const Ledger& ledger) {
  Ledger all = ledger;
  for (double* sum : {&all.initial, &all.cell_work, &all.quenched}) *sum *= factor;
  Triangle& push = all.last.push;
  for (double* sum : {&push.xx, &push.yy, &push.zz, &push.yz, &push.xz, &push.xy}) *sum *= factor;
  all.losses = factor * ledger.losses;
  all.last.losses = factor * ledger.last.losses;
  return all;
}

/// Makes the replicate of a packing.
class Replica {
 public:
  Replica(const Packing& from, const Times& times)
      : from_(from),
        times_(times),
        edges_{{{&Fraction::x, 0, times[0]}, {&Fraction::y, 1, times[1]}, {&Fraction::z, 2, times[2]}}} {}

  Packing make() {
    cell_and_sums();
    particles();
    contacts();
    labels();
    if (!from_.order.empty()) to_.order = memory_order(to_);
    return std::move(to_);
  }

 private:
  std::size_t copy_at(const Times& cell) const {
    const auto at = [](std::int32_t n) { return static_cast<std::size_t>(n); };
    return (at(cell[2]) * at(times_[1]) + at(cell[1])) * at(times_[0]) + at(cell[0]);
  }
  template <class Visit>
  void for_each_cell(Visit&& visit) const {
    for (std::int32_t z = 0; z < times_[2]; ++z)
      for (std::int32_t y = 0; y < times_[1]; ++y)
        for (std::int32_t x = 0; x < times_[0]; ++x) visit(Times{x, y, z});
  }

  void cell_and_sums() {
    const auto [nx, ny, nz] = std::array<double, 3>{double(times_[0]), double(times_[1]), double(times_[2])};
    const Triangle& h = from_.cell.edges;
    to_.step = from_.step;
    to_.time = from_.time;
    to_.cell = {{h.xx * nx, h.yy * ny, h.zz * nz, h.yz * nz, h.xz * nz, h.xy * ny}, from_.cell.rate};
    const auto copies = static_cast<double>(copies_of(times_));
    to_.stress = {copies * from_.stress.contacts, copies * from_.stress.motion};
    to_.ledger = times_as_much(copies, from_.ledger);
  }

  void particles() {
    to_.resize(from_.size() * copies_of(times_));
    for_each_cell([&](const Times& cell) {
      const std::size_t first = copy_at(cell) * from_.size();
      for (std::size_t k = 0; k < from_.size(); ++k) {
        const std::size_t n = first + k;
        to_.species[n] = from_.species[k];
        to_.radius[n] = from_.radius[k];
        to_.mass[n] = from_.mass[k];
        to_.velocity[n] = from_.velocity[k];
        to_.spin[n] = from_.spin[k];
        to_.force[n] = from_.force[k];
        to_.torque[n] = from_.torque[k];
        for (const Edge& e : edges_) {
          to_.fraction[n].*e.component = e.fraction(from_.fraction[k], cell[e.axis]);
          to_.image[n][e.axis] = e.image(from_.image[k], cell[e.axis]);
        }
      }
    });
  }

  /// Copies have the types of their particles, and new ids.
  void labels() {
    to_.labels.names = from_.labels.names;
    to_.labels.origin = from_.labels.origin;
    for (std::size_t copy = 0; copy < copies_of(times_); ++copy)
      to_.labels.type.insert(to_.labels.type.end(), from_.labels.type.begin(), from_.labels.type.end());
  }

  void contacts() {
    to_.contacts.reserve(from_.contacts.size() * copies_of(times_));
    for_each_cell([&](const Times& cell) {
      for (const Contact& c : from_.contacts) to_.contacts.push_back(moved(c, cell));
    });
  }

  /// The contact whose first particle is in `cell`.
  Contact moved(const Contact& contact, const Times& cell) const {
    Contact c = contact;
    Times cell_of_j{};
    for (const Edge& e : edges_) {
      const std::uint64_t i = from_.fraction[contact.i].*e.component;
      const std::uint64_t j = from_.fraction[contact.j].*e.component;
      // The branch is (s_i - s_j + away) old edges: j is touched `away` cells below that of i.
      const std::int32_t away = cells_to_nearest(i, j) + contact.image[e.axis];
      const std::int32_t below = cell[e.axis] - away;
      const std::int32_t new_away = -floored_quotient(below, e.times);
      cell_of_j[e.axis] = below + new_away * e.times;
      const std::int32_t image = new_away - cells_to_nearest(divided({cell[e.axis], i}, e.times),
                                                             divided({cell_of_j[e.axis], j}, e.times));
      c.image[e.axis] = static_cast<std::int8_t>(image);
    }
    c.i = static_cast<std::uint32_t>(copy_at(cell) * from_.size() + contact.i);
    c.j = static_cast<std::uint32_t>(copy_at(cell_of_j) * from_.size() + contact.j);
    return c;
  }

  const Packing& from_;
  Times times_;
  std::array<Edge, 3> edges_;
  Packing to_;
};

}  // namespace

Packing replicate(const Packing& packing, const Times& times) {
  auto particles = static_cast<double>(packing.size());
  for (const std::int32_t n : times) {
    if (n < 1) throw InputError("times = " + std::to_string(n) + " along an edge: allowed: 1 or more");
    particles *= n;
  }
  if (particles > static_cast<double>(most_particles))
    throw InputError("more particles than " + std::to_string(most_particles));
  return Replica(packing, times).make();
}

}  // namespace furnas
