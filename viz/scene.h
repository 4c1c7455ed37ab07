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

/// What is drawn: the spheres, the edges of the cell if there is a `frame`, and the tubes of force_chains if
/// there are `chains`.
struct Drawing {
  std::vector<Sphere> spheres;
  std::optional<CellFrame> frame;
  vtkSmartPointer<vtkActor> chains;
};

/// The view that contains the whole drawing in a frame of width / height `aspect`; the eye is rotated by
/// `turn` degrees about the vertical.
View view_of(const Drawing& drawing, double aspect, double turn = 0);

/// The drawing with lights and the camera of `view`. The background is transparent.
vtkSmartPointer<vtkRenderer> scene_of(const Drawing& drawing, const View& view);

}  // namespace furnas
