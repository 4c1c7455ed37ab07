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
#include <cmath>
#include <numbers>

#include "viz/palette.h"

namespace furnas {
namespace {

constexpr const char* radius_name = "radius";

Vec3<double> corner(const Cell& cell, int number) {
  return cell.edges * Vec3<double>{double(number & 1), double(number >> 1 & 1), double(number >> 2 & 1)};
}

vtkNew<vtkActor> actor_of(const std::vector<Sphere>& spheres) {
  const auto count = static_cast<vtkIdType>(spheres.size());
  vtkNew<vtkPoints> centres;
  centres->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> radii;
  radii->SetName(radius_name);
  radii->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(count);
  // The mapper draws vertices, not points. Therefore one cell of vertices lists all points.
  vtkNew<vtkCellArray> vertices;
  vertices->Use32BitStorage();
  vertices->InsertNextCell(static_cast<int>(count));
  for (vtkIdType k = 0; k < count; ++k) {
    const Sphere& sphere = spheres[static_cast<std::size_t>(k)];
    centres->SetPoint(k, sphere.centre.x, sphere.centre.y, sphere.centre.z);
    radii->SetValue(k, sphere.radius);
    colours->SetTypedTuple(k, sphere.colour.data());
    vertices->InsertCellPoint(k);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(centres);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->SetScalars(colours);
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

vtkNew<vtkActor> actor_of(const CellFrame& frame) {
  vtkNew<vtkPoints> points;
  for (int n = 0; n < 8; ++n) {
    const Vec3<double> p = corner(frame.cell, n);
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
  tubes->SetRadius(frame.tube());
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

/// Adds a distant light with a direction fixed to the camera: x to the right, y up, z towards the eye.
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

double CellFrame::tube() const { return 0.0016 * norm(corner(cell, 7)); }

View view_of(const Drawing& drawing, double aspect, double turn) {
  ViewFit fit(aspect, turn);
  for (const Sphere& s : drawing.spheres) fit.add({s.centre.x, s.centre.y, s.centre.z}, s.radius);
  if (drawing.frame)
    for (int n = 0; n < 8; ++n) fit.add(corner(drawing.frame->cell, n), drawing.frame->tube());
  return fit.view();
}

vtkSmartPointer<vtkRenderer> scene_of(const Drawing& drawing, const View& view) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0, 0, 0);
  renderer->SetBackgroundAlpha(0);
  renderer->AutomaticLightCreationOff();
  if (!drawing.spheres.empty()) renderer->AddActor(actor_of(drawing.spheres));
  if (drawing.chains) renderer->AddActor(drawing.chains);
  if (drawing.frame) renderer->AddActor(actor_of(*drawing.frame));
  shine(*renderer, {-0.5, 0.8, 1}, 0.75);
  shine(*renderer, {0.9, 0.1, 0.7}, 0.30);
  look(*renderer->GetActiveCamera(), view);
  return renderer;
}

}  // namespace furnas
