#include "engine/search/inner_skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace furnas {

void choose_inner_skin(const PairList& list, double motion, double strain, InnerList& inner) {
  // A list lives skin/motion steps, and needless rows grow with the skin: with inner list of skin s a step
  // costs (motion/s + s/list skin) of going through the list, the least at the geometric mean.
  constexpr double margin = 1.2;  // motion grows
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
