#include "engine/search/merge.h"

#include <cmath>
#include <utility>

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

template <class Real>
void merge_contact_state(const PairList& old, ContactState<Real>& contact_state, const PairList& fresh,
                         const std::vector<Fraction>& positions, bool friction) {
  const ContactState<Real> before = std::exchange(contact_state, {});
  contact_state.clear(fresh.rows(), positions.size(), friction);
  for_chunks(old.first.empty() ? 0 : positions.size(), 1024,
             [&](std::size_t begin, std::size_t end, std::size_t) {
               for (std::size_t i = begin; i < end; ++i) {
                 std::uint64_t k = fresh.first[i];
                 for (std::uint64_t o = old.first[i]; o < old.first[i + 1]; ++o) {
                   if (before.touching[o] == 0) continue;
                   const std::uint32_t j = old.partner[o];
                   const auto image = image_of_row(old, o, positions[i], positions[j]);
                   while (k < fresh.first[i + 1] && fresh.partner[k] < j) ++k;
                   for (std::uint64_t n = k; n < fresh.first[i + 1] && fresh.partner[n] == j; ++n)
                     if (image_of_row(fresh, n, positions[i], positions[j]) == image) {
                       contact_state.touch(n, static_cast<std::uint32_t>(i), j);
                       if (friction) contact_state.springs[n] = before.springs[o];
                     }
                 }
               }
             });
}

template void merge_contact_state<double>(const PairList&, ContactState<double>&, const PairList&,
                                          const std::vector<Fraction>&, bool);
template void merge_contact_state<float>(const PairList&, ContactState<float>&, const PairList&,
                                         const std::vector<Fraction>&, bool);

}  // namespace furnas
