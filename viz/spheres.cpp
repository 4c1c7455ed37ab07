#include "viz/spheres.h"

namespace furnas {

std::vector<Sphere> spheres_of(const Packing& packing, const std::vector<Rgb>& colours,
                               const std::array<int, 3>& times, const std::optional<Slice>& slice) {
  std::vector<Sphere> spheres;
  if (!slice)
    spheres.reserve(packing.size() * std::size_t(times[0]) * std::size_t(times[1]) * std::size_t(times[2]));
  for (int a = 0; a < times[0]; ++a)
    for (int b = 0; b < times[1]; ++b)
      for (int c = 0; c < times[2]; ++c)
        for (std::size_t k = 0; k < packing.size(); ++k) {
          Vec3<double> s = in_unit_cell(packing.fraction[k]);
          s += {double(a), double(b), double(c)};
          if (slice) {
            const double along = (slice->axis == 0 ? s.x : slice->axis == 1 ? s.y : s.z) / times[slice->axis];
            if (along < slice->from || along >= slice->upto) continue;
          }
          const Vec3<double> x = packing.cell.edges * s;
          spheres.push_back(
              {{float(x.x), float(x.y), float(x.z)}, static_cast<float>(packing.radius[k]), colours[k]});
        }
  return spheres;
}

}  // namespace furnas
