// What VTK's charts paint, as marks of a drawing.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <vtkContextDevice2D.h>
#include <vtkRect.h>
#include <vtkStdString.h>

#include "viz/drawing.hpp"

namespace packstone::viz {

/// A device for vtkContext2D that records marks, so that neither OpenGL nor a window is needed and what is painted can
/// become pixels, SVG or PDF of any size. Text, lines, polygons, strips of quads, discs for markers and clipping are
/// what charts need; all else throws std::logic_error.
///
/// VTK's y runs upwards, and it rounds places of ticks and sizes of fonts to whole units. A unit is therefore only a
/// small part of the drawing's pixel; widths of pens and sizes of fonts are in units as well.
class DrawingDevice : public vtkContextDevice2D {
 public:
  static constexpr double units_per_pixel = 64;

  static DrawingDevice* New();
  vtkTypeMacro(DrawingDevice, vtkContextDevice2D)

      /// Must be called before anything is painted; the drawing must outlive the painting.
      void record_into(Drawing& drawing) {
    drawing_ = &drawing;
  }

  static float units(double pixels) { return static_cast<float>(pixels * units_per_pixel); }
  /// A part of the drawing for VTK.
  vtkRectf units(const Box& box) const;

  // Whoever paints gives colours to single marks for scalars only, which charts here do not have: colours are the pen's
  // and the brush's.
  void DrawPoly(float* points, int n, unsigned char* colors, int components) override;
  void DrawLines(float* points, int n, unsigned char* colors, int components) override;
  void DrawPoints(float* points, int n, unsigned char* colors, int components) override;
  /// Discs, whatever the shape, with the pen's width as diameter.
  void DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors, int components) override;
  void DrawQuad(float* points, int n) override;
  /// The points are those of two lines in turn; the area between them is filled.
  void DrawQuadStrip(float* points, int n) override;
  void DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) override;

  /// One line, written to the right or, with an orientation of 90 degrees, upwards; a line offset raises it.
  void DrawString(float* point, const vtkStdString& text) override;
  /// From the base line to the top of capitals, turned as the text is, its lower left corner at 0, 0.
  void ComputeStringBounds(const vtkStdString& text, float bounds[4]) override;
  /// The same where the text lies around its point.
  void ComputeJustifiedStringBounds(const char* text, float bounds[4]) override;

  void SetMatrix(vtkMatrix3x3* matrix) override;
  void GetMatrix(vtkMatrix3x3* matrix) override;
  void MultiplyMatrix(vtkMatrix3x3* matrix) override;
  void PushMatrix() override { stack_.push_back(matrix_); }
  void PopMatrix() override;
  /// x, y, width, height [units], whatever the matrix; in force while clipping is enabled.
  void SetClipping(int* box) override;
  void EnableClipping(bool enable) override;

  void DrawPointSprites(vtkImageData*, float*, int, unsigned char*, int) override;
  void DrawEllipseWedge(float, float, float, float, float, float, float, float) override;
  void DrawEllipticArc(float, float, float, float, float, float) override;
  void DrawString(float*, const vtkUnicodeString&) override;
  void ComputeStringBounds(const vtkUnicodeString&, float[4]) override;
  void DrawMathTextString(float*, const vtkStdString&) override;
  void DrawImage(float[2], float, vtkImageData*) override;
  void DrawImage(const vtkRectf&, vtkImageData*) override;
  void SetColor4(unsigned char[4]) override;
  void SetTexture(vtkImageData*, int) override;
  void SetPointSize(float) override;
  void SetLineWidth(float) override;
  void SetLineType(int) override;

 protected:
  DrawingDevice() = default;
  ~DrawingDevice() override = default;

 private:
  using Matrix = std::array<double, 9>;  // row by row

  /// In the drawing, of a place before the matrix.
  Point placed(const float* point) const;
  std::vector<Point> placed(const float* points, int n) const;
  void line(const std::vector<Point>& points);
  std::optional<Stroke> stroke() const;
  std::optional<Fill> fill() const;
  TextStyle text_style() const;

  Drawing* drawing_ = nullptr;
  Matrix matrix_ = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<Matrix> stack_;
  Box clip_;
};

}  // namespace packstone::viz
