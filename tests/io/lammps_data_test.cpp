#include "io/lammps_data.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

const std::string valid_data =
    "two particles\n"
    "\n"
    "2 atoms  # so many\n"
    "2 atom types\n"
    "0 bonds\n"
    "1 5 xlo xhi\n"
    "-1 3 ylo yhi\n"
    "0 4 zlo zhi\n"
    "1 0.5 -0.5 xy xz yz\n"
    "\n"
    "Masses\n"
    "\n"
    "1 1\n"
    "2 1\n"
    "\n"
    "Velocities\n"
    "\n"
    "3 .1 .2 .3 .4 .5 .6\n"
    "7 1 2 3 4 5 6\n"
    "\n"
    "Atoms # sphere\n"
    "\n"
    "7 2 3.0 1.0 2 1 2 0 -1 2\n"
    "3 1 1.0 2.0 1 -1 0 0 0 0\n";

TEST(LammpsData, ReadsAnyOrderOfSectionsAndIds) {
  const TemporaryFolder folder;
  write_file(folder / "a.data", valid_data);
  const Packing p = read_lammps_data(folder / "a.data");
  ASSERT_EQ(p.size(), 2u);
  EXPECT_EQ(p.cell.edges, (Triangle{.xx = 4, .yy = 4, .zz = 4, .yz = -0.5, .xz = 0.5, .xy = 1}));
  EXPECT_EQ(p.species, (std::vector{Species::small, Species::large}));
  EXPECT_EQ(p.radius, (std::vector{0.5, 1.5}));
  EXPECT_NEAR(p.mass[0], 2 * std::numbers::pi / 6, 1e-15);
  EXPECT_NEAR(p.mass[1], 27 * std::numbers::pi / 6, 1e-13);
  EXPECT_EQ(p.velocity[0], (Vec3<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(p.spin[1], (Vec3<double>{4, 5, 6}));
  EXPECT_EQ(p.fraction[0], Fraction{});
  EXPECT_LT(norm(p.unwrapped(1) - (Vec3<double>{1, 2, 2} + p.cell.edges * Vec3<double>{0, -1, 2})), 1e-14);
}

TEST(LammpsData, RoundTripIsExactToRounding) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Packing p = random_packing(seed);
    write_lammps_data(p, folder / "a.data");
    const Packing q = read_lammps_data(folder / "a.data");
    expect_same_packing(p, q, 1e-13);
    expect_same_unwrapped(p, q);
    EXPECT_EQ(p.cell.edges, q.cell.edges);
    EXPECT_EQ(p.step, q.step);
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p.mass[k] / q.mass[k], 1, 1e-15);
  }
}

TEST(LammpsData, ReadsTheReferenceStart) {
  const Packing p = read_lammps_data(test_data("a3.data"));
  ASSERT_EQ(p.size(), 320u);
  EXPECT_EQ(std::count(p.species.begin(), p.species.end(), Species::large), 20);
  EXPECT_EQ(p.cell.edges.yz, 2.6203898728861512);
  EXPECT_EQ(p.spin[1].z, -0.0016631867822320587);
  EXPECT_NEAR(p.position(1).x, 1.1314318462987931, 1e-14);
  EXPECT_NEAR(p.unwrapped(4).y, 10.616113183580959, 1e-13);
}

