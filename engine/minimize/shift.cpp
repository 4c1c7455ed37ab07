#include "engine/minimize/shift.h"

#include "engine/base/parallel.h"

namespace furnas {
namespace {

constexpr std::size_t shift_chunk = 1024;  // particles

Vec3<double> by_component(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace

double dot(const Shift& a, const Shift& b) {
  return contraction(a.strain, b.strain) +
         ordered_sum<double>(a.displacement.size(), shift_chunk, [&](std::size_t begin, std::size_t end) {
           double sum = 0;
           for (std::size_t k = begin; k < end; ++k) sum += dot(a.displacement[k], b.displacement[k]);
           return sum;
         });
}

void add(const Shift& a, double factor, const Shift& b, Shift& sum) {
  sum.strain = a.strain + factor * b.strain;
  for_chunks(a.displacement.size(), shift_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      sum.displacement[k] = a.displacement[k] + factor * b.displacement[k];
  });
}

double add_and_dot(Shift& to, double factor, const Shift& b, const Shift& c) {
  to.strain += factor * b.strain;
  return contraction(to.strain, c.strain) +
         ordered_sum<double>(to.displacement.size(), shift_chunk, [&](std::size_t begin, std::size_t end) {
           double sum = 0;
           for (std::size_t k = begin; k < end; ++k) {
             to.displacement[k] += factor * b.displacement[k];
             sum += dot(to.displacement[k], c.displacement[k]);
           }
           return sum;
         });
}

void multiply(const Shift& weight, const Shift& b, Shift& product) {
  const Triangle& w = weight.strain;
  const Triangle& e = b.strain;
  product.strain = {w.xx * e.xx, w.yy * e.yy, w.zz * e.zz, w.yz * e.yz, w.xz * e.xz, w.xy * e.xy};
  for_chunks(b.displacement.size(), shift_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      product.displacement[k] = by_component(weight.displacement[k], b.displacement[k]);
  });
}

}  // namespace furnas
