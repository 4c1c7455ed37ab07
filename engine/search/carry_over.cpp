#include "engine/search/carry_over.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"

namespace furnas {

std::array<std::int8_t, 3> image_of_row(const PairList& list, std::uint64_t k, const Fraction& i,
                                        const Fraction& j) {
  if (list.quarter.empty()) return {};
  const Vec3<double> cells = row_difference(i, j, list.quarter[k]) - nearest_difference(i, j);
  const auto whole = [](double x) { return static_cast<std::int8_t>(std::nearbyint(x)); };
  return {whole(cells.x), whole(cells.y), whole(cells.z)};
}

std::array<std::int8_t, 3> image_seen_from_j(const std::array<std::int8_t, 3>& image, const Fraction& i,
                                             const Fraction& j) {
  // In 64 bits the difference of half a cell, -1/2, is its own negative. Seen from i and from j the nearest
  // image is then at -1/2, so the number of cells changes by 1.
  const auto component = [](std::int8_t cells, std::uint64_t difference) {
    const bool half = difference == std::uint64_t{1} << 63;
    return static_cast<std::int8_t>((half ? 1 : 0) - cells);
  };
  return {component(image[0], i.x - j.x), component(image[1], i.y - j.y), component(image[2], i.z - j.z)};
}

namespace {
constexpr std::size_t chunk = 1024;  // particles
}

template <class Real>
CarriedContacts<Real> contacts_of_rows(const PairList& list, const ContactState<Real>& contact_state,
                                       const std::vector<Fraction>& positions) {
  const std::size_t particles = list.first.empty() ? 0 : positions.size();
  const std::vector<std::uint8_t>& touching = contact_state.touching;
  CarriedContacts<Real> carried((particles + chunk - 1) / chunk);
  for_chunks(particles, chunk, [&](std::size_t begin, std::size_t end, std::size_t piece) {
    const auto flag = [&](std::size_t i) { return touching.begin() + std::ptrdiff_t{list.first[i]}; };
    carried[piece].reserve(static_cast<std::size_t>(std::count(flag(begin), flag(end), 1)));
    for (std::size_t i = begin; i < end; ++i)
      for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
        if (touching[k] == 0) continue;
        const std::uint32_t j = list.partner[k];
        carried[piece].push_back(
            {static_cast<std::uint32_t>(i), j, image_of_row(list, k, positions[i], positions[j]),
             contact_state.springs.empty() ? Vec3<Real>{} : contact_state.springs[k].history});
      }
  });
  return carried;
}

template <class Real>
void enter_contacts(const CarriedContacts<Real>& carried, const PairList& list,
                    const std::vector<Fraction>& positions, bool friction,
                    ContactState<Real>& contact_state) {
  contact_state.clear(list.rows(), positions.size(), friction);
  for_chunks(carried.size(), 1, [&](std::size_t piece, std::size_t, std::size_t) {
    std::uint64_t row = 0;
    for (const CarriedContact<Real>& c : carried[piece]) {
      row = std::max<std::uint64_t>(row, list.first[c.i]);
      const std::uint64_t end = list.first[c.i + 1];
      while (row < end && list.partner[row] < c.j) ++row;
      for (std::uint64_t k = row; k < end && list.partner[k] == c.j; ++k)
        if (image_of_row(list, k, positions[c.i], positions[c.j]) == c.image) {
          contact_state.touch(k, c.i, c.j);
          if (friction) contact_state.springs[k].history = c.history;
        }
    }
  });
}

#define FURNAS_INSTANTIATE(Real)                                                                    \
  template CarriedContacts<Real> contacts_of_rows<Real>(const PairList&, const ContactState<Real>&, \
                                                        const std::vector<Fraction>&);              \
  template void enter_contacts<Real>(const CarriedContacts<Real>&, const PairList&,                 \
                                     const std::vector<Fraction>&, bool, ContactState<Real>&);
FURNAS_INSTANTIATE(double)
FURNAS_INSTANTIATE(float)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
