#include "io/vtp_packing.h"

#include "io/vtp_reader.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(VtpPacking, ParticlesRoundTrip) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Packing p = random_packing(seed);
    write_vtp(p, folder / "a.vtp");
    const Packing q = read_vtp(folder / "a.vtp");
    expect_same_packing(p, q);
    expect_same_unwrapped(p, q);
    EXPECT_EQ(p.cell, q.cell);
    EXPECT_EQ(p.mass, q.mass);
    EXPECT_EQ(p.force, q.force);
    EXPECT_EQ(p.torque, q.torque);
    EXPECT_EQ(p.step, q.step);
    EXPECT_EQ(p.time, q.time);
    EXPECT_EQ(folder.files(), 1u);
  }
}

TEST(VtpPacking, CoordinationCountsContacts) {
  const TemporaryFolder folder;
  const Packing p = random_packing(1);
  write_vtp(p, folder / "a.vtp");
  const auto count = VtpReader(folder / "a.vtp").numbers("PointData", "coordination", 40, 1);
  EXPECT_EQ(std::accumulate(count.begin(), count.end(), 0.0), 2.0 * static_cast<double>(p.contacts.size()));
}

TEST(VtpPacking, ContactsAreLinesAlongTheBranch) {
  const TemporaryFolder folder;
  Packing p = random_packing(2, 2);
  p.contacts.assign(1, {});
  Contact& c = p.contacts[0];
  c.i = 1, c.j = 0, c.overlap = 0.25, c.sliding = true;
  c.branch = {0, 2, 0}, c.force = {3, 5, 4};
  write_contacts_vtp(p, folder / "contacts.vtp");
  VtpReader file(folder / "contacts.vtp");
  const std::vector<double> ends = file.numbers("Points", "Points", 2, 3);
  EXPECT_EQ((Vec3<double>{ends[0], ends[1], ends[2]}), p.position(1));
  EXPECT_NEAR(ends[1] - ends[4], 2, 1e-14);
  const auto value = [&](const char* name) { return file.numbers("CellData", name, 1, 1)[0]; };
  EXPECT_EQ(value("i"), 2);
  EXPECT_EQ(value("j"), 1);
  EXPECT_EQ(value("normal_force"), 5);
  EXPECT_EQ(value("tangential_force"), 5);
  EXPECT_EQ(value("overlap"), 0.25);
  EXPECT_EQ(value("sliding"), 1);
  EXPECT_EQ(file.numbers("CellData", "force", 1, 3), (std::vector<double>{3, 5, 4}));
}

TEST(VtpPacking, ContactsAndCellStandWhereTheParticlesDoAndNameThemAlike) {
  const TemporaryFolder folder;
  Packing p = random_packing(2, 2);
  p.labels.origin = {10, 20, 30};
  p.labels.id = {7, 9};
  p.contacts.assign(1, {});
  p.contacts[0].i = 1, p.contacts[0].j = 0;
  write_contacts_vtp(p, folder / "contacts.vtp");
  VtpReader file(folder / "contacts.vtp");
  EXPECT_EQ(file.numbers("CellData", "i", 1, 1)[0], 9);
  EXPECT_EQ(file.numbers("CellData", "j", 1, 1)[0], 7);
  const std::vector<double> ends = file.numbers("Points", "Points", 2, 3);
  EXPECT_EQ((Vec3<double>{ends[0], ends[1], ends[2]}), p.position(1) + p.labels.origin);
  write_cell_vtp(p, folder / "cell.vtp");
  const std::vector<double> corners = VtpReader(folder / "cell.vtp").numbers("Points", "Points", 24, 3);
  EXPECT_EQ((Vec3<double>{corners[0], corners[1], corners[2]}), p.labels.origin);
}

TEST(VtpPacking, NoContactsMakeAFileAllTheSame) {
  const TemporaryFolder folder;
  Packing p = random_packing(2);
  p.contacts.clear();
  write_contacts_vtp(p, folder / "contacts.vtp");
  VtpReader file(folder / "contacts.vtp");
  EXPECT_EQ(file.points(), 0U);
  EXPECT_TRUE(file.numbers("CellData", "force", 0, 3).empty());
}

