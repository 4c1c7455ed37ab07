#include "tests/engine/support/symmetries.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/require.h"
#include "engine/search/size_classes.h"

namespace furnas::test {
namespace {

using Cells = std::array<std::int8_t, 3>;

/// A vector of whole numbers of cells, found as a sum of rounded terms.
Cells whole(const Vec3<double>& cells) {
  const auto component = [](double x) { return static_cast<std::int8_t>(std::lround(x)); };
  return {component(cells.x), component(cells.y), component(cells.z)};
}

/// s_i - s_j of the image that a contact means.
Vec3<double> difference(const Packing& p, const Contact& c) {
  return nearest_difference(p.fraction[c.i], p.fraction[c.j]) +
         Vec3<double>{double(c.image[0]), double(c.image[1]), double(c.image[2])};
}

/// Makes particle n of p what particle k of another packing is.
void put(Packing& p, std::size_t n, const Packing& packing, std::size_t k) {
  p.species[n] = packing.species[k];
  p.radius[n] = packing.radius[k];
  p.mass[n] = packing.mass[k];
  p.fraction[n] = packing.fraction[k];
  p.image[n] = packing.image[k];
  p.velocity[n] = packing.velocity[k];
  p.spin[n] = packing.spin[k];
  p.force[n] = packing.force[k];
  p.torque[n] = packing.torque[k];
}

Eigen::Matrix3d dense(const Triangle& h) {
  return Eigen::Matrix3d{{h.xx, h.xy, h.xz}, {0, h.yy, h.yz}, {0, 0, h.zz}};
}

}  // namespace

Vec3<double> operator*(const Eigen::Matrix3d& matrix, const Vec3<double>& v) {
  const Eigen::Vector3d product = matrix * Eigen::Vector3d(v.x, v.y, v.z);
  return {product.x(), product.y(), product.z()};
}

Packing turned(const Packing& packing, const Eigen::Matrix3d& turn) {
  Packing p = packing;
  const Eigen::Matrix3d axial = turn.determinant() * turn;
  for (Vec3<double>& v : p.velocity) v = turn * v;
  for (Vec3<double>& v : p.force) v = turn * v;
  for (Vec3<double>& v : p.spin) v = axial * v;
  for (Vec3<double>& v : p.torque) v = axial * v;
  for (Contact& c : p.contacts) {
    c.branch = turn * c.branch;
    c.force = turn * c.force;
    c.history = turn * c.history;
  }
  p.stress.contacts = turn * p.stress.contacts * turn.transpose();
  p.stress.motion = turn * p.stress.motion * turn.transpose();
  return p;
}

void number_places_by(Packing& p, const Eigen::Matrix3i& m) {
  require(std::abs(m.determinant()) == 1, "other edges of the same lattice");
  const Eigen::Matrix3i inverse = m.cast<double>().inverse().array().round().matrix().cast<int>();
  std::vector<Vec3<double>> differences;
  for (const Contact& c : p.contacts) differences.push_back(inverse.cast<double>() * difference(p, c));
  for (Fraction& s : p.fraction) {
    const auto component = [&](int row) {  // wraps as the cell does
      const auto times = [&](int column, std::uint64_t x) {
        return static_cast<std::uint64_t>(std::int64_t{inverse(row, column)}) * x;
      };
      return times(0, s.x) + times(1, s.y) + times(2, s.z);
    };
    s = {component(0), component(1), component(2)};
  }
  for (std::size_t n = 0; n < p.contacts.size(); ++n) {
    Contact& c = p.contacts[n];
    c.image = whole(differences[n] - nearest_difference(p.fraction[c.i], p.fraction[c.j]));
  }
  p.image.assign(p.size(), {});
}

Redescribed with_edges(const Packing& packing, const Eigen::Matrix3i& m) {
  require(packing.cell.rate == Triangle{}, "a cell at rest");
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(dense(packing.cell.edges) * m.cast<double>());
  Eigen::Matrix3d edges = qr.matrixQR().triangularView<Eigen::Upper>();
  Eigen::Matrix3d turn = Eigen::Matrix3d(qr.householderQ()).transpose();
  for (int k = 0; k < 3; ++k)
    if (edges(k, k) < 0) {
      edges.row(k) *= -1;
      turn.row(k) *= -1;
    }
  Packing p = turned(packing, turn);
  number_places_by(p, m);
  p.cell.edges = {edges(0, 0), edges(1, 1), edges(2, 2), edges(1, 2), edges(0, 2), edges(0, 1)};
  return {p, turn};
}

std::vector<Eigen::Matrix3i> signed_permutations() {
  std::vector<Eigen::Matrix3i> all;
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3i m = Eigen::Matrix3i::Zero();
      for (int k = 0; k < 3; ++k) m(axis[static_cast<std::size_t>(k)], k) = (signs >> k & 1) != 0 ? -1 : 1;
      all.push_back(m);
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

Packing renumbered(const Packing& packing, const std::vector<std::uint32_t>& number) {
  Packing p = packing;
  for (std::size_t k = 0; k < p.size(); ++k) put(p, number[k], packing, k);
  for (Contact& c : p.contacts) c.i = number[c.i], c.j = number[c.j];
  for (std::uint32_t& k : p.order) k = number[k];
  return p;
}

Packing in_units(const Packing& packing, const Units& units) {
  const auto power = [](int n) { return std::ldexp(1.0, n); };
  const double length = power(units.length);
  const double mass = power(units.mass);
  const double rate = power(-units.mass / 2);
  const double work = length * length;  // k_n = 1: forces scale as lengths
  Packing p = packing;
  p.time /= rate;
  const auto scale = [](Triangle& t, double by) {
    t = {t.xx * by, t.yy * by, t.zz * by, t.yz * by, t.xz * by, t.xy * by};
  };
  scale(p.cell.edges, length);
  scale(p.cell.rate, rate);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.radius[k] *= length;
    p.mass[k] *= mass;
    p.velocity[k] *= length * rate;
    p.spin[k] *= rate;
    p.force[k] *= length;
    p.torque[k] *= work;
  }
  for (Contact& c : p.contacts) {
    c.branch *= length;
    c.overlap *= length;
    c.force *= length;
    c.history *= length;
  }
  p.stress.contacts *= work;
  p.stress.motion *= work;
  return p;
}

Model in_units(const Model& model, const Units& units) {
  const double length = std::ldexp(1.0, units.length);
  const double mass = std::ldexp(1.0, units.mass);
  const double rate = std::ldexp(1.0, -units.mass / 2);
  Model m = model;
  m.time_step /= rate;
  std::visit(
      [&](auto& law) {
        law.constants.normal_damping *= rate;
        law.constants.tangential_damping *= rate;
      },
      m.law);
  m.barostat.pressure /= length;
  m.barostat.inertia *= mass * length * length;
  m.barostat.drag *= rate;
  if (m.skin) *m.skin *= length;
  return m;
}

Packing doubled(const Packing& packing) {
  constexpr std::uint32_t copies = 8;
  Packing p;
  p.step = packing.step;
  p.cell = packing.cell;
  p.cell.edges = product(packing.cell.edges, {2, 2, 2, 0, 0, 0});
  p.stress.contacts = copies * packing.stress.contacts;
  p.stress.motion = copies * packing.stress.motion;
  p.resize(copies * packing.size());
  for (std::size_t n = 0; n < p.size(); ++n) {
    const std::size_t k = n / copies;
    put(p, n, packing, k);
    p.image[n] = {};
    const Fraction& s = packing.fraction[k];
    require(((s.x | s.y | s.z) & 1) == 0, "places that can be halved");
    const auto half = [&](std::uint64_t x, int axis) { return x / 2 + (std::uint64_t{n >> axis & 1} << 63); };
    p.fraction[n] = {half(s.x, 0), half(s.y, 1), half(s.z, 2)};
  }
  for (const Contact& c : packing.contacts) {
    const Vec3<double> d = difference(packing, c);
    // i of the cell c_i touches j of the cell c_i - cells.
    const Cells cells =
        whole(d - (in_unit_cell(packing.fraction[c.i]) - in_unit_cell(packing.fraction[c.j])));
    for (std::uint32_t copy = 0; copy < copies; ++copy) {
      Contact twin = c;
      twin.i = copies * c.i + copy;
      twin.j = copies * c.j;
      for (std::uint32_t axis = 0; axis < 3; ++axis)
        twin.j += ((copy >> axis ^ static_cast<std::uint32_t>(cells[axis])) & 1) << axis;
      twin.image = whole(0.5 * d - nearest_difference(p.fraction[twin.i], p.fraction[twin.j]));
      p.contacts.push_back(twin);
    }
  }
  p.order = memory_order(p);
  return p;
}

Packing reversed(const Packing& packing) {
  Packing p = packing;
  for (Vec3<double>& v : p.velocity) v = -v;
  for (Vec3<double>& v : p.spin) v = -v;
  return p;
}

void expect_same_contacts(const Packing& p, const Packing& q, double tolerance, const Eigen::Matrix3d& turn) {
  ASSERT_EQ(p.contacts.size(), q.contacts.size());
  for (const Contact& c : p.contacts) {
    double sign = 1;
    const auto twin = std::find_if(q.contacts.begin(), q.contacts.end(), [&](const Contact& d) {
      const bool same = c.i == d.i && c.j == d.j && norm(turn * c.branch - d.branch) < 1e-6;
      const bool opposite = c.i == d.j && c.j == d.i && norm(turn * c.branch + d.branch) < 1e-6;
      sign = same ? 1 : -1;
      return same || opposite;
    });
    ASSERT_NE(twin, q.contacts.end()) << c.i << " and " << c.j;
    EXPECT_LT(norm(turn * c.branch - sign * twin->branch), 10 * tolerance);
    EXPECT_LT(norm(turn * c.force - sign * twin->force), tolerance);
    EXPECT_LT(norm(turn * c.history - sign * twin->history), tolerance);
  }
}

}  // namespace furnas::test
