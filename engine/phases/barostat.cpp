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

  // With an upper-triangular rate x moves in proportion to y, so branch_y force_x does work.
  const auto shear = [&](int a, int b) { return barostat.legacy ? p(a, b) : p(b, a); };
  e.yz = (e.yz + kick * shear(1, 2)) * decay;
  e.xz = (e.xz + kick * shear(0, 2)) * decay;
  e.xy = (e.xy + kick * shear(0, 1)) * decay;
}

namespace {

/// exp(e t) h by its power series, in Horner's form. |e t| is far below 1, so 8 terms are exact to rounding.
Triangle stretched(const Triangle& h, const Triangle& e, double t) {
  Triangle sum = h;
  for (int term = 8; term > 0; --term) {
    sum = h + (t / term) * product(e, sum);
  }
  return sum;
}

/// The same to first order in the shear, split as in LAMMPS: tilts over half the time, then lengths, then
/// tilts over half the time with the old lengths.
Triangle stretched_as_lammps(const Triangle& h, const Triangle& e, double t) {
  const auto grow = [](double& tilt, double rate, double push, double time) {
    const double factor = std::exp(0.5 * time * rate);
    tilt = (tilt * factor + time * push) * factor;
  };
  Triangle out = h;
  const auto tilts = [&] {
    grow(out.xz, e.xx, e.xy * out.yz + e.xz * h.zz, 0.25 * t);
    grow(out.yz, e.yy, e.yz * h.zz, 0.5 * t);
    grow(out.xy, e.xx, e.xy * h.yy, 0.5 * t);
    grow(out.xz, e.xx, e.xy * out.yz + e.xz * h.zz, 0.25 * t);
  };
  tilts();
  tilts();
  out.xx = h.xx * std::exp(t * e.xx);
  out.yy = h.yy * std::exp(t * e.yy);
  out.zz = h.zz * std::exp(t * e.zz);
  return out;
}

}  // namespace

void stretch_cell(const Barostat& barostat, const double& time_step, Cell& cell) {
  cell.edges = (barostat.legacy ? stretched_as_lammps : stretched)(cell.edges, cell.rate, 0.5 * time_step);
}

}  // namespace furnas