TEST(VtpPacking, TheCellHasTwelveEdges) {
  const TemporaryFolder folder;
  const Packing p = random_packing(3);
  const Triangle& h = p.cell.edges;
  write_cell_vtp(p, folder / "cell.vtp");
  const std::vector<double> x = VtpReader(folder / "cell.vtp").numbers("Points", "Points", 24, 3);
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); k += 6)
    sum += norm(Vec3<double>{x[k] - x[k + 3], x[k + 1] - x[k + 4], x[k + 2] - x[k + 5]});
  EXPECT_NEAR(sum, 4 * (h.xx + norm(Vec3<double>{h.xy, h.yy, 0}) + norm(Vec3<double>{h.xz, h.yz, h.zz})),
              1e-12);
}

/// ParaView hands points on in any order, and a file of others may have any ids.
TEST(VtpPacking, SortsByIdsAndKeepsThem) {
  const TemporaryFolder folder;
  Packing p = random_packing(2, 3);
  p.labels.id = {7, 3, 12};
  write_vtp(p, folder / "a.vtp");
  const Packing q = read_vtp(folder / "a.vtp");
  EXPECT_EQ(q.labels.id, (std::vector<std::int64_t>{3, 7, 12}));
  EXPECT_EQ(q.mass, (std::vector{p.mass[1], p.mass[0], p.mass[2]}));
  EXPECT_LT(norm(q.unwrapped(0) - p.unwrapped(1)), 1e-12);
  EXPECT_EQ(q.species[2], p.species[2]);
  p.labels.id = {7, 7, 12};
  write_vtp(p, folder / "a.vtp");
  EXPECT_NE(input_error([&] { read_vtp(folder / "a.vtp"); }).find("the id 7 occurs twice"),
            std::string::npos);
}

TEST(VtpPacking, RefusesWhatIsNoPacking) {
  const TemporaryFolder folder;
  const Packing p = random_packing(4);
  write_cell_vtp(p, folder / "cell.vtp");
  EXPECT_NE(input_error([&] { read_vtp(folder / "cell.vtp"); }).find("cell (9 numbers)"), std::string::npos);
  write_file(folder / "b.vtp", "<VTKFile type=\"PolyData\"");
  EXPECT_NE(input_error([&] { read_vtp(folder / "b.vtp"); }), "");
  EXPECT_NE(input_error([&] { read_vtp(folder / "missing.vtp"); }), "");
  Packing bad = p;
  bad.radius[3] = -1;
  write_vtp(bad, folder / "c.vtp");
  EXPECT_NE(input_error([&] { read_vtp(folder / "c.vtp"); }).find("particle 4"), std::string::npos);
}

TEST(VtpPacking, HugeLengthsAllocateNothing) {
  const TemporaryFolder folder;
  write_vtp(random_packing(5), folder / "a.vtp");
  const std::string bytes = content(folder / "a.vtp");
  for (const std::string key : {"NumberOfPoints=\"40", "offset=\"1"}) {
    std::string changed = bytes;
    const std::size_t at = changed.find(key);
    ASSERT_NE(at, std::string::npos) << key;
    changed.insert(at + key.size(), "000000000000");
    std::ofstream(folder / "b.vtp", std::ios::binary) << changed;
    EXPECT_NE(input_error([&] { read_vtp(folder / "b.vtp"); }).find("can hold"), std::string::npos) << key;
  }
}

TEST(VtpPacking, SurvivesBeingCut) {
  const TemporaryFolder folder;
  write_vtp(random_packing(6), folder / "a.vtp");
  expect_no_crash_when_cut(content(folder / "a.vtp"), folder / "b.vtp", read_vtp, 7);
}

TEST(VtpPacking, NamesAFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_vtp(random_packing(7), folder / "none/a.vtp"), OutputError);
}

}  // namespace
}  // namespace furnas
