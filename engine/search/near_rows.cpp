#include "engine/search/near_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace furnas {

void choose_near_skin(const PairList& list, double motion, double strain, NearRows& near) {
  // A list lives skin/motion steps, and needless rows grow with the skin: with near rows of skin s a step
  // costs (motion/s + s/list skin) of going through the list, the least at the geometric mean.
  constexpr double margin = 1.2;  // motion grows
  const auto between = [](double wide, double step) {
    return std::max(std::sqrt(margin * wide * step), 0.01 * wide);
  };
  near.skin = {between(list.skin.fixed, motion), between(list.skin.relative, strain)};
  const double radii = 2 * list.classes.back().smallest_radius;
  near.kept = near.skin(radii) < 0.3 * list.skin(radii);
}

std::uint64_t near_rows(const PairList& list, const NearRows& near) {
  return near.kept ? std::accumulate(near.count.begin(), near.count.end(), std::uint64_t{0}) : list.rows();
}

void weigh_near_rows(const PairList& list, NearRows& near) {
  constexpr double worth_it = 0.6;
  near.kept =
      near.kept && static_cast<double>(near_rows(list, near)) <= worth_it * static_cast<double>(list.rows());
  if (!near.kept) near.rows = {};
}

}  // namespace furnas
