#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/formats.h"
#include "tests/cases/arrangement.h"
#include "tests/cases/runs.h"
#include "tests/engine/support/brute_force_comparison.h"

namespace furnas {
namespace {

using test::Arrangement;
using test::Drawing;

/// A matrix of whole numbers with the determinant 1: other edges of the same lattice.
using Integers = Eigen::Matrix<std::int64_t, 3, 3>;

/// A product of simple ones: edge `to` gains `times` times edge `from`, or the edges are renamed in a circle.
/// No factors, the simplest, change nothing.
Integers any_relabelling() {
  struct Factor {
    int kind{}, times{};
  };
  const auto factor = rc::gen::build<Factor>(
      rc::gen::set(&Factor::kind, rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 7))),
      rc::gen::set(&Factor::times, rc::gen::element(1, -1, 2, -2)));
  Integers m = Integers::Identity();
  for (const Factor& f : *rc::gen::resize(4, rc::gen::container<std::vector<Factor>>(factor))) {
    Integers step = Integers::Identity();
    if (f.kind == 6)
      step << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    else
      step(f.kind / 2, (f.kind / 2 + 1 + f.kind % 2) % 3) = f.times;
    m = m * step;
  }
  return m;
}

/// The packing described by the edges h M, and turned so that they are triangular again.
struct Relabelled {
  Packing packing;
  Eigen::Matrix3d turn;  ///< of the old axes into the new ones
};

Vec3<double> times(const Eigen::Matrix3d& m, const Vec3<double>& v) {
  const Eigen::Vector3d w = m * Eigen::Vector3d(v.x, v.y, v.z);
  return {w.x(), w.y(), w.z()};
}

Relabelled relabelled(const Packing& p, const Integers& m) {
  using Long = Eigen::Matrix<long double, 3, 3>;
  const Triangle& h = p.cell.edges;
  Long edges;
  edges << h.xx, h.xy, h.xz, 0, h.yy, h.yz, 0, 0, h.zz;
  edges = edges * m.cast<long double>();
  const Eigen::HouseholderQR<Long> qr(edges);
  Long r = qr.matrixQR().triangularView<Eigen::Upper>();
  Long q = qr.householderQ();
  for (int k = 0; k < 3; ++k)
    if (r(k, k) < 0) r.row(k) *= -1, q.col(k) *= -1;

  Relabelled out{p, q.transpose().cast<double>()};
  out.packing.cell.edges = {double(r(0, 0)), double(r(1, 1)), double(r(2, 2)),
                            double(r(1, 2)), double(r(0, 2)), double(r(0, 1))};
  // The inverse of a matrix of determinant 1 is that of its cofactors; fractions wrap as integers do.
  Integers back;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      back(j, i) = m((i + 1) % 3, (j + 1) % 3) * m((i + 2) % 3, (j + 2) % 3) -
                   m((i + 1) % 3, (j + 2) % 3) * m((i + 2) % 3, (j + 1) % 3);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::uint64_t s[] = {p.fraction[k].x, p.fraction[k].y, p.fraction[k].z};
    std::uint64_t t[3] = {};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) t[i] += static_cast<std::uint64_t>(back(i, j)) * s[j];
    out.packing.fraction[k] = {t[0], t[1], t[2]};
    out.packing.image[k] = {};
    for (auto vectors : {&Packing::velocity, &Packing::spin, &Packing::force, &Packing::torque})
      (out.packing.*vectors)[k] = times(out.turn, (p.*vectors)[k]);
  }
  for (Contact& c : out.packing.contacts) {
    Vec3<double> s = nearest_difference(p.fraction[c.i], p.fraction[c.j]);
    s += {double(c.image[0]), double(c.image[1]), double(c.image[2])};
    const Vec3<double> cells = times(back.cast<double>(), s) -
                               nearest_difference(out.packing.fraction[c.i], out.packing.fraction[c.j]);
    const auto whole = [](double x) { return static_cast<std::int8_t>(std::lround(x)); };
    c.image = {whole(cells.x), whole(cells.y), whole(cells.z)};
    for (auto vector : {&Contact::branch, &Contact::force, &Contact::history})
      c.*vector = times(out.turn, c.*vector);
  }
  for (Eigen::Matrix3d* part : {&out.packing.stress.contacts, &out.packing.stress.motion})
    *part = (out.turn * *part * out.turn.transpose()).eval();
  return out;
}

bool close(const Vec3<double>& a, const Vec3<double>& b, double tolerance) {
  return norm(a - b) <= tolerance;
}

