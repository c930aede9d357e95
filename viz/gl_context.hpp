// OpenGL contexts without a screen, one file each way to have one.
#pragma once

#include <memory>

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

namespace packstone::viz {

/// A core context of OpenGL 3.2 or above. VTK draws into buffers of its own, so the context's is a token one.
class GlContext {
 public:
  static constexpr int token_side = 16;  ///< [px]

  virtual ~GlContext() = default;
  /// False where the context is lost.
  virtual bool make_current() = 0;
  virtual bool is_current() const = 0;
};

/// Both throw RunError when there is no such context to be had. GLEW's questions (glx_shims) are answered by the way
/// last taken.
std::unique_ptr<GlContext> make_osmesa_context();
std::unique_ptr<GlContext> make_egl_context();

/// A window of VTK's own with its context, of the size [px]. Throws RunError where this VTK has none to be had.
vtkSmartPointer<vtkOpenGLRenderWindow> make_vtk_window(int width, int height);

}  // namespace packstone::viz
