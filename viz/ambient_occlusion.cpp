#include "viz/ambient_occlusion.h"

#include <vtkCameraPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

namespace furnas {
namespace {

/// VTK's pass with positions in single precision. VTK stores positions as half floats, whose rounding is
/// larger than a small sphere of a large packing. VTK also takes positions from a texture of averages over
/// many pixels, which lie off the surface, so that a large sphere shades itself.
class AmbientOcclusion : public vtkSSAOPass {
 public:
  static AmbientOcclusion* New();

  void Render(const vtkRenderState* state) override {
    if (!PositionTexture) {
      auto* window = static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
      PositionTexture = vtkTextureObject::New();
      PositionTexture->SetContext(window);
      PositionTexture->SetFormat(GL_RGBA);
      PositionTexture->SetInternalFormat(GL_RGBA32F);
      PositionTexture->SetDataType(GL_FLOAT);
      PositionTexture->SetWrapS(vtkTextureObject::ClampToEdge);
      PositionTexture->SetWrapT(vtkTextureObject::ClampToEdge);
      PositionTexture->SetMinificationFilter(vtkTextureObject::Nearest);
      const int* size = window->GetSize();
      PositionTexture->Allocate2D(size[0], size[1], 4, VTK_FLOAT);
    }
    vtkSSAOPass::Render(state);
  }
};
vtkStandardNewMacro(AmbientOcclusion);

/// Sets the position of the background far behind the scene. VTK leaves it at the position of the eye, where
/// it would shade everything.
class FarBackground : public vtkRenderPass {
 public:
  static FarBackground* New();

  void Render(const vtkRenderState*) override {
    constexpr GLint positions = 1;  // the attachment from which vtkSSAOPass reads positions
    constexpr GLfloat far[] = {0, 0, -1e30F, 1};
    glClearBufferfv(GL_COLOR, positions, far);
  }
};
vtkStandardNewMacro(FarBackground);

}  // namespace

vtkSmartPointer<vtkSSAOPass> add_ambient_occlusion(vtkRenderer& renderer) {
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<FarBackground> background;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(background);
  passes->AddItem(lights);
  passes->AddItem(opaque);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkNew<AmbientOcclusion> occlusion;
  occlusion->SetDelegatePass(camera);
  occlusion->SetKernelSize(32);
  occlusion->BlurOn();
  renderer.SetPass(occlusion);
  return occlusion;
}

}  // namespace furnas