/// The contact of `p` that is the given one, seen from either side.
const Contact* twin_of(const Contact& wanted, const Packing& p, double tolerance) {
  for (const Contact& c : p.contacts)
    if ((c.i == wanted.i && c.j == wanted.j && close(c.branch, wanted.branch, tolerance)) ||
        (c.i == wanted.j && c.j == wanted.i && close(-c.branch, wanted.branch, tolerance)))
      return &c;
  return nullptr;
}

/// Whether both are the same packing but for rounding, which grows with the longest edge.
void expect_same_physics(const Packing& a, const Relabelled& other, double tolerance) {
  const Packing& b = other.packing;
  for (const Contact& c : a.contacts) {
    Contact seen = c;
    for (auto vector : {&Contact::branch, &Contact::force, &Contact::history})
      seen.*vector = times(other.turn, c.*vector);
    const Contact* twin = twin_of(seen, b, tolerance);
    if (!twin) {
      RC_ASSERT(c.overlap <= tolerance);  // touches by rounding alone
      continue;
    }
    const double sign = close(twin->branch, seen.branch, tolerance) ? 1 : -1;
    RC_ASSERT(std::abs(twin->overlap - c.overlap) <= tolerance);
    RC_ASSERT(close(sign * twin->force, seen.force, tolerance));
    RC_ASSERT(close(sign * twin->history, seen.history, tolerance));
  }
  const auto certain = [&](const Packing& p) {
    return std::count_if(p.contacts.begin(), p.contacts.end(),
                         [&](const Contact& c) { return c.overlap > 2 * tolerance; });
  };
  RC_ASSERT(certain(b) <= std::ptrdiff_t(a.contacts.size()));
  RC_ASSERT(certain(a) <= std::ptrdiff_t(b.contacts.size()));
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double size = (1 + norm(a.force[k])) * tolerance;
    RC_ASSERT(close(times(other.turn, a.velocity[k]), b.velocity[k], size / a.mass[k]));
    RC_ASSERT(close(times(other.turn, a.force[k]), b.force[k], size));
    RC_ASSERT(close(times(other.turn, a.torque[k]), b.torque[k], a.radius[k] * size));
  }
  const Eigen::Matrix3d stress = other.turn * a.stress.contacts * other.turn.transpose();
  RC_ASSERT((stress - b.stress.contacts).norm() <= tolerance * (1 + stress.norm()));
}

Packing after(const Model& model, const Packing& start, std::int64_t steps) {
  const auto simulation = make_simulation(model, start);
  simulation->advance(steps);
  return simulation->packing();
}

// Guards the properties: what is drawn has contacts through faces, with own images, of very different
// spheres, with histories, in tilted and tight cells, and relabellings that change something.
TEST(Property, WhatIsDrawnIsVaried) {
  int through = 0;
  int own = 0;
  int uneven = 0;
  int old = 0;
  int tilted = 0;
  int renamed = 0;
  EXPECT_TRUE(test::holds(600, [&] {
    const Arrangement a = test::any_arrangement({.most_steps = 4});
    const Packing start = packing_of(a, true);
    const auto any = [&](auto&& is) {
      const Packing p = after(model_of(case_of(a, ""), start), start, a.steps);
      return std::any_of(p.contacts.begin(), p.contacts.end(), is);
    };
    through += any([](const Contact& c) { return c.image != decltype(c.image){}; });
    own += any([](const Contact& c) { return c.i == c.j; });
    uneven += any([&](const Contact& c) { return start.radius[c.j] > 10 * start.radius[c.i]; });
    old += any([](const Contact& c) { return norm(c.history) > 1e-4; });
    tilted += std::abs(a.tilts[0]) > 25;
    renamed += any_relabelling() != Integers::Identity();
  }));
  EXPECT_THAT((std::vector{through, own, uneven, old, tilted, renamed}), testing::Each(testing::Gt(60)));
}

// T23 and T35 in one: any spheres in any cell, on its faces, edges and corners, to a size ratio of 40.
TEST(Property, ContactsAndForcesAreThoseOfBruteForce) {
  const Drawing drawing{};
  EXPECT_TRUE(
      test::holds_for_arrangements(3000, drawing, test::folder_of_failure(), [&](const Arrangement& a) {
        const Packing start = packing_of(a, drawing.apart);
        test::compare_with_brute_force(model_of(case_of(a, ""), start), start);
      }));
}

