#include "tests/cases/arrangement.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include "engine/state/species.h"
#include "io/atomic_file.h"
#include "io/case_file.h"
#include "io/formats.h"
#include "tests/engine/support/brute_force.h"
#include "tests/io/packings.h"

namespace furnas::test {
namespace {

std::uint64_t fixed(const Coordinate& c) {
  return (static_cast<std::uint64_t>(c.quarter) << 62) + static_cast<std::uint64_t>(c.offset);
}

/// Anywhere, on a quarter of the cell, or the least step beside one.
rc::Gen<Coordinate> any_coordinate() {
  const auto near = rc::gen::oneOf(rc::gen::just(std::int64_t{0}), rc::gen::element<std::int64_t>(0, 1, -1));
  const auto far = rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int64_t>());
  return rc::gen::build<Coordinate>(
      rc::gen::set(&Coordinate::quarter, rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 4))),
      rc::gen::set(&Coordinate::offset, rc::gen::weightedOneOf<std::int64_t>({{1, near}, {3, far}})));
}

/// A number below `bound` in size that shrinks to 0.
rc::Gen<int> any_around_zero(int bound) {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 2 * bound)),
                      [](int n) { return n % 2 == 0 ? n / 2 : -(n + 1) / 2; });
}

rc::Gen<int> any_below(int bound) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, std::max(bound, 1)));
}

rc::Gen<std::array<int, 3>> three(const rc::Gen<int>& number) {
  return rc::gen::map(rc::gen::tuple(number, number, number), [](const std::tuple<int, int, int>& t) {
    return std::array<int, 3>{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
}

rc::Gen<DrawnSphere> any_sphere(const Drawing& drawing) {
  const auto growth = rc::gen::weightedOneOf<int>(
      {{3, rc::gen::just(0)}, {1, any_below(100)}, {1, any_below(drawing.largest_growth + 1)}});
  return rc::gen::build<DrawnSphere>(
      rc::gen::set(&DrawnSphere::x, any_coordinate()), rc::gen::set(&DrawnSphere::y, any_coordinate()),
      rc::gen::set(&DrawnSphere::z, any_coordinate()), rc::gen::set(&DrawnSphere::growth, growth),
      rc::gen::set(&DrawnSphere::velocity, three(any_around_zero(200))));
}

/// Whether sphere k comes too near to one before it, or shares a centre with one.
bool is_crowded(const Packing& p, std::size_t k, bool apart) {
  for (std::size_t n = 0; n < k; ++n) {
    if (p.fraction[n] == p.fraction[k]) return true;
    const Vec3<double> branch = p.cell.edges * nearest_difference(p.fraction[n], p.fraction[k]);
    if (apart && norm(branch) < 0.2 * (p.radius[n] + p.radius[k])) return true;
  }
  return false;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Arrangement& a) {
  out << a.spheres.size() << " spheres, tightness " << a.tightness << ", tilts " << a.tilts[0] << ' '
      << a.tilts[1] << ' ' << a.tilts[2] << ", skin " << a.skin << ", friction " << a.friction << ", steps "
      << a.steps;
  for (const DrawnSphere& s : a.spheres) {
    out << "\n  at";
    for (const Coordinate& c : {s.x, s.y, s.z}) out << ' ' << c.quarter << "/4 + " << c.offset << "/2^64";
    out << ", growth " << s.growth << ", velocity " << s.velocity[0] << ' ' << s.velocity[1] << ' '
        << s.velocity[2];
  }
  return out;
}

Arrangement any_arrangement(const Drawing& drawing) {
  Arrangement a;
  a.spheres =
      *rc::gen::resize(drawing.most_spheres,
                       rc::gen::nonEmpty(rc::gen::container<std::vector<DrawnSphere>>(any_sphere(drawing))));
  a.tightness = *any_below(240);
  a.tilts = *three(any_around_zero(50));
  a.skin = *any_below(50);
  a.friction = *any_below(10);
  a.steps = *any_below(drawing.most_steps);
  return a;
}

Packing packing_of(const Arrangement& a, bool apart) {
  int growth = 0;
  for (const DrawnSphere& s : a.spheres) growth = std::max(growth, s.growth);
  const double edge = (1 + growth / 100.0) * (3 - a.tightness / 100.0);
  Packing p;
  p.cell.edges = {
      edge, edge, edge, a.tilts[0] / 100.0 * edge, a.tilts[1] / 100.0 * edge, a.tilts[2] / 100.0 * edge};
  for (const DrawnSphere& s : a.spheres) {
    const std::size_t k = p.size();
    p.resize(k + 1);
    p.radius[k] = 0.5 * (1 + s.growth / 100.0);
    p.mass[k] = sphere_mass(p.radius[k]);
    p.fraction[k] = {fixed(s.x), fixed(s.y), fixed(s.z)};
    p.velocity[k] = 1e-3 * Vec3<double>{double(s.velocity[0]), double(s.velocity[1]), double(s.velocity[2])};
    if (is_crowded(p, k, apart)) p.resize(k);
  }
  p.species = species_by_size(p.radius);
  return p;
}

Case case_of(const Arrangement& a, const std::string& file) {
  Case c;
  c.start.file = file;
  c.contact.friction = a.friction / 10.0;
  c.compaction.cell = "fixed";
  c.compute.skin = a.skin / 100.0;
  c.compute.threads = 1;
  c.compute.precision = "double";
  c.stop.steps = std::max(a.steps, 1);
  c.output.picture = "none";
  return c;
}

::testing::AssertionResult holds_for_arrangements(int cases, const Drawing& drawing,
                                                  const std::string& folder,
                                                  const std::function<void(const Arrangement&)>& property) {
  // RapidCheck goes on to a simpler case only if that fails too: the last failure is the simplest.
  std::optional<Arrangement> simplest;
  const ::testing::AssertionResult result = holds(cases, [&] {
    const Arrangement a = any_arrangement(drawing);
    try {
      property(a);
    } catch (const rc::detail::CaseResult& outcome) {
      if (outcome.type == rc::detail::CaseResult::Type::Failure) simplest = a;
      throw;
    } catch (...) {
      simplest = a;
      throw;
    }
  });
  if (result || !simplest) return result;
  std::filesystem::create_directories(folder);
  const std::string start = folder + "/start.extxyz";
  const std::string path = folder + "/case.toml";
  write_packing(packing_of(*simplest, drawing.apart), "extxyz", start);
  write_file(path, resolved_toml(case_of(*simplest, start)));
  return ::testing::AssertionFailure() << result.message() << "\nThe simplest case that fails: " << *simplest
                                       << "\n\n  furnas run " << path << "\n\nstart.extxyz:\n"
                                       << content(start);
}

std::string folder_of_failure() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return (std::filesystem::temp_directory_path() /
          ("furnas_failure_" + std::string(test->test_suite_name()) + "_" + test->name()))
      .string();
}

}  // namespace furnas::test
