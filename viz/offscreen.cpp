#include "viz/offscreen.h"

// EGL is included before VTK's headers, which hide EGL's calling conventions.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>
#include <vtk_glew.h>

#include <string>
#include <string_view>

#include "engine/base/require.h"

namespace furnas {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw InputError("cannot draw: " + reason + " (needs EGL and OpenGL of Mesa: libegl1, libgl1-mesa-dri)");
}

/// Keeps VTK's first error instead of printing it.
class Listener : public vtkOutputWindow {
 public:
  static Listener* New();

  void DisplayText(const char* text) override {
    if (!heard.empty() || GetCurrentMessageType() != MESSAGE_TYPE_ERROR) return;
    const std::string_view message = text;
    // GLEW reports that there is no X server, but works without one. VTK repeats this message at every
    // rendering, so it is ignored.
    if (message.find("GLEW could not be initialized") != std::string_view::npos) return;
    heard = message.substr(0, message.find_last_not_of(" \n") + 1);
  }

  std::string heard;
};
vtkStandardNewMacro(Listener);

/// While an object of this class lives, VTK's messages go to the listener only.
class Silence {
 public:
  Silence() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(listener);
  }
  ~Silence() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  vtkNew<Listener> listener;

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
};

/// An OpenGL context without a surface, current on this thread.
class Context {
 public:
  Context() {
    const char* known = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!known || std::string_view(known).find("EGL_MESA_platform_surfaceless") == std::string_view::npos)
      refuse("EGL offers no display without a screen");
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
      refuse("EGL does not start");
    if (!make_current()) {
      close();
      refuse("EGL gives no OpenGL 3.3 context");
    }
  }
  ~Context() { close(); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  bool make_current() {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    EGLConfig config{};
    EGLint found = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, wanted, &config, 1, &found) || found == 0)
      return false;
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    return context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }

  void close() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    // The EGL display is not closed: EGL keeps one per process, and closing it unloads Mesa's driver, which
    // then leaks memory.
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

/// Members are destroyed in reverse order, so that VTK's window is destroyed before the context it draws
/// with.
struct OffscreenWindow::Parts {
  Silence silence;
  Context context;
  vtkNew<vtkGenericOpenGLRenderWindow> window;

  ~Parts() { window->Finalize(); }
};

OffscreenWindow::OffscreenWindow(int width, int height) : parts_(std::make_unique<Parts>()) {
  vtkGenericOpenGLRenderWindow& window = *parts_->window;
  window.SetOwnContext(0);
  window.SetReadyForRendering(true);
  window.SetMapped(1);
  window.SetIsCurrent(true);
  window.SetOffScreenRendering(1);
  window.SetShowWindow(false);
  window.SetUseOffScreenBuffers(true);
  window.SetFrameBlitModeToNoBlit();
  window.SetMultiSamples(0);
  window.SetAlphaBitPlanes(1);
  if (!window.InitializeFromCurrentContext()) refuse("VTK cannot use the OpenGL context");

  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels cannot be drawn: each side must be 1 to " + std::to_string(largest));
  window.SetSize(width, height);
}

OffscreenWindow::~OffscreenWindow() = default;

vtkRenderWindow& OffscreenWindow::vtk() { return *parts_->window; }

const std::string& OffscreenWindow::complaint() const { return parts_->silence.listener->heard; }

}  // namespace furnas
