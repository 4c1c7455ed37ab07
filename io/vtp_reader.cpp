#include "io/vtp_reader.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "engine/base/require.h"
#include "io/particle_rows.h"
#include "io/vtk_arrays.h"

namespace furnas {
namespace {

/// A number that must be whole and at most `limit` in size.
std::int64_t whole(double value, double limit, const char* name, const std::string& file) {
  if (!(std::abs(value) <= limit) || value != std::nearbyint(value))
    throw InputError(
        fmt::format("{}: {} is {}; expected a whole number within {}", file, name, value, limit));
  return static_cast<std::int64_t>(value);
}

Triangle triangle(vtkDataArray* array, const std::string& file) {
  double m[9];
  array->GetTuple(0, m);
  if (m[3] != 0 || m[6] != 0 || m[7] != 0)
    throw InputError(file + ": the array " + array->GetName() + " must be an upper triangle, row by row");
  return {.xx = m[0], .yy = m[4], .zz = m[8], .yz = m[5], .xz = m[2], .xy = m[1]};
}

Vec3<double> tuple(vtkDataArray* array, std::size_t k) {
  double v[3];
  array->GetTuple(static_cast<vtkIdType>(k), v);
  return {v[0], v[1], v[2]};
}

void read_species(Packing& packing, vtkDataArray* array, const std::string& file) {
  packing.species = species_by_size(packing.radius);
  if (!array) return;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double value = array->GetTuple1(static_cast<vtkIdType>(k));
    if (value != 0 && value != 1) throw InputError(file + ": species must be 0 (large) or 1 (small)");
    packing.species[k] = value == 0 ? Species::large : Species::small;
  }
}

void read_positions(Packing& packing, vtkPolyData* data, vtkDataArray* image, const std::string& file) {
  for (std::size_t k = 0; k < packing.size(); ++k) {
    double x[3];
    data->GetPoint(static_cast<vtkIdType>(k), x);
    if (image) {
      const Vec3<double> crossed = tuple(image, k);
      const auto count = [&](double value) {
        return static_cast<std::int32_t>(whole(value, 1e9, "image", file));
      };
      packing.image[k] = {count(crossed.x), count(crossed.y), count(crossed.z)};
    }
    if (!wrap(in_edges(packing.cell.edges, {x[0], x[1], x[2]}), packing.fraction[k], packing.image[k]))
      throw InputError(file + ": a position is not finite or too many cells away");
  }
}

void check_order(vtkDataArray* id, std::size_t count, const std::string& file) {
  for (std::size_t k = 0; id && k < count; ++k)
    if (id->GetTuple1(static_cast<vtkIdType>(k)) != static_cast<double>(k + 1))
      throw InputError(file + ": the ids must be 1 2 3 ... in this order");
}

}  // namespace

Packing read_vtp(const std::filesystem::path& path) {
  const std::string file = path.string();
  const auto data = read_poly_data(path);
  const auto n = static_cast<std::int64_t>(data->GetNumberOfPoints());
  const auto column = [&](const char* name, int components) {
    return find_array(data->GetPointData(), name, n, components, file);
  };
  const auto value = [&](const char* name, int components) {
    return find_array(data->GetFieldData(), name, 1, components, file);
  };
  vtkDataArray* const cell = value("cell", 9);
  vtkDataArray* const radius = column("radius", 1);
  if (!cell || !radius)
    throw InputError(file + ": the field array cell (9 numbers) and the point array radius are needed");

  Packing packing;
  packing.resize(static_cast<std::size_t>(n));
  packing.cell.edges = triangle(cell, file);
  if (vtkDataArray* rate = value("rate", 9)) packing.cell.rate = triangle(rate, file);
  if (vtkDataArray* time = value("TimeValue", 1)) packing.time = time->GetTuple1(0);
  if (vtkDataArray* step = value("step", 1)) packing.step = whole(step->GetTuple1(0), 9e15, "step", file);
  check_order(column("id", 1), packing.size(), file);
  vtkDataArray* const mass = column("mass", 1);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    packing.radius[k] = radius->GetTuple1(static_cast<vtkIdType>(k));
    packing.mass[k] = mass ? mass->GetTuple1(static_cast<vtkIdType>(k)) : sphere_mass(1, packing.radius[k]);
  }
  const auto vectors = [&](const char* name, std::vector<Vec3<double>>& into) {
    if (vtkDataArray* array = column(name, 3))
      for (std::size_t k = 0; k < packing.size(); ++k) into[k] = tuple(array, k);
  };
  vectors("velocity", packing.velocity);
  vectors("spin", packing.spin);
  vectors("force", packing.force);
  vectors("torque", packing.torque);
  check_packing(packing, path);
  read_species(packing, column("species", 1), file);
  read_positions(packing, data, column("image", 3), file);
  return packing;
}

}  // namespace furnas
