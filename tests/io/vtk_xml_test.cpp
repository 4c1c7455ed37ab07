#include "io/vtk_xml.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include "io/vtp_reader.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// What VTK itself, and so ParaView, finds in a file.
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST(VtkXml, ParticlesRoundTrip) {
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

TEST(VtkXml, ParticlesHaveVertexCellsAndCoordination) {
  const TemporaryFolder folder;
  const Packing p = random_packing(1);
  write_vtp(p, folder / "a.vtp");
  const auto data = read_poly_data(folder / "a.vtp");
  EXPECT_EQ(data->GetNumberOfVerts(), 40);
  double sum = 0;
  for (vtkIdType k = 0; k < 40; ++k) sum += data->GetPointData()->GetArray("coordination")->GetTuple1(k);
  EXPECT_EQ(sum, 2.0 * static_cast<double>(p.contacts.size()));
}

TEST(VtkXml, ContactsAreLinesAlongTheBranch) {
  const TemporaryFolder folder;
  Packing p = random_packing(2, 2);
  p.contacts.assign(1, {});
  Contact& c = p.contacts[0];
  c.i = 1, c.j = 0, c.overlap = 0.25, c.sliding = true;
  c.branch = {0, 2, 0}, c.force = {3, 5, 4};
  write_contacts_vtp(p, folder / "contacts.vtp");
  const auto data = read_poly_data(folder / "contacts.vtp");
  ASSERT_EQ(data->GetNumberOfLines(), 1);
  double a[3], b[3];
  data->GetPoint(0, a), data->GetPoint(1, b);
  EXPECT_EQ((Vec3<double>{a[0], a[1], a[2]}), p.position(1));
  EXPECT_NEAR(a[1] - b[1], 2, 1e-14);
  const auto value = [&](const char* name) { return data->GetCellData()->GetArray(name)->GetTuple1(0); };
  EXPECT_EQ(value("i"), 2);
  EXPECT_EQ(value("j"), 1);
  EXPECT_EQ(value("normal_force"), 5);
  EXPECT_EQ(value("tangential_force"), 5);
  EXPECT_EQ(value("overlap"), 0.25);
  EXPECT_EQ(value("sliding"), 1);
  EXPECT_EQ(data->GetCellData()->GetArray("force")->GetComponent(0, 2), 4);
}

TEST(VtkXml, NoContactsMakeAFileAllTheSame) {
  const TemporaryFolder folder;
  Packing p = random_packing(2);
  p.contacts.clear();
  write_contacts_vtp(p, folder / "contacts.vtp");
  EXPECT_EQ(read_poly_data(folder / "contacts.vtp")->GetNumberOfLines(), 0);
}

TEST(VtkXml, TheCellHasTwelveEdges) {
  const TemporaryFolder folder;
  const Packing p = random_packing(3);
  const Triangle& h = p.cell.edges;
  write_cell_vtp(p, folder / "cell.vtp");
  const auto data = read_poly_data(folder / "cell.vtp");
  ASSERT_EQ(data->GetNumberOfLines(), 12);
  double sum = 0;
  for (vtkIdType k = 0; k < 12; ++k) {
    double a[3], b[3];
    data->GetPoint(2 * k, a), data->GetPoint(2 * k + 1, b);
    sum += norm(Vec3<double>{a[0] - b[0], a[1] - b[1], a[2] - b[2]});
  }
  EXPECT_NEAR(sum, 4 * (h.xx + norm(Vec3<double>{h.xy, h.yy, 0}) + norm(Vec3<double>{h.xz, h.yz, h.zz})),
              1e-12);
}

TEST(VtkXml, RefusesWhatIsNoPacking) {
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

TEST(VtkXml, HugeLengthsAllocateNothing) {
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

TEST(VtkXml, SurvivesBeingCut) {
  const TemporaryFolder folder;
  write_vtp(random_packing(6), folder / "a.vtp");
  expect_no_crash_when_cut(content(folder / "a.vtp"), folder / "b.vtp", read_vtp, 7);
}

TEST(VtkXml, NamesAFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_vtp(random_packing(7), folder / "none/a.vtp"), OutputError);
}

}  // namespace
}  // namespace furnas
