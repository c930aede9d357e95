// VTK's own windows without a screen, each with an OpenGL context of its own. Up to VTK 9.3 its build decides which
// there are; from 9.4 on OSMesa's always is and looks for the library when it is made.
#include <cstdlib>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderingOpenGLConfigure.h>
#include <vtkVersionMacros.h>

#include "core/error.hpp"
#include "viz/gl_context.hpp"
#include "viz/glx_shims.hpp"

#if defined(VTK_OPENGL_HAS_OSMESA) || VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define PACKSTONE_VTK_HAS_OSMESA
#include <GL/osmesa.h>
#include <vtkOSOpenGLRenderWindow.h>
#endif
#ifdef VTK_OPENGL_HAS_EGL
#include <vtkEGLRenderWindow.h>
#endif

namespace packstone::viz {

namespace {

/// The window with its context; nothing where it gets none.
[[maybe_unused]] vtkSmartPointer<vtkOpenGLRenderWindow> initialised(vtkSmartPointer<vtkOpenGLRenderWindow> window,
                                                                    int width, int height) {
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long observer = window->AddObserver(vtkCommand::ErrorEvent, silence);
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetSize(width, height);
  window->Initialize();
  window->RemoveObserver(observer);
  return window->GetGenericContext() != nullptr ? window : nullptr;
}

}  // namespace

vtkSmartPointer<vtkOpenGLRenderWindow> make_vtk_window([[maybe_unused]] int width, [[maybe_unused]] int height) {
#ifdef PACKSTONE_VTK_HAS_OSMESA
  find_gl_functions_by([](const char* name) { return OSMesaGetProcAddress(name); });  // where GLEW is not VTK's own
  if (auto window = initialised(vtkSmartPointer<vtkOSOpenGLRenderWindow>::New(), width, height)) return window;
#endif
#ifdef VTK_OPENGL_HAS_EGL
  setenv("EGL_PLATFORM", "surfaceless", 1);  // where VTK asks for the default display, which may be X's
  if (auto window = initialised(vtkSmartPointer<vtkEGLRenderWindow>::New(), width, height)) return window;
#endif
  throw RunError("VTK " VTK_VERSION
                 " as built here has no off-screen window of its own; there are the backends osmesa and egl");
}

}  // namespace packstone::viz
