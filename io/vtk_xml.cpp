#include "io/vtk_xml.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

#include "io/vtk_arrays.h"

namespace furnas {
namespace {

/// Cells of `points_each` consecutive points: vertices or lines.
vtkSmartPointer<vtkCellArray> consecutive_cells(std::size_t count, std::int64_t points_each) {
  const auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto points = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto n = static_cast<vtkIdType>(count);
  offsets->SetNumberOfValues(n + 1);
  points->SetNumberOfValues(n * points_each);
  for (vtkIdType k = 0; k <= n; ++k) offsets->SetValue(k, k * points_each);
  for (vtkIdType k = 0; k < n * points_each; ++k) points->SetValue(k, k);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

std::vector<Vec3<double>> positions(const Packing& packing) {
  std::vector<Vec3<double>> points(packing.size());
  for (std::size_t k = 0; k < packing.size(); ++k) points[k] = packing.position(k);
  return points;
}

std::vector<std::int64_t> ids(std::size_t count) {
  std::vector<std::int64_t> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<std::int64_t>(k) + 1;
  return values;
}

std::vector<std::int32_t> coordination(const Packing& packing) {
  std::vector<std::int32_t> count(packing.size());
  for (const Contact& c : packing.contacts) ++count[c.i], ++count[c.j];
  return count;
}

std::vector<double> matrix(const Triangle& h) { return {h.xx, h.xy, h.xz, 0, h.yy, h.yz, 0, 0, h.zz}; }

vtkSmartPointer<vtkDataArray> field(const char* name, const std::vector<double>& values) {
  vtkSmartPointer<vtkDataArray> array = view(name, values);
  if (values.size() > 1) array->SetNumberOfComponents(static_cast<int>(values.size()));
  return array;
}

}  // namespace

void write_vtp(const Packing& packing, const std::filesystem::path& path) {
  const std::size_t n = packing.size();
  std::vector<std::uint8_t> species(n);
  std::vector<std::int32_t> image(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    species[k] = static_cast<std::uint8_t>(packing.species[k]);
    for (std::size_t a = 0; a < 3; ++a) image[3 * k + a] = packing.image[k][a];
  }
  const auto points = positions(packing);
  const auto id = ids(n);
  const auto contacts = coordination(packing);
  const std::vector<std::int64_t> step{packing.step};
  const auto cell = matrix(packing.cell.edges), rate = matrix(packing.cell.rate);
  const std::vector<double> time{packing.time};

  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(view(points));
  data->SetVerts(consecutive_cells(n, 1));
  vtkPointData* arrays = data->GetPointData();
  arrays->AddArray(view("id", id));
  arrays->AddArray(view("species", species));
  arrays->AddArray(view("radius", packing.radius));
  arrays->AddArray(view("mass", packing.mass));
  arrays->AddArray(view("image", image, 3));
  arrays->AddArray(view("velocity", packing.velocity));
  arrays->AddArray(view("spin", packing.spin));
  arrays->AddArray(view("force", packing.force));
  arrays->AddArray(view("torque", packing.torque));
  arrays->AddArray(view("coordination", contacts));
  data->GetFieldData()->AddArray(field("cell", cell));
  data->GetFieldData()->AddArray(field("rate", rate));
  data->GetFieldData()->AddArray(field("TimeValue", time));
  data->GetFieldData()->AddArray(view("step", step));
  write_poly_data(data, path);
}

void write_contacts_vtp(const Packing& packing, const std::filesystem::path& path) {
  const std::size_t n = packing.contacts.size();
  std::vector<Vec3<double>> points(2 * n), force(n);
  std::vector<std::int64_t> i(n), j(n);
  std::vector<double> normal(n), tangential(n), overlap(n);
  std::vector<std::uint8_t> sliding(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Contact& c = packing.contacts[k];
    const double length = norm(c.branch);
    points[2 * k] = packing.position(c.i);
    points[2 * k + 1] = points[2 * k] - c.branch;
    i[k] = std::int64_t{c.i} + 1;
    j[k] = std::int64_t{c.j} + 1;
    force[k] = c.force;
    const Vec3<double> direction = length > 0 ? c.branch * (1 / length) : Vec3<double>{};
    normal[k] = dot(c.force, direction);
    tangential[k] = norm(c.force - direction * normal[k]);
    overlap[k] = c.overlap;
    sliding[k] = c.sliding ? 1 : 0;
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(view(points));
  data->SetLines(consecutive_cells(n, 2));
  vtkCellData* arrays = data->GetCellData();
  arrays->AddArray(view("i", i));
  arrays->AddArray(view("j", j));
  arrays->AddArray(view("force", force));
  arrays->AddArray(view("normal_force", normal));
  arrays->AddArray(view("tangential_force", tangential));
  arrays->AddArray(view("overlap", overlap));
  arrays->AddArray(view("sliding", sliding));
  write_poly_data(data, path);
}

void write_cell_vtp(const Packing& packing, const std::filesystem::path& path) {
  std::vector<Vec3<double>> points;
  for (unsigned from = 0; from < 8; ++from)
    for (unsigned axis = 1; axis < 8; axis *= 2)
      if (!(from & axis))
        for (const unsigned corner : {from, from | axis})
          points.push_back(packing.cell.edges * Vec3<double>{corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0,
                                                             corner & 4 ? 1.0 : 0.0});
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(view(points));
  data->SetLines(consecutive_cells(points.size() / 2, 2));
  write_poly_data(data, path);
}

}  // namespace furnas
