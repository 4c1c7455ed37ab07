#pragma once

#include <memory>
#include <string>

class vtkRenderWindow;

namespace furnas {

/// A VTK window without a display: OpenGL through EGL, without a surface and without an X server.
///
/// While the window exists, its OpenGL context is current on this thread, and VTK prints no messages: the
/// first error is kept in `complaint`. A thread may have only one such window at a time.
class OffscreenWindow {
 public:
  /// Sizes in pixels. Throws InputError when there is no EGL or OpenGL, or the size exceeds what OpenGL
  /// allows.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// The VTK window, to which renderers are added, and which renders.
  vtkRenderWindow& vtk();

  /// The first error that VTK reported since the window was made; empty: none.
  const std::string& complaint() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace furnas
