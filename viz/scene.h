#pragma once

#include <vtkSmartPointer.h>

#include "engine/state/packing.h"
#include "viz/view.h"

class vtkRenderer;

namespace furnas {

/// The view that holds the whole packing, every particle once at its place in the cell, in a frame of
/// width / height `aspect`; with `cell` the cell's corners too.
View view_of(const Packing& packing, double aspect, bool cell);

/// What is drawn: every particle once at its place in the cell, with `cell` the cell's edges, lights and
/// the camera of `view`. The background is left transparent.
vtkSmartPointer<vtkRenderer> scene_of(const Packing& packing, const View& view, bool cell);

}  // namespace furnas
