#include "engine/search/inner_skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace furnas {

void choose_inner_skin(const PairList& list, double motion, double strain, InnerList& inner) {
  // An inner list of skin s lives s/motion steps, and the number of its needless rows grows with s. In units
  // of one pass through the whole list, a step costs motion/s + s/(skin of the list). The cost is least if s
  // is the geometric mean of `motion` and the skin of the list.
  constexpr double margin = 1.2;  // in case the motion becomes faster
  const auto between = [](double wide, double step) {
    return std::max(std::sqrt(margin * wide * step), 0.01 * wide);
  };
  inner.skin = {between(list.skin.fixed, motion), between(list.skin.relative, strain)};
  const double radii = 2 * list.classes.back().smallest_radius;
  inner.kept = inner.skin(radii) < 0.3 * list.skin(radii);
}

std::uint64_t inner_rows(const PairList& list, const InnerList& inner) {
  return inner.kept ? std::accumulate(inner.count.begin(), inner.count.end(), std::uint64_t{0}) : list.rows();
}

void drop_inner_list_if_needless(const PairList& list, InnerList& inner) {
  constexpr double worth_it = 0.6;
  inner.kept = inner.kept &&
               static_cast<double>(inner_rows(list, inner)) <= worth_it * static_cast<double>(list.rows());
  if (!inner.kept) inner.rows = {};
}

}  // namespace furnas
