#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "engine/state/cell.h"
#include "viz/spheres.h"
#include "viz/view.h"

class vtkActor;
class vtkRenderer;

namespace furnas {

/// The edges of a periodic cell as tubes.
struct CellFrame {
  Cell cell;
  double tube() const;  ///< radius of the tubes [d_s]
};

/// What is drawn: spheres, with `frame` the edges of the cell, with `chains` the tubes of force_chains; in
/// which case the spheres are translucent.
struct Drawing {
  std::vector<Sphere> spheres;
  std::optional<CellFrame> frame;
  vtkSmartPointer<vtkActor> chains;
};

/// The view that holds all of the drawing in a frame of width / height `aspect`, from `turn` degrees about
/// the vertical.
View view_of(const Drawing& drawing, double aspect, double turn = 0);

/// The drawing with lights and the camera of `view`. The background is left transparent.
vtkSmartPointer<vtkRenderer> scene_of(const Drawing& drawing, const View& view);

}  // namespace furnas
