#pragma once

#include <vtkSmartPointer.h>

class vtkRenderer;
class vtkSSAOPass;

namespace furnas {

/// Adds ambient occlusion to a renderer of opaque bodies: each point of a surface is darkened according to
/// the share of the space above it that other bodies fill. The radius of this space is the radius of the
/// returned pass [d_s].
vtkSmartPointer<vtkSSAOPass> add_ambient_occlusion(vtkRenderer& renderer);

}  // namespace furnas
