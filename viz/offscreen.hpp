// Drawing without a screen: the one part that knows how an OpenGL context comes about.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

class vtkRenderWindow;

namespace packstone::viz {

/// The software renderer misbehaves above this many pixels a side.
inline constexpr int max_side = 8192;

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
