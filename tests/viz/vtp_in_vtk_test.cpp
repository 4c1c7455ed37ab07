#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include "io/vtp_packing.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// What VTK itself, and so ParaView, finds in a file.
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0UL);
  return reader->GetOutput();
}

std::string type_name(int type) {
  switch (type) {
    case VTK_TYPE_FLOAT64:
      return "Float64";
    case VTK_TYPE_INT64:
      return "Int64";
    case VTK_TYPE_INT32:
      return "Int32";
    case VTK_TYPE_UINT8:
      return "UInt8";
    default:
      return "type " + std::to_string(type);
  }
}

/// "name type components x tuples" of each array, in order.
std::vector<std::string> arrays_of(vtkFieldData* data) {
  std::vector<std::string> found;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
    vtkDataArray* array = data->GetArray(k);
    found.push_back(std::string(array->GetName()) + " " + type_name(array->GetDataType()) + " " +
                    std::to_string(array->GetNumberOfComponents()) + " x " +
                    std::to_string(array->GetNumberOfTuples()));
  }
  return found;
}

Vec3<double> vector_at(vtkDataArray* array, std::size_t k) {
  const double* v = array->GetTuple3(static_cast<vtkIdType>(k));
  return {v[0], v[1], v[2]};
}

/// Cell k has the points that follow those of cell k - 1.
void expect_consecutive(vtkCellArray* cells, vtkIdType count, vtkIdType points_each) {
  ASSERT_EQ(cells->GetNumberOfCells(), count);
  const auto points = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType k = 0; k < count; ++k) {
    cells->GetCellAtId(k, points);
    ASSERT_EQ(points->GetNumberOfIds(), points_each);
    for (vtkIdType p = 0; p < points_each; ++p) ASSERT_EQ(points->GetId(p), k * points_each + p);
  }
}

TEST(VtpInVtk, ParticlesAreVerticesWithAllTheirArrays) {
  const TemporaryFolder folder;
  const Packing p = random_packing(1);
  write_vtp(p, folder / "a.vtp");
  const auto data = read_poly_data(folder / "a.vtp");
  expect_consecutive(data->GetVerts(), 40, 1);
  EXPECT_EQ(data->GetNumberOfLines(), 0);
  EXPECT_EQ(arrays_of(data->GetFieldData()),
            (std::vector<std::string>{"cell Float64 9 x 1", "rate Float64 9 x 1", "TimeValue Float64 1 x 1",
                                      "step Int64 1 x 1", "origin Float64 3 x 1"}));
  EXPECT_EQ(arrays_of(data->GetPointData()),
            (std::vector<std::string>{
                "id Int64 1 x 40", "type Int32 1 x 40", "species UInt8 1 x 40", "radius Float64 1 x 40",
                "mass Float64 1 x 40", "image Int32 3 x 40", "velocity Float64 3 x 40", "spin Float64 3 x 40",
                "force Float64 3 x 40", "torque Float64 3 x 40", "coordination Int32 1 x 40"}));
  vtkPointData* of = data->GetPointData();
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto number = [&](const char* name) {
      return of->GetArray(name)->GetTuple1(static_cast<vtkIdType>(k));
    };
    EXPECT_EQ(vector_at(data->GetPoints()->GetData(), k), p.position(k));
    EXPECT_EQ(number("id"), static_cast<double>(k + 1));
    EXPECT_EQ(number("species"), p.species[k] == Species::large ? 0 : 1);
    EXPECT_EQ(number("radius"), p.radius[k]);
    EXPECT_EQ(number("mass"), p.mass[k]);
    EXPECT_EQ(vector_at(of->GetArray("image"), k),
              (Vec3<double>{1.0 * p.image[k][0], 1.0 * p.image[k][1], 0}));
    EXPECT_EQ(vector_at(of->GetArray("velocity"), k), p.velocity[k]);
    EXPECT_EQ(vector_at(of->GetArray("spin"), k), p.spin[k]);
    EXPECT_EQ(vector_at(of->GetArray("force"), k), p.force[k]);
    EXPECT_EQ(vector_at(of->GetArray("torque"), k), p.torque[k]);
  }
  EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), p.time);
  EXPECT_EQ(data->GetFieldData()->GetArray("step")->GetTuple1(0), static_cast<double>(p.step));
  EXPECT_EQ(data->GetFieldData()->GetArray("cell")->GetComponent(0, 1), p.cell.edges.xy);
  EXPECT_EQ(data->GetFieldData()->GetArray("rate")->GetComponent(0, 8), p.cell.rate.zz);
}

/// Several blocks of each array.
TEST(VtpInVtk, ManyParticlesAreThereToTheLast) {
  const TemporaryFolder folder;
  const Packing p = random_packing(2, 150'000);
  write_vtp(p, folder / "a.vtp");
  const auto data = read_poly_data(folder / "a.vtp");
  expect_consecutive(data->GetVerts(), 150'000, 1);
  for (std::size_t k = 0; k < p.size(); ++k) {
    ASSERT_EQ(vector_at(data->GetPoints()->GetData(), k), p.position(k));
    ASSERT_EQ(vector_at(data->GetPointData()->GetArray("force"), k), p.force[k]);
  }
}

TEST(VtpInVtk, ContactsAreLinesWithAllTheirArrays) {
  const TemporaryFolder folder;
  Packing p = random_packing(3);
  write_contacts_vtp(p, folder / "contacts.vtp");
  const auto data = read_poly_data(folder / "contacts.vtp");
  const auto count = static_cast<vtkIdType>(p.contacts.size());
  expect_consecutive(data->GetLines(), count, 2);
  EXPECT_EQ(data->GetNumberOfVerts(), 0);
  EXPECT_EQ(arrays_of(data->GetCellData()),
            (std::vector<std::string>{"i Int64 1 x 20", "j Int64 1 x 20", "force Float64 3 x 20",
                                      "normal_force Float64 1 x 20", "tangential_force Float64 1 x 20",
                                      "overlap Float64 1 x 20", "sliding UInt8 1 x 20"}));
  for (std::size_t k = 0; k < p.contacts.size(); ++k) {
    EXPECT_EQ(vector_at(data->GetPoints()->GetData(), 2 * k), p.position(p.contacts[k].i));
    EXPECT_EQ(vector_at(data->GetCellData()->GetArray("force"), k), p.contacts[k].force);
  }
  p.contacts.clear();
  write_contacts_vtp(p, folder / "contacts.vtp");
  EXPECT_EQ(read_poly_data(folder / "contacts.vtp")->GetNumberOfLines(), 0);
}

TEST(VtpInVtk, TheCellHasTwelveEdges) {
  const TemporaryFolder folder;
  write_cell_vtp(random_packing(3), folder / "cell.vtp");
  const auto data = read_poly_data(folder / "cell.vtp");
  expect_consecutive(data->GetLines(), 12, 2);
  EXPECT_EQ(data->GetNumberOfPoints(), 24);
}

}  // namespace
}  // namespace furnas
