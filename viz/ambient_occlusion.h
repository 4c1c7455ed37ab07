#pragma once

#include <vtkSmartPointer.h>

class vtkRenderer;
class vtkSSAOPass;

namespace furnas {

/// Makes a renderer of opaque bodies darken what lies deep between them, by how much of the space above
/// a surface others fill. The reach is the radius of the pass that is returned [d_s].
vtkSmartPointer<vtkSSAOPass> add_ambient_occlusion(vtkRenderer& renderer);

}  // namespace furnas
