#include "viz/force_chains.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/analysis/contacts.h"
#include "viz/colouring.h"

namespace furnas {
namespace {

/// Lines, with a thickness and a colour at each end.
struct Lines {
  vtkNew<vtkPoints> ends;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> thickness;
  vtkNew<vtkUnsignedCharArray> colours;

  Lines() {
    colours->SetNumberOfComponents(3);
    colours->SetName("colour");
    thickness->SetName("thickness");
  }

  void add(const Vec3<double>& from, const Vec3<double>& to, double radius, const Rgb& colour) {
    const vtkIdType first = ends->GetNumberOfPoints();
    for (const Vec3<double>& end : {from, to}) {
      ends->InsertNextPoint(end.x, end.y, end.z);
      thickness->InsertNextValue(radius);
      for (const std::uint8_t part : colour) colours->InsertNextValue(part);
    }
    cells->InsertNextCell({first, first + 1});
  }
};

}  // namespace

double strong_force(const Packing& packing) {
  std::vector<double> forces;
  forces.reserve(packing.contacts.size());
  for (const Contact& c : packing.contacts) forces.push_back(normal_force(c));
  if (forces.empty()) return 0;
  const auto at = forces.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(forces.size() - 1));
  std::nth_element(forces.begin(), at, forces.end());
  return *at;
}

vtkSmartPointer<vtkActor> force_chains(const Packing& packing, double strongest) {
  constexpr double decades = 2;
  constexpr double thickest = 0.2;  // radius of the strongest tube/radius of the smaller sphere
  Lines lines;
  for (const Contact& c : packing.contacts) {
    const double grade = 1 + std::log10(normal_force(c) / strongest) / decades;
    if (!(grade > 0)) continue;
    const double smaller = std::min(packing.radius[c.i], packing.radius[c.j]);
    const double radius = thickest * smaller * std::min(grade, 1.0);
    const Rgb colour = graded(grade);
    const Vec3<double> i = packing.position(c.i), j = packing.position(c.j);
    // Each contact is drawn as two halves that meet at the contact point. Across a face of the cell each half
    // is at its own particle.
    const double at_i = packing.radius[c.i] / (packing.radius[c.i] + packing.radius[c.j]);
    lines.add(i, i - at_i * c.branch, radius, colour);
    lines.add(j, j + (1 - at_i) * c.branch, radius, colour);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(lines.ends);
  data->SetLines(lines.cells);
  data->GetPointData()->SetScalars(lines.thickness);
  data->GetPointData()->AddArray(lines.colours);

  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(data);
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("colour");

  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.65);
  return actor;
}

}  // namespace furnas
