#include "engine/phases/barostat.h"

#include <cmath>

namespace furnas {

void kick_cell(const Barostat& barostat, const double& time_step, const std::size_t& particles,
               const Stress& stress, Cell& cell) {
  const Eigen::Matrix3d p = stress.total();
  const double outside = barostat.pressure * cell.volume();
  const double kinetic = stress.motion.trace() / (3 * static_cast<double>(particles));
  const double kick = 0.5 * time_step / barostat.inertia;
  const double decay = std::exp(-0.5 * time_step * barostat.drag);

  Eigen::Vector3d push = p.diagonal().array() - outside + kinetic;
  if (barostat.freedom == CellFreedom::cubic) push.setConstant(push.mean());
  Triangle& e = cell.rate;
  e.xx = (e.xx + kick * push.x()) * decay;
  e.yy = (e.yy + kick * push.y()) * decay;
  e.zz = (e.zz + kick * push.z()) * decay;
  if (barostat.freedom != CellFreedom::triclinic) return;

  // An upper-triangular rate moves x with y, so branch_y force_x is what does work.
  const auto shear = [&](int a, int b) { return barostat.legacy_shear ? p(a, b) : p(b, a); };
  e.yz = (e.yz + kick * shear(1, 2)) * decay;
  e.xz = (e.xz + kick * shear(0, 2)) * decay;
  e.xy = (e.xy + kick * shear(0, 1)) * decay;
}

void stretch_cell(const double& time_step, Cell& cell) {
  const double t = 0.5 * time_step;
  const Triangle& e = cell.rate;
  // exp(e t) h by its series, Horner's way; |e t| is far below 1, so 8 terms are exact to rounding.
  Triangle sum = cell.edges;
  for (int term = 8; term > 0; --term) {
    const Triangle next = product(e, sum);
    const double weight = t / term;
    sum = {cell.edges.xx + weight * next.xx, cell.edges.yy + weight * next.yy,
           cell.edges.zz + weight * next.zz, cell.edges.yz + weight * next.yz,
           cell.edges.xz + weight * next.xz, cell.edges.xy + weight * next.xy};
  }
  cell.edges = sum;
}

}  // namespace furnas