TEST(LammpsData, RefusesMalformedFiles) {
  const TemporaryFolder folder;
  expect_refused(
      valid_data,
      {
          {"2 atoms", "x atoms", "a.data:3: the number of particles is 'x'"},
          {"2 atoms", "0 atoms", "at least 1"},
          {"2 atoms", "-2 atoms", "at least 1"},
          {"2 atoms", "4000000000 atoms", "cannot hold"},
          {"2 atoms", "99999999999999999999 atoms", "whole number"},
          {"2 atoms", "3 atoms", "the header promises 3"},
          {"2 atoms", "1 atoms", "more lines than the 1 of the header"},
          {"2 atoms  # so many\n", "", "no line 'N atoms'"},
          {"0 bonds", "5 bonds", "unknown line in the header"},
          {"1 5 xlo xhi\n", "", "no line 'lo hi xlo xhi'"},
          {"1 5 xlo", "5 5 xlo", "above zero"},
          {"0 4 zlo", "0 -4 zlo", "above zero"},
          {"-1 3 ylo", "-1 inf ylo", "finite"},
          {"1 0.5 -0.5 xy", "1 nan -0.5 xy", "finite"},
          {"Masses", "Bonds", "a.data:11: unknown section"},
          {"Atoms # sphere", "Atoms # atomic", "another style"},
          {"Atoms # sphere", "Velocities", "second time"},
          {"7 2 3.0", "3 2 3.0", "each id of the section Atoms once"},
          {"7 1 2 3", "8 1 2 3", "a.data:19: the section Velocities must have each id"},
          {"3 .1 .2", "x .1 .2", "a.data:18: the id is 'x'"},
          {"7 2 3.0", "7 3 3.0", "type"},
          {"7 2 3.0", "7 0 3.0", "the type is 0; allowed: 1"},
          {"3 1 1.0 2.0 1 -1 0 0 0 0\n", "3 1 1.0 2.0 1 -1 0 0 0 0",
           "a.data:24: the file ends within this line"},
          {"Atoms # sphere", "Atoms # bpm/sphere", "8 or 11: id molecule type"},
          {"Atoms # sphere", "Atoms # hybrid sphere", "another style"},
          {"1 5 xlo xhi", "1 5 0 avec", "no line 'x y z bvec'"},
          {"7 2 3.0", "7 2 0", "the diameter is '0'; it must be above zero"},
          {"7 2 3.0", "7 2 -3", "above zero"},
          {"7 2 3.0", "7 2 1e400", "the diameter is '1e400'; it must be finite"},
          {"7 2 3.0 1.0", "7 2 3.0 0", "the density"},
          {"2 1 2 0 -1 2", "2 nan 2 0 -1 2", "a.data:23: the position is 'nan'"},
          {"2 1 2 0 -1 2", "2 1e300 2 0 -1 2", "too many cells"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1 9e18", "whole number"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1 2000000000", "beyond 1e9"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1 -9223372036854775808", "beyond 1e9"},
          {"1 0.5 -0.5 xy", "1e300 0.5 -0.5 xy", "the tilts 1e+300 0.5 -0.5; allowed: up to 1e+06 edges"},
          {"7 2 3.0", "7 2147483647 3.0", "the type is 2147483647; allowed: 1 to 1000000"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1", "9 columns"},
          {".4 .5 .6", ".4 .5", "6 columns"},
          {"3 1 1.0 2.0 1 -1 0 0 0 0\n", "", "ends after 1 lines; the header promises 2"},
          {"Atoms # sphere\n\n7 2 3.0 1.0 2 1 2 0 -1 2\n3 1 1.0 2.0 1 -1 0 0 0 0\n", "", "no section Atoms"},
      },
      folder / "a.data", read_lammps_data);
}

TEST(LammpsData, KeepsIdsTypesStepAndOrigin) {
  const TemporaryFolder folder;
  std::string text = valid_data;
  write_file(folder / "a.data", text.replace(0, text.find('\n'), "via write_data, timestep = 2000"));
  const Packing p = read_lammps_data(folder / "a.data");
  EXPECT_EQ(p.step, 2000);
  EXPECT_EQ(p.labels.id, (std::vector<std::int64_t>{3, 7}));
  EXPECT_EQ(p.labels.type, (std::vector{1, 2})) << "type 1 is small";
  EXPECT_EQ(p.labels.origin, (Vec3<double>{1, -1, 0}));
  write_lammps_data(p, folder / "b.data");
  EXPECT_EQ(read_lammps_data(folder / "b.data").labels, p.labels);
  EXPECT_NE(content(folder / "b.data").find("\n3 1 1 2 1 -1 0 0 0 0\n"), std::string::npos)
      << content(folder / "b.data");
}

/// Two types, each told in the ways that programs have.
TEST(LammpsData, KnowsTheNamesOfTypes) {
  const TemporaryFolder folder;
  const auto names = [&](const std::string& from, const std::string& to) {
    std::string text = valid_data;
    write_file(folder / "a.data", text.replace(text.find(from), from.size(), to));
    return read_lammps_data(folder / "a.data").labels.names;
  };
  const std::vector<std::string> copper{"Cu", "Zr"};
  EXPECT_EQ(names("2 atom types", "2 atom types # Cu Zr"), copper);
  EXPECT_EQ(names("1 1\n2 1\n", "1 1 # Cu\n2 1 #Zr\n"), copper);
  EXPECT_EQ(names("Masses\n", "Atom Type Labels\n\n1 Cu\n2 Zr\n\nMasses\n"), copper);
  EXPECT_EQ(names("Masses\n", "Masses  # g/mol\n"), std::vector<std::string>());
  std::string text = valid_data;
  text.replace(text.find("Masses\n"), 7, "Atom Type Labels\n\n1 Cu\n2 Zr\n\nMasses\n");
  text.replace(text.find("7 2 3.0"), 7, "7 Zr 3.0");
  write_file(folder / "a.data", text);
  EXPECT_EQ(read_lammps_data(folder / "a.data").labels.type, (std::vector{1, 2}));
}

TEST(LammpsData, ReadsBondedSpheres) {
  const TemporaryFolder folder;
  std::string text = valid_data;
  text.replace(text.find("Atoms # sphere"), 14, "Atoms # bpm/sphere");
  text.replace(text.find("7 2 3.0"), 7, "7 5 2 3.0");
  text.replace(text.find("3 1 1.0"), 7, "3 5 1 1.0");
  write_file(folder / "a.data", text);
  write_file(folder / "b.data", valid_data);
  const Packing bonded = read_lammps_data(folder / "a.data"), p = read_lammps_data(folder / "b.data");
  expect_same_packing(bonded, p);
  expect_same_unwrapped(bonded, p);
}

/// The same packing, its cell and all vectors turned about z by 90 degrees: x is -y, y is x.
TEST(LammpsData, TurnsAGeneralCell) {
  const TemporaryFolder folder;
  write_file(folder / "upright.data",
             "t\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 5 ylo yhi\n0 6 zlo zhi\n1 0.5 -0.5 xy xz yz\n\n"
             "Atoms\n\n1 1 1 1 2 1 3\n\nVelocities\n\n1 1 2 3 4 5 6\n");
  write_file(folder / "general.data",
             "t\n\n1 atoms\n1 atom types\n0 4 0 avec\n-5 1 0 bvec\n0.5 0.5 6 cvec\n10 20 30 abc origin\n\n"
             "Atoms\n\n1 1 1 1 9 22 33\n\nVelocities\n\n1 -2 1 3 -5 4 6\n");
  const Packing a = read_lammps_data(folder / "upright.data"), b = read_lammps_data(folder / "general.data");
  EXPECT_TRUE(b.labels.turned);
  EXPECT_LT(strain_between(a.cell.edges, b.cell.edges), 1e-15);
  EXPECT_LT(distance(a, b, 0), 1e-14);
  EXPECT_LT(norm(a.velocity[0] - b.velocity[0]), 1e-15);
  EXPECT_LT(norm(a.spin[0] - b.spin[0]), 1e-15);
  EXPECT_LT(norm(b.labels.origin - Vec3<double>{20, -10, 30}), 1e-14);
}

/// 0.5005 of an edge: LAMMPS says "Triclinic box skew is too large".
TEST(LammpsData, WritesNoTiltThatLammpsRefuses) {
  const TemporaryFolder folder;
  Packing p = random_packing(1);
  Triangle& h = p.cell.edges;
  h.xy = 0.5005 * h.xx, h.xz = -0.53 * h.xx, h.yz = 0.51 * h.yy;
  write_lammps_data(p, folder / "a.data");
  const Packing q = read_lammps_data(folder / "a.data");
  EXPECT_LE(std::abs(q.cell.edges.xy), 0.5 * q.cell.edges.xx);
  EXPECT_LE(std::abs(q.cell.edges.xz), 0.5 * q.cell.edges.xx);
  EXPECT_LE(std::abs(q.cell.edges.yz), 0.5 * q.cell.edges.yy);
  expect_same_unwrapped(p, q, 1e-11);
  EXPECT_NEAR(q.cell.volume(), p.cell.volume(), 1e-12 * p.cell.volume());
}

TEST(LammpsData, RefusesAnIdThatOccursTwice) {
  const TemporaryFolder folder;
  std::string text = valid_data;
  text.erase(text.find("Velocities"), text.find("Atoms #") - text.find("Velocities"));
  expect_refused(text, {{"7 2 3.0", "3 2 3.0", "the id 3 occurs already in line"}}, folder / "a.data",
                 read_lammps_data);
}

TEST(LammpsData, SurvivesBeingCut) {
  const TemporaryFolder folder;
  expect_no_crash_when_cut(valid_data, folder / "a.data", read_lammps_data);
}

}  // namespace
}  // namespace furnas
