#pragma once

#include <memory>
#include <string>

class vtkRenderWindow;

namespace furnas {

/// A window of VTK without a display: OpenGL through EGL, on no surface and no X server.
///
/// While it lives its context is current on this thread, and VTK prints nothing: what it reports is
/// kept in `complaint`. One at a time on a thread.
class OffscreenWindow {
 public:
  /// Sizes in pixels. Throws InputError when there is no EGL or OpenGL, or the size exceeds what OpenGL
  /// allows.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// To add renderers to and render.
  vtkRenderWindow& vtk();

  /// The first error that VTK reported since the window was made; empty: none.
  const std::string& complaint() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace furnas