// T27 for every M of SL(3, Z): contacts, forces, stress and history of a packing with a past stay the same,
// and so does its next step. Cells that become thinner than a fifth of a sphere are left out: the engine
// refuses those that are thinner than a thirtieth, and rounding grows with the length of the edges.
TEST(Property, OtherEdgesOfTheLatticeChangeNothing) {
  const Drawing drawing{.most_spheres = 8, .largest_growth = 400, .most_steps = 4, .apart = true};
  EXPECT_TRUE(
      test::holds_for_arrangements(3000, drawing, test::folder_of_failure(), [&](const Arrangement& a) {
        const Integers m = any_relabelling();
        const Packing start = packing_of(a, drawing.apart);
        const Model model = model_of(case_of(a, ""), start);
        const Packing now = after(model, start, a.steps);
        const Relabelled other = relabelled(now, m);
        const Triangle& h = other.packing.cell.edges;
        const Vec3<double> high = heights(h);
        const double largest = 2 * *std::max_element(now.radius.begin(), now.radius.end());
        RC_PRE(std::min({high.x, high.y, high.z}) > 0.2 * largest);
        const double tolerance =
            1e-13 * (h.xx + h.yy + h.zz + std::abs(h.xy) + std::abs(h.xz) + std::abs(h.yz));
        expect_same_physics(now, {after(model, other.packing, 0), other.turn}, tolerance);
        expect_same_physics(after(model, now, 1), {after(model, other.packing, 1), other.turn},
                            10 * tolerance);
      }));
}

/// Whether a large sphere touches a small one, whose diameter is the unit of length.
bool is_of_both(const Packing& p, const Contact& c) {
  return (p.radius[c.i] < 1) != (p.radius[c.j] < 1) && std::max(p.radius[c.i], p.radius[c.j]) >= 1.5;
}

/// A property that a large sphere in contact with a small one breaks, in a folder of the test's own.
::testing::AssertionResult claim_that_nothing_large_touches(const std::string& folder) {
  const Drawing drawing{.most_steps = 3};
  return test::holds_for_arrangements(300, drawing, folder, [&](const Arrangement& a) {
    const Packing start = packing_of(a, drawing.apart);
    for (const Contact& c : after(model_of(case_of(a, ""), start), start, 0).contacts)
      RC_ASSERT(!is_of_both(start, c));
  });
}

// What a failure leaves behind is as simple as it can be, and the program runs it.
TEST(Property, AFailureShrinksToACaseThatRuns) {
  const TemporaryFolder folder;
  const std::string path = (folder / "failure").string();
  const auto result = claim_that_nothing_large_touches(path);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.message(), testing::HasSubstr("furnas run " + path + "/case.toml"));
  EXPECT_THAT(result.message(),
              testing::HasSubstr("2 spheres, tightness 0, tilts 0 0 0, skin 0, friction 0, steps 0"));
  EXPECT_THAT(result.message(), testing::HasSubstr("growth 200, velocity 0 0 0"));

  const Case c = read_case(path + "/case.toml");
  const Packing start = start_of(c);
  ASSERT_EQ(start.size(), 2u);
  const Packing p = after(model_of(c, start), start, 0);
  EXPECT_TRUE(std::any_of(p.contacts.begin(), p.contacts.end(), [&](const Contact& t) {
    return is_of_both(start, t);
  })) << "the case does not fail any more";
  const Answer answer = furnas({"run", path + "/case.toml", "--out", (folder / "run").string()});
  EXPECT_THAT(answer.out, testing::HasSubstr("verdict")) << answer.err;
}

// The file holds the failing packing to the last digits of a position.
TEST(Property, TheFileOfAFailureIsThePacking) {
  const TemporaryFolder folder;
  const std::string path = (folder / "start.extxyz").string();
  EXPECT_TRUE(test::holds(100, [&] {
    const Arrangement a = test::any_arrangement({});
    const Packing p = packing_of(a, false);
    write_packing(p, "extxyz", path);
    const Case c = parse_case(resolved_toml(case_of(a, path)), "case");
    RC_ASSERT(c == case_of(a, path));
    const Packing q = read_packing(path);
    RC_ASSERT(q.radius == p.radius);
    RC_ASSERT(q.mass == p.mass);
    RC_ASSERT(q.velocity == p.velocity);
    RC_ASSERT(q.species == p.species);
    RC_ASSERT(q.cell == p.cell);
    for (std::size_t k = 0; k < p.size(); ++k) RC_ASSERT(distance(p, q, k) < 1e-15 * p.cell.edges.xx * 3);
  }));
}

}  // namespace
}  // namespace furnas
