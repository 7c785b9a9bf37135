// Mesa's surfaceless platform under VTK's generic window.
#include "page/window.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkWindowToImageFilter.h>

#include "core/error.hpp"
#include "page/style.hpp"

namespace stiction::postproc {

namespace {

bool make_context_current() {
  auto const get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr)
    return false;
  EGLDisplay const display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
      eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
    return false;
  EGLint const wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &found) == EGL_FALSE || found == 0)
    return false;
  EGLint const version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            2,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  EGLContext const context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  return context != EGL_NO_CONTEXT &&
         eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

class EglWindow : public vtkGenericOpenGLRenderWindow {
public:
  static EglWindow* New() {
    auto* window = new EglWindow;
    window->InitializeObjectBase();
    return window;
  }
  vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow)

      /// The loader reports a missing GLX display after it has loaded all entry points: that one is not an
      /// error.
      void OpenGLInitContext() override {
    if (Initialized)
      return;
    int const warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    Superclass::OpenGLInitContext();
    vtkObject::SetGlobalWarningDisplay(warnings);
    GlewInitValid = true;
    Initialized = true;
  }

protected:
  EglWindow() {
    SetReadyForRendering(true);
    SetIsCurrent(true);
    SetOwnContext(0);
    SetFrameBlitModeToNoBlit();
    MaximumHardwareLineWidth = 8;
  }
};

} // namespace

vtkSmartPointer<vtkRenderWindow> make_window(int width, int height) {
  static bool const available = make_context_current();
  if (!available)
    throw core::RunError("no off-screen OpenGL here: EGL offers no surfaceless context "
                         "(Debian: install libegl1 libegl-mesa0 libgl1-mesa-dri)");
  auto window = vtkSmartPointer<EglWindow>::New();
  window->SetMultiSamples(8);
  window->SetDPI(text_dpi);
  window->SetSize(width, height);
  return window;
}

Picture shoot(vtkRenderWindow& window) {
  window.Render();
  vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(&window);
  reader->SetInputBufferTypeToRGB();
  reader->ReadFrontBufferOff();
  reader->ShouldRerenderOff();
  reader->Update();
  return reader->GetOutput();
}

} // namespace stiction::postproc
