#include "io/lammps_dump.h"

#include <fmt/format.h>

#include "io/lammps_data.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

const std::string valid_dump =
    "ITEM: UNITS\nlj\nITEM: TIME\n2.5\n"
    "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\n"
    "ITEM: BOX BOUNDS xy xz yz pp pp pp\n"
    "0.5 6 1\n-1.5 3 0.5\n0 4 -0.5\n"
    "ITEM: ATOMS id radius xs ys zs vx\n"
    "9 0.5 0.25 0.5 0.75 3\n"
    "4 1.5 1.25 -0.5 0 4\n";

void compare_forces(const Packing& a, const Packing& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a.force[k], b.force[k]);
    EXPECT_EQ(a.torque[k], b.torque[k]);
  }
}

TEST(LammpsDump, RoundTripIsExactToRounding) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Packing p = random_packing(seed);
    write_lammps_dump(p, folder / "a.dump");
    const auto frames = read_lammps_dump(folder / "a.dump");
    ASSERT_EQ(frames.size(), 1u);
    expect_same_packing(p, frames[0]);
    expect_same_unwrapped(p, frames[0]);
    compare_forces(p, frames[0]);
    EXPECT_EQ(p.step, frames[0].step);
    EXPECT_EQ(p.time, frames[0].time);
    EXPECT_EQ(p.mass, frames[0].mass);
  }
}

TEST(LammpsDump, FindsColumnsByName) {
  const TemporaryFolder folder;
  write_file(folder / "a.dump", valid_dump);
  const Packing p = read_lammps_frame(folder / "a.dump");
  EXPECT_EQ(p.cell.edges, (Triangle{.xx = 4, .yy = 4, .zz = 4, .yz = -0.5, .xz = 0.5, .xy = 1}));
  EXPECT_EQ(p.step, 10);
  EXPECT_EQ(p.time, 2.5);
  EXPECT_EQ(p.species, (std::vector{Species::large, Species::small}));
  EXPECT_EQ(p.velocity[1], (Vec3<double>{3, 0, 0}));
  EXPECT_EQ(p.fraction[1], to_fraction({0.25, 0.5, 0.75}));
  EXPECT_EQ(p.image[0], (Image{1, -1, 0}));
  EXPECT_NEAR(p.mass[1], std::numbers::pi / 6, 1e-15);
}

/// The same two particles, told in each of the ways LAMMPS knows.
TEST(LammpsDump, AllKindsOfPositionsAgree) {
  const TemporaryFolder folder;
  const std::string head =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n1 5\n1 5\n1 5\nITEM: ATOMS ";
  for (const std::string rest :
       {"x y z ix iy iz diameter\n2 3 4 1 0 -1 2\n", "xu yu zu radius\n6 3 0 1\n",
        "xs ys zs ix iy iz radius\n.25 .5 .75 1 0 -1 1\n", "radius xsu ysu zsu\n1 1.25 .5 -.25\n"}) {
    write_file(folder / "a.dump", head + rest);
    const Packing p = read_lammps_frame(folder / "a.dump");
    EXPECT_EQ(p.fraction[0], to_fraction({0.25, 0.5, 0.75})) << rest;
    EXPECT_EQ(p.image[0], (Image{1, 0, -1})) << rest;
    EXPECT_EQ(p.radius[0], 1) << rest;
  }
}

TEST(LammpsDump, ReadsTheReferenceTrajectory) {
  const auto frames = read_lammps_dump(test_data("a3.nph.mu0.3.dump"));
  ASSERT_EQ(frames.size(), 5u);
  const Packing start = read_lammps_data(test_data("a3.data"));
  expect_same_packing(start, frames[0], 1e-13);
  EXPECT_EQ(frames[0].force[1].x, 0.049416696020172443);
  EXPECT_EQ(frames[4].step, 200);
  // The cell of the last frame as the run's log has it: xhi - xlo, yz, and where its origin went.
  EXPECT_NEAR(frames[4].cell.edges.xx, 8.7632290257454137 + 0.028596116124912641, 1e-13);
  EXPECT_NEAR(frames[4].cell.edges.yz, 2.6404320113648616, 1e-15);
  // The cell breathes about its centre, the particles with it: they move little within it.
  for (std::size_t k = 0; k < start.size(); ++k) EXPECT_LT(distance(start, frames[1], k), 0.2);
}

