#include "engine/start/replicate.h"

#include <limits>
#include <string>

#include "engine/base/require.h"
#include "engine/search/size_classes.h"

namespace furnas {
namespace {

/// A position along one edge: a cell, and the fraction within this cell in units of 2^-64.
struct Place {
  std::int32_t cell;
  std::uint64_t fraction;
};

/// (cell + fraction)/times, rounded down to a fraction of the larger cell: floor((cell 2^64 +
/// fraction)/times).
std::uint64_t divided(const Place& place, std::int32_t times) {
  const auto n = static_cast<std::uint64_t>(times);
  const auto m = static_cast<std::uint64_t>(place.cell);
  // Computes quotient and rest of 2^64 = quotient n + rest, although 2^64 does not fit in 64 bits. For n = 1
  // the quotient overflows, but then m = 0.
  const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t quotient = largest / n + (largest % n + 1) / n;
  const std::uint64_t rest = (largest % n + 1) % n;
  return m * quotient + place.fraction / n + (place.fraction % n + m * rest) / n;
}

/// Number of cells between the difference of two fractions and its nearest image.
std::int32_t cells_to_nearest(std::uint64_t i, std::uint64_t j) {
  const bool nearest_is_negative = static_cast<std::int64_t>(i - j) < 0;
  return (i < j && !nearest_is_negative ? 1 : 0) - (i >= j && nearest_is_negative ? 1 : 0);
}

std::int64_t floored_quotient(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// One edge of the packing and of its replica.
struct Edge {
  std::uint64_t Fraction::*component;
  std::size_t axis;
  std::int32_t times;

  std::uint64_t fraction(const Fraction& s, std::int32_t cell) const {
    return divided({cell, s.*component}, times);
  }
  /// Number of new cells crossed by the copy in `cell`, such that the unwrapped positions of the copies
  /// differ by whole old cells.
  std::int32_t image(const Image& image, std::int32_t cell) const {
    return static_cast<std::int32_t>(floored_quotient(std::int64_t{image[axis]} - cell + times - 1, times));
  }
};

Ledger times_as_much(double factor, const Ledger& ledger) {
  Ledger all = ledger;
  for (double* sum : {&all.initial, &all.cell_work, &all.quenched}) *sum *= factor;
  all.last.push = factor * ledger.last.push;
  all.losses = factor * ledger.losses;
  all.last.losses = factor * ledger.last.losses;
  return all;
}

std::array<Edge, 3> edges_of(const Times& times) {
  return {{{&Fraction::x, 0, times[0]}, {&Fraction::y, 1, times[1]}, {&Fraction::z, 2, times[2]}}};
}

/// Conversion between the position of an old cell in the new one and its number.
std::size_t number_of(const Times& cell, const Times& times) {
  const auto at = [](std::int32_t n) { return static_cast<std::size_t>(n); };
  return (at(cell[2]) * at(times[1]) + at(cell[1])) * at(times[0]) + at(cell[0]);
}
Times cell_at(std::size_t number, const Times& times) {
  const auto nx = static_cast<std::size_t>(times[0]), ny = static_cast<std::size_t>(times[1]);
  const auto at = [](std::size_t n) { return static_cast<std::int32_t>(n); };
  return {at(number % nx), at(number / nx % ny), at(number / nx / ny)};
}

Cell repeated_cell(const Cell& cell, const Times& times) {
  const auto [nx, ny, nz] = std::array<double, 3>{double(times[0]), double(times[1]), double(times[2])};
  const Triangle& h = cell.edges;
  return {{h.xx * nx, h.yy * ny, h.zz * nz, h.yz * nz, h.xz * nz, h.xy * ny}, cell.rate};
}

const Times& checked(const Times& times, const Packing& packing) {
  auto particles = static_cast<double>(packing.size());
  for (const std::int32_t n : times) {
    if (n < 1) throw InputError("times = " + std::to_string(n) + " along an edge: allowed: 1 or more");
    particles *= n;
  }
  if (particles > static_cast<double>(most_particles))
    throw InputError("more particles than " + std::to_string(most_particles));
  return times;
}

/// Copies keep the types of their originals and get new ids.
Labels repeated_labels(const Labels& from, std::size_t copies) {
  Labels labels;
  labels.names = from.names;
  labels.origin = from.origin;
  for (std::size_t copy = 0; copy < copies; ++copy)
    labels.type.insert(labels.type.end(), from.type.begin(), from.type.end());
  return labels;
}

template <class T>
std::vector<T> all_of(const Computed<T>& list) {
  std::vector<T> all;
  all.reserve(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) all.push_back(list[k]);
  return all;
}

}  // namespace

template <class T>
Computed<T> Replica::repeated(const std::vector<T>& once) const {
  return {once.size() * copies_of(times_), [&once](std::size_t k) { return once[k % once.size()]; }};
}

Replica::Replica(const Packing& from, const Times& times)
    : from_(from),
      times_(checked(times, from)),
      step(from.step),
      time(from.time),
      cell(repeated_cell(from.cell, times)),
      stress{static_cast<double>(copies_of(times)) * from.stress.contacts,
             static_cast<double>(copies_of(times)) * from.stress.motion},
      ledger(times_as_much(static_cast<double>(copies_of(times)), from.ledger)),
      species(repeated(from.species)),
      radius(repeated(from.radius)),
      mass(repeated(from.mass)),
      fraction(from.size() * copies_of(times),
               [this](std::size_t k) {
                 const Times place = cell_at(k / from_.size(), times_);
                 const Fraction& s = from_.fraction[k % from_.size()];
                 Fraction divided_s{};
                 for (const Edge& e : edges_of(times_)) divided_s.*e.component = e.fraction(s, place[e.axis]);
                 return divided_s;
               }),
      image(from.size() * copies_of(times),
            [this](std::size_t k) {
              const Times place = cell_at(k / from_.size(), times_);
              Image crossed{};
              for (const Edge& e : edges_of(times_))
                crossed[e.axis] = e.image(from_.image[k % from_.size()], place[e.axis]);
              return crossed;
            }),
      velocity(repeated(from.velocity)),
      spin(repeated(from.spin)),
      force(repeated(from.force)),
      torque(repeated(from.torque)),
      contacts(from.contacts.size() * copies_of(times), [this](std::size_t k) { return moved(k); }),
      labels(repeated_labels(from.labels, copies_of(times))) {}

/// A contact of a copy, whose first particle is in the cell of the copy.
Contact Replica::moved(std::size_t k) const {
  const Times place = cell_at(k / from_.contacts.size(), times_);
  Contact c = from_.contacts[k % from_.contacts.size()];
  Times place_of_j{};
  for (const Edge& e : edges_of(times_)) {
    const std::uint64_t i = from_.fraction[c.i].*e.component;
    const std::uint64_t j = from_.fraction[c.j].*e.component;
    // The branch is (s_i - s_j + away) old edges: the image of j that is touched lies `away` cells below the
    // cell of i.
    const std::int32_t away = cells_to_nearest(i, j) + c.image[e.axis];
    const std::int32_t below = place[e.axis] - away;
    const std::int32_t new_away = -floored_quotient(below, e.times);
    place_of_j[e.axis] = below + new_away * e.times;
    const std::int32_t image_of_j = new_away - cells_to_nearest(divided({place[e.axis], i}, e.times),
                                                                divided({place_of_j[e.axis], j}, e.times));
    c.image[e.axis] = static_cast<std::int8_t>(image_of_j);
  }
  c.i = static_cast<std::uint32_t>(number_of(place, times_) * from_.size() + c.i);
  c.j = static_cast<std::uint32_t>(number_of(place_of_j, times_) * from_.size() + c.j);
  return c;
}

std::vector<std::uint32_t> Replica::memory_order() const {
  if (from_.order.empty()) return {};
  Packing places;
  places.radius = all_of(radius);
  places.fraction = all_of(fraction);
  return furnas::memory_order(places);
}

Packing replicate(const Packing& packing, const Times& times) {
  const Replica replica(packing, times);
  Packing all;
  all.step = replica.step;
  all.time = replica.time;
  all.cell = replica.cell;
  all.stress = replica.stress;
  all.ledger = replica.ledger;
  all.species = all_of(replica.species);
  all.radius = all_of(replica.radius);
  all.mass = all_of(replica.mass);
  all.fraction = all_of(replica.fraction);
  all.image = all_of(replica.image);
  all.velocity = all_of(replica.velocity);
  all.spin = all_of(replica.spin);
  all.force = all_of(replica.force);
  all.torque = all_of(replica.torque);
  all.contacts = all_of(replica.contacts);
  all.labels = replica.labels;
  if (!packing.order.empty()) all.order = memory_order(all);
  return all;
}

}  // namespace furnas
