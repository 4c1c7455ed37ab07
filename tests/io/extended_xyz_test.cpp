#include "io/extended_xyz.h"

#include <fmt/format.h>

#include "tests/io/packings.h"

namespace furnas {
namespace {

const std::string valid_xyz =
    "2\n"
    "flag Lattice=\"4 0 0 1 4 0 0.5 -0.5 4\" Origin=\"1 1 1\" pbc=\"T T T\" Time=2 "
    "Properties=species:S:1:pos:R:3:radius:R:1:note:I:2\n"
    "a 2 2 2 1.5 0 0\n"
    "b 1 1 1 0.5 7 8\n";

Packing read_last_xyz(const std::filesystem::path& path) { return read_extended_xyz(path); }

TEST(ExtendedXyz, RoundTripIsExactToRounding) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Packing p = random_packing(seed);
    write_extended_xyz(p, folder / "a.extxyz");
    const Packing q = read_extended_xyz(folder / "a.extxyz");
    expect_same_packing(p, q);
    expect_same_unwrapped(p, q);
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
  expect_refused(
      valid_xyz,
      {
          {"2\n", "x\n", "a.xyz:1: the number of particles is 'x'"},
          {"2\n", "2 3\n", "first line"},
          {"2\n", "123456789\n", "cannot hold"},
          {"2\n", "3\n", "particle 3 of 3 must follow"},
          {"Lattice", "lattice", "a.xyz:2: Lattice"},
          {"\"4 0 0 1", "\"0 0 0 1", "above zero"},
          {"\"4 0 0 1 4 0", "\"4 0 0 1 0 0", "above zero"},
          {"\"4 0 0 1", "\"4 0 1", "Lattice has 8 numbers"},
          {"\"4 0 0 1", "\"inf 0 0 1", "finite"},
          {"T T T", "T T F", "periodic"},
          {"T T T\"", "T T T", "no closing quote"},
          {"Origin=\"1 1 1\"", "Origin=\"1 1\"", "Origin has 2"},
          {"Time=2", "Time=2 Time=3", "twice"},
          {"Time=2", "Time=x", "Time is 'x'"},
          {"Properties", "Stuff", "Properties"},
          {":R:3:radius", ":R:3:size", "radius:R:1"},
          {"T T T", "T T", "periodic"},
          {"T T T", "1 1 0", "periodic"},
          {"Origin=\"1 1 1\"", "Origin=[1,1,1", "no closing bracket"},
          {"b 1 1 1 0.5 7 8\n", "b 1 1 1 0.5 7 8\nc 1 1 1 0.5 7 8\n", "a.xyz:5: more rows than the 2"},
          {"b 1 1 1 0.5 7 8\n", "b 1 1 1 0.5 7 8", "a.xyz:4: the file ends within this line"},
          {"b 1 1 1 0.5 7 8\n", "b 1 1 1 0.5 7 8\n2\n", "Lattice"},
          {":R:3:radius", ":R:2:radius", "pos:R:3"},
          {":R:3:radius", ":R:99999999:radius", "1 ... 100 columns"},
          {":R:3:radius", ":R:radius", "list of name:type:columns"},
          {"note:I:2", "pos:R:3", "the column pos.0 occurs twice"},
          {"b 1 1 1 0.5", "b 1 1 1 0", "radius"},
          {"b 1 1 1 0.5", "b 1 1 nan 0.5", "a.xyz:4: pos"},
          {"b 1 1 1 0.5 7 8\n", "b 1 1 1 0.5 7\n", "6 columns; expected 7"},
          {"b 1 1 1 0.5 7 8\n", "", "particle 2 of 2 must follow"},
      },
      folder / "a.xyz", read_last_xyz);
}

TEST(ExtendedXyz, SurvivesBeingCut) {
  const TemporaryFolder folder;
  expect_no_crash_when_cut(valid_xyz, folder / "a.xyz", read_last_xyz);
}

/// A trajectory of a compaction must not give its gas.
TEST(ExtendedXyz, TakesTheLastFrameOrTheOneAskedFor) {
  const TemporaryFolder folder;
  const std::string rows = "A 1 1 1 0.5\nB 3 3 3 0.25\n";
  const auto head = [](int edge) {
    return fmt::format("2\nLattice=\"{0} 0 0 0 {0} 0 0 0 {0}\" Properties=species:S:1:pos:R:3:radius:R:1\n",
                       edge);
  };
  write_file(folder / "t.xyz", head(4) + rows + head(8) + rows + "\n");
  const auto edge = [&](std::optional<std::int64_t> frame) {
    return read_extended_xyz(folder / "t.xyz", frame).cell.edges.xx;
  };
  EXPECT_EQ(edge({}), 8);
  EXPECT_EQ(edge(1), 4);
  EXPECT_EQ(edge(2), 8);
  EXPECT_NE(input_error([&] { edge(3); }).find("there is no frame 3; allowed: 1 to 2"), std::string::npos);
  write_file(folder / "t.xyz", head(4) + rows + "C 1 3 1 0.25\n");
  EXPECT_NE(input_error([&] { edge({}); }).find("t.xyz:5: more rows than the 2"), std::string::npos);
}

Packing xyz_of(const TemporaryFolder& folder, const std::string& header, const std::string& rows) {
  const auto count = std::count(rows.begin(), rows.end(), '\n');
  write_file(folder / "a.xyz", fmt::format("{}\n{}\n{}", count, header, rows));
  return read_extended_xyz(folder / "a.xyz");
}

TEST(ExtendedXyz, TakesEverySpellingOfPeriodicAndOfQuotes) {
  const TemporaryFolder folder;
  const std::string columns = " Properties=pos:R:3:radius:R:1";
  for (const char* pbc :
       {"pbc=\"T T T\"", "pbc=\"True True True\"", "pbc=[T, T, T]", "pbc=\"1 1 1\"", "pbc=[true,true,true]",
        "pbc={T T T}", "pbc='T T T'", "pbc = \".true. .true. .true.\""}) {
    const Packing p =
        xyz_of(folder, std::string("Lattice='4 0 0 0 4 0 0 0 4' ") + pbc + columns, "1 2 3 0.5\n");
    EXPECT_EQ(p.cell.edges.zz, 4) << pbc;
  }
  const Triangle edges{.xx = 4, .yy = 4, .zz = 4, .yz = -0.5, .xz = 0.5, .xy = 1};
  for (const char* lattice : {"Lattice=[[4,0,0],[1,4,0],[0.5,-0.5,4]]", "Lattice={4 0 0 1 4 0 0.5 -0.5 4}",
                              "note=\"a \\\"b\\\" c\"\tLattice=\"4 0 0  1 4 0\t0.5 -0.5 4\""})
    EXPECT_EQ(xyz_of(folder, lattice + columns, "1 2 3 0.5\n").cell.edges, edges) << lattice;
  const Packing nearly = xyz_of(folder, "Lattice=\"4 2.4e-16 0 0 4 0 0 0 4\"" + columns, "1 2 3 0.5\n");
  EXPECT_NEAR(nearly.cell.edges.xx, 4, 1e-15);
  EXPECT_LT(norm(nearly.position(0) - Vec3<double>{1, 2, 3}), 1e-14);
}

/// As ASE writes its primitive cell of copper, with masses and momenta.
TEST(ExtendedXyz, TakesTheColumnsOfAse) {
  const TemporaryFolder folder;
  const std::string cell =
      "Lattice=\"0.0 0.70710675 0.70710675 0.70710675 0.0 0.70710675 0.70710675 0.70710675 0.0\" pbc=\"T T "
      "T\" ";
  const Packing p = xyz_of(folder, cell + "Properties=species:S:1:pos:R:3:masses:R:1:radii:R:1:momenta:R:3",
                           "Cu 0.0 0.0 0.0 7.0 0.5001 0.7 1.4 0.0\n");
  EXPECT_EQ(p.mass[0], 7);
  EXPECT_EQ(p.radius[0], 0.5001);
  EXPECT_NEAR(p.cell.volume(), 2 * std::pow(0.70710675, 3), 1e-15);
  EXPECT_NEAR(norm(p.velocity[0]), std::sqrt(0.01 + 0.04), 1e-15);
  EXPECT_TRUE(p.labels.turned);
  EXPECT_EQ(p.labels.names, std::vector<std::string>{"Cu"});
  EXPECT_EQ(xyz_of(folder, cell + "Properties=pos:R:3:diameter:R:1", "0 0 0 1.0002\n").radius[0], 0.5001);
}

TEST(ExtendedXyz, HasAnElementForEachTypeAndItsNameBeside) {
  const TemporaryFolder folder;
  write_extended_xyz(random_packing(1, 5), folder / "a.extxyz");
  const std::string text = content(folder / "a.extxyz");
  EXPECT_NE(text.find("species:S:1:species_name:S:1:id:I:1"), std::string::npos);
  EXPECT_NE(text.find("\nAu small 1 "), std::string::npos);
  EXPECT_NE(text.find("\nAg large 3 "), std::string::npos);
  const Packing alloy =
      xyz_of(folder, "Lattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3:radius:R:1",
             "Zr 1 1 1 0.6\nCu 3 3 3 0.5\n");
  EXPECT_EQ(alloy.species, (std::vector{Species::large, Species::small}));
  write_extended_xyz(alloy, folder / "b.extxyz");
  EXPECT_NE(content(folder / "b.extxyz").find("\nZr Zr 2 1 "), std::string::npos);
  EXPECT_EQ(read_extended_xyz(folder / "b.extxyz").labels, alloy.labels);
}

TEST(ExtendedXyz, ReadsTheNamesThatOlderVersionsWrote) {
  const TemporaryFolder folder;
  const Packing p = xyz_of(folder, "Lattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3:radius:R:1",
                           "large 1 1 1 0.5\nsmall 3 3 3 0.5\n");
  EXPECT_EQ(p.species, (std::vector{Species::large, Species::small}));
  EXPECT_EQ(p.labels, Labels{});
}

}  // namespace
}  // namespace furnas
