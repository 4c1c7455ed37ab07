#include "io/extended_xyz.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

const std::string valid_xyz =
    "2\n"
    "flag Lattice=\"4 0 0 1 4 0 0.5 -0.5 4\" Origin=\"1 1 1\" pbc=\"T T T\" Time=2 "
    "Properties=species:S:1:pos:R:3:radius:R:1:note:I:2\n"
    "a 2 2 2 1.5 0 0\n"
    "b 1 1 1 0.5 7 8\n";

TEST(ExtendedXyz, RoundTripIsExactToRounding) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Packing p = random_packing(seed);
    write_extended_xyz(p, folder / "a.extxyz");
    const Packing q = read_extended_xyz(folder / "a.extxyz");
    expect_same_packing(p, q);
    EXPECT_EQ(p.cell.edges, q.cell.edges);
    EXPECT_EQ(p.mass, q.mass);
    EXPECT_EQ(p.force, q.force);
    EXPECT_EQ(p.torque, q.torque);
    EXPECT_EQ(p.step, q.step);
    EXPECT_EQ(p.time, q.time);
  }
}

TEST(ExtendedXyz, ReadsFilesOfOthers) {
  const TemporaryFolder folder;
  write_file(folder / "a.xyz", valid_xyz);
  const Packing p = read_extended_xyz(folder / "a.xyz");
  EXPECT_EQ(p.cell.edges, (Triangle{.xx = 4, .yy = 4, .zz = 4, .yz = -0.5, .xz = 0.5, .xy = 1}));
  EXPECT_EQ(p.species, (std::vector{Species::large, Species::small}));
  EXPECT_LT(norm(p.position(0) - Vec3<double>{1, 1, 1}), 1e-15);
  EXPECT_EQ(p.fraction[1], Fraction{});
  EXPECT_EQ(p.time, 2);
}

TEST(ExtendedXyz, RefusesMalformedFiles) {
  const TemporaryFolder folder;
  expect_refused(valid_xyz,
                 {
                     {"2\n", "x\n", "a.xyz:1: the number of particles is 'x'"},
                     {"2\n", "2 3\n", "first line"},
                     {"2\n", "123456789\n", "cannot hold"},
                     {"2\n", "3\n", "particle 3 of 3 must follow"},
                     {"Lattice", "lattice", "a.xyz:2: Lattice"},
                     {"\"4 0 0 1", "\"4 1 0 1", "along x"},
                     {"\"4 0 0 1", "\"-4 0 0 1", "above zero"},
                     {"\"4 0 0 1", "\"4 0 1", "Lattice has 8 numbers"},
                     {"\"4 0 0 1", "\"inf 0 0 1", "finite"},
                     {"T T T", "T T F", "periodic"},
                     {"T T T\"", "T T T", "no closing quote"},
                     {"Origin=\"1 1 1\"", "Origin=\"1 1\"", "Origin has 2"},
                     {"Time=2", "Time=2 Time=3", "twice"},
                     {"Time=2", "Time=x", "Time is 'x'"},
                     {"Properties", "Stuff", "Properties"},
                     {":R:3:radius", ":R:3:diameter", "radius:R:1"},
                     {":R:3:radius", ":R:2:radius", "pos:R:3"},
                     {":R:3:radius", ":R:99999999:radius", "1 ... 100 columns"},
                     {":R:3:radius", ":R:radius", "list of name:type:columns"},
                     {"note:I:2", "pos:R:3", "the column pos.0 occurs twice"},
                     {"b 1 1 1 0.5", "b 1 1 1 0", "radius"},
                     {"b 1 1 1 0.5", "b 1 1 nan 0.5", "a.xyz:4: pos"},
                     {"b 1 1 1 0.5 7 8\n", "b 1 1 1 0.5 7\n", "6 columns; expected 7"},
                     {"b 1 1 1 0.5 7 8\n", "", "particle 2 of 2 must follow"},
                 },
                 folder / "a.xyz", read_extended_xyz);
}

TEST(ExtendedXyz, SurvivesBeingCut) {
  const TemporaryFolder folder;
  expect_no_crash_when_cut(valid_xyz, folder / "a.xyz", read_extended_xyz);
}

}  // namespace
}  // namespace furnas