TEST(LammpsDump, RefusesMalformedFiles) {
  const TemporaryFolder folder;
  expect_refused(
      valid_dump,
      {
          {"ITEM: TIMESTEP", "ITEM TIMESTEP", "a.dump:5: expected 'ITEM: TIMESTEP'"},
          {"\n10\n", "\n1.5\n", "a.dump:6: the step is '1.5'"},
          {"ITEM: TIMESTEP\n10\n", "", "must follow"},
          {"ATOMS\n2\n", "ATOMS\n1000\n", "cannot hold"},
          {"ATOMS\n2\n", "ATOMS\n3\n", "particle 3 of 3 must follow"},
          {"ATOMS\n2\n", "ATOMS\n1\n", "expected 'ITEM: TIMESTEP'"},
          {"ATOMS\n2\n", "ATOMS\n2 3\n", "one value"},
          {"pp pp pp", "pp pp ff", "periodic"},
          {"xy xz yz pp", "abc origin pp", "x, y and z of an edge"},
          {"xy xz yz pp", "xy xz pp", "expected 'ITEM: BOX BOUNDS'"},
          {"4 1.5 1.25 -0.5 0 4\n", "4 1.5 1.25 -0.5 0 4", "a.dump:15: the file ends within this line"},
          {"0.5 6 1\n", "0.5 0.6 1\n", "above zero"},
          {"0.5 6 1\n", "0.5 6\n", "lo hi tilt"},
          {"radius xs", "size xs", "no column radius"},
          {"xs ys zs", "a b c", "no columns x y z"},
          {"xs ys zs", "xs xs zs", "the column xs occurs twice"},
          {"4 1.5 1.25", "9 1.5 1.25", "a.dump:15: the id 9 occurs already in line 14"},
          {"4 1.5 1.25", "4 0 1.25", "radius"},
          {"4 1.5 1.25", "4 -1.5 1.25", "radius"},
          {"4 1.5 1.25", "4 nan 1.25", "finite"},
          {"4 1.5 1.25", "4 1e200 1.25", "mass"},
          {"4 1.5 1.25", "4 1.5 1e30", "too many cells"},
          {"4 1.5 1.25", "4 1.5", "5 columns; expected 6"},
          {"4 1.5 1.25 -0.5 0 4\n", "", "particle 2 of 2 must follow"},
      },
      folder / "a.dump", read_lammps_dump);
  write_file(folder / "a.dump", "\n");
  EXPECT_THROW(read_lammps_dump(folder / "a.dump"), InputError);
  EXPECT_THROW(read_lammps_frame(folder / "a.dump"), InputError);
}

TEST(LammpsDump, KeepsMassesTimeAndNames) {
  const TemporaryFolder folder;
  const auto frame = [&](const std::string& columns, const std::string& rows) {
    write_file(folder / "a.dump",
               "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n1 5\n1 5\n1 5\nITEM: "
               "ATOMS " +
                   columns + "\n" + rows);
    return read_lammps_frame(folder / "a.dump");
  };
  const Packing p = frame("id type element x y z radius mass", "5 1 Cu 1 1 1 0.5 7\n9 2 Zr 3 3 3 0.5 8\n");
  EXPECT_EQ(p.mass, (std::vector<double>{7, 8}));
  EXPECT_EQ(p.labels.names, (std::vector<std::string>{"Cu", "Zr"}));
  EXPECT_EQ(p.labels.id, (std::vector<std::int64_t>{5, 9}));
  EXPECT_EQ(p.species, (std::vector{Species::large, Species::small})) << "two types of one size";
  write_lammps_dump(p, folder / "b.dump");
  EXPECT_EQ(read_lammps_frame(folder / "b.dump").labels, p.labels);
  EXPECT_EQ(read_lammps_frame(folder / "b.dump").mass, p.mass);
  const Packing same = frame("id type element x y z radius", "1 1 C 1 1 1 0.5\n2 2 C 3 3 3 0.4\n");
  EXPECT_TRUE(same.labels.names.empty()) << "names that tell nothing apart";
  EXPECT_NEAR(frame("x y z radius density", "1 1 1 0.5 4\n3 3 3 0.5 2\n").mass[0], 4 * std::numbers::pi / 6,
              1e-15);
}

