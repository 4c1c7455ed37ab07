#include "viz/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "viz/palette.h"

namespace furnas {
namespace {

constexpr const char* radius_name = "radius";

Vec3<double> corner(const Cell& cell, int number) {
  return cell.edges * Vec3<double>{double(number & 1), double(number >> 1 & 1), double(number >> 2 & 1)};
}

/// Of the tubes along the cell's edges [d_s].
double edge_radius(const Cell& cell) { return 0.0016 * norm(corner(cell, 7)); }

vtkNew<vtkPoints> centres(const Packing& packing) {
  vtkNew<vtkPoints> points;  // floats, ample for a picture
  points->SetNumberOfPoints(static_cast<vtkIdType>(packing.size()));
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const Vec3<double> p = packing.position(k);
    points->SetPoint(static_cast<vtkIdType>(k), p.x, p.y, p.z);
  }
  return points;
}

vtkNew<vtkFloatArray> radii(const Packing& packing) {
  vtkNew<vtkFloatArray> array;
  array->SetName(radius_name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(packing.size()));
  for (std::size_t k = 0; k < packing.size(); ++k)
    array->SetValue(static_cast<vtkIdType>(k), static_cast<float>(packing.radius[k]));
  return array;
}

vtkNew<vtkUnsignedCharArray> colours(const Packing& packing) {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(packing.size()));
  for (std::size_t k = 0; k < packing.size(); ++k)
    for (int c = 0; c < 3; ++c)
      array->SetTypedComponent(
          static_cast<vtkIdType>(k), c,
          static_cast<unsigned char>(std::lround(255 * colour_of(packing.species[k])[c])));
  return array;
}

vtkNew<vtkActor> spheres(const Packing& packing) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(centres(packing));
  data->GetPointData()->AddArray(radii(packing));
  data->GetPointData()->SetScalars(colours(packing));

  // The mapper draws vertices, not points: one cell that names them all.
  vtkNew<vtkCellArray> vertices;
  vertices->Use32BitStorage();
  vertices->InsertNextCell(static_cast<int>(packing.size()));
  for (std::size_t k = 0; k < packing.size(); ++k) vertices->InsertCellPoint(static_cast<vtkIdType>(k));
  data->SetVerts(vertices);

  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray(radius_name);

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.42);
  actor->GetProperty()->SetDiffuse(0.80);
  actor->GetProperty()->SetSpecular(0.08);
  actor->GetProperty()->SetSpecularPower(24);
  return actor;
}

vtkNew<vtkActor> edges(const Cell& cell) {
  vtkNew<vtkPoints> points;
  for (int n = 0; n < 8; ++n) {
    const Vec3<double> p = corner(cell, n);
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> lines;
  for (int n = 0; n < 8; ++n)
    for (int bit = 1; bit < 8; bit *= 2)
      if (!(n & bit)) lines->InsertNextCell({n, n | bit});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);

  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(data);
  tubes->SetRadius(edge_radius(cell));
  tubes->SetNumberOfSides(16);
  tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(cell_colour[0], cell_colour[1], cell_colour[2]);
  actor->GetProperty()->SetAmbient(0.7);
  actor->GetProperty()->SetDiffuse(0.3);
  return actor;
}

/// A light from far away, fixed to the camera: x to the right, y up, z towards the eye.
void shine(vtkRenderer& renderer, const Vec3<double>& from, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

void look(vtkCamera& camera, const View& view) {
  const Vec3<double> target = view.eye - view.farthest * view.toward;
  camera.SetPosition(view.eye.x, view.eye.y, view.eye.z);
  camera.SetFocalPoint(target.x, target.y, target.z);
  camera.SetViewUp(view.up.x, view.up.y, view.up.z);
  camera.SetViewAngle(2 * std::atan(view.slope_y) * 180 / std::numbers::pi);
  const double slack = 0.01 * (view.farthest - view.nearest);
  camera.SetClippingRange(std::max(view.nearest - slack, 0.5 * view.nearest), view.farthest + slack);
}

}  // namespace

View view_of(const Packing& packing, double aspect, bool cell) {
  ViewFit fit(aspect);
  for (std::size_t k = 0; k < packing.size(); ++k) fit.add(packing.position(k), packing.radius[k]);
  if (cell)
    for (int n = 0; n < 8; ++n) fit.add(corner(packing.cell, n), edge_radius(packing.cell));
  return fit.view();
}

vtkSmartPointer<vtkRenderer> scene_of(const Packing& packing, const View& view, bool cell) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0, 0, 0);
  renderer->SetBackgroundAlpha(0);
  renderer->AutomaticLightCreationOff();
  renderer->AddActor(spheres(packing));
  if (cell) renderer->AddActor(edges(packing.cell));
  shine(*renderer, {-0.5, 0.8, 1}, 0.75);
  shine(*renderer, {0.9, 0.1, 0.7}, 0.30);
  look(*renderer->GetActiveCamera(), view);
  return renderer;
}

}  // namespace furnas
