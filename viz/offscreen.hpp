// Drawing without a screen. How an OpenGL context comes about is known to gl_context.hpp and its files alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace packstone::viz {

/// The software renderer misbehaves above this many pixels a side.
inline constexpr int max_side = 8192;

/// Where the OpenGL context comes from, the last one from VTK's own window; with the same Mesa all draw the same bytes.
enum class Backend { osmesa, egl, vtk };

/// Throws InputError where there is none of the name.
Backend backend_named(const std::string& name);

/// Of all windows that this process makes from now on: OpenGL's functions are the process's. OSMesa until then.
void use_backend(Backend backend);

/// What drew the last window of this process, such as "OSMesa llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core
/// Profile) Mesa 22.3.6"; empty while there was none.
std::string renderer_in_use();

/// A VTK render window in memory. Needs neither X nor DISPLAY, and never touches them.
/// An executable that links packstone::viz has all it needs; the constructor checks that it does.
class OffscreenWindow {
 public:
  /// Throws InputError when a side is not in 1 ... max_side [px], RunError when there is no OpenGL context to be had.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkRenderWindow* window() const;
  int width() const { return width_; }
  int height() const { return height_; }

  /// Throws InputError as the constructor does.
  void resize(int width, int height);

  /// Draws all renderers of the window. Throws RunError when OpenGL reports a failure.
  void render();

  /// (height * width * 4) bytes of the last render, bottom row first; colours are premultiplied by alpha.
  const std::vector<std::uint8_t>& rgba();

  /// (height * width) depths of the last render, 0 at the near and 1 at the far plane, bottom row first.
  std::vector<float> depths() const;

 private:
  struct Context;

  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
  std::unique_ptr<Context> context_;
};

}  // namespace packstone::viz