TEST(LammpsDump, TakesACellWithoutFlagsForPeriodic) {
  const TemporaryFolder folder;
  for (const std::string flags : {"", " pp pp pp"}) {
    std::string text = valid_dump;
    write_file(folder / "a.dump", text.replace(text.find(" pp pp pp"), 9, flags));
    EXPECT_EQ(read_lammps_frame(folder / "a.dump").cell.edges.xy, 1) << flags;
  }
  write_file(folder / "a.dump",
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS\n1 5\n1 5\n1 5\n"
             "ITEM: ATOMS x y z radius\n1 1 1 1\n");
  EXPECT_EQ(read_lammps_frame(folder / "a.dump").cell.edges, (Triangle{4, 4, 4, 0, 0, 0}));
}

/// The third edge goes down: the lattice is that of one that goes up.
TEST(LammpsDump, TurnsAGeneralCellOfEitherHand) {
  const TemporaryFolder folder;
  for (const double sign : {1.0, -1.0}) {
    write_file(
        folder / "a.dump",
        fmt::format("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n"
                    "0 4 0 10\n-4 1 0 20\n0.5 0.5 {} 30\nITEM: ATOMS xs ys zs iz radius vx vy vz\n"
                    "0.25 0.5 0.75 2 0.5 1 2 3\n",
                    4 * sign));
    const Packing p = read_lammps_frame(folder / "a.dump");
    EXPECT_LT(strain_between({.xx = 4, .yy = 4, .zz = 4, .yz = -0.5 * sign, .xz = 0.5 * sign, .xy = 1},
                             p.cell.edges),
              1e-15);
    // 0.25 a + 0.5 b + (0.75 + 2) c from the origin, turned: x is the file's y, y its -x.
    const Vec3<double> at{0.25 * 4 + 0.5 * 1 + 2.75 * 0.5, -(0.5 * -4 + 2.75 * 0.5), 2.75 * 4 * sign};
    EXPECT_LT(norm(p.unwrapped(0) - at), 1e-13) << sign;
    EXPECT_LT(norm(p.velocity[0] - Vec3<double>{2, -1, 3}), 1e-15);
  }
}

/// 0.53 of an edge: read_dump says "Triclinic box skew is too large".
TEST(LammpsDump, WritesNoTiltThatLammpsRefuses) {
  const TemporaryFolder folder;
  Packing p = random_packing(1);
  p.cell.edges.xy = 0.53 * p.cell.edges.xx;
  write_lammps_dump(p, folder / "a.dump");
  const Packing q = read_lammps_frame(folder / "a.dump");
  EXPECT_LE(std::abs(q.cell.edges.xy), 0.5 * q.cell.edges.xx);
  expect_same_unwrapped(p, q, 1e-11);
}

TEST(LammpsDump, TakesTheLastFrameOrTheOneAskedFor) {
  const auto step = [](std::optional<std::int64_t> frame) {
    return read_lammps_frame(test_data("a3.nph.mu0.3.dump"), frame).step;
  };
  EXPECT_EQ(step({}), 200);
  EXPECT_EQ(step(1), 0);
  EXPECT_NE(input_error([&] { step(6); }).find("there is no frame 6; allowed: 1 to 5"), std::string::npos);
}

TEST(LammpsDump, SurvivesBeingCut) {
  const TemporaryFolder folder;
  expect_no_crash_when_cut(valid_dump, folder / "a.dump", read_lammps_dump);
}

}  // namespace
}  // namespace furnas
