#include "viz/drawing_device.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <vtkBrush.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include "viz/font.hpp"

namespace packstone::viz {

namespace {

constexpr double full = 255;

double pixels(double units) { return units / DrawingDevice::units_per_pixel; }

/// Drawn and left out in turn, as multiples of the line's width.
std::vector<double> dashes(int line_type, double width) {
  constexpr double dash = 8, dot = 2, gap = 4;
  std::vector<double> pattern;
  switch (line_type) {
    case vtkPen::DASH_LINE:
      pattern = {dash, gap};
      break;
    case vtkPen::DOT_LINE:
      pattern = {dot, gap};
      break;
    case vtkPen::DASH_DOT_LINE:
      pattern = {dash, gap, dot, gap};
      break;
    case vtkPen::DASH_DOT_DOT_LINE:
      pattern = {dash, gap, dot, gap, dot, gap};
      break;
    case vtkPen::DENSE_DOT_LINE:
      pattern = {dot, dot};
      break;
    default:
      break;
  }
  for (double& length : pattern) length *= width;
  return pattern;
}

/// Which end of a text is at its point, for 0, 1 and 2 as VTK numbers left, centre, right and bottom, centre, top.
Side side(int justification) { return static_cast<Side>(justification); }

static_assert(VTK_TEXT_LEFT == 0 && VTK_TEXT_CENTERED == 1 && VTK_TEXT_RIGHT == 2);
static_assert(VTK_TEXT_BOTTOM == 0 && VTK_TEXT_TOP == 2);
static_assert(static_cast<int>(Side::low) == 0 && static_cast<int>(Side::middle) == 1 &&
              static_cast<int>(Side::high) == 2);

[[noreturn]] void refuse(const std::string& what) {
  throw std::logic_error("the device for charts does not draw " + what);
}

}  // namespace

vtkStandardNewMacro(DrawingDevice)

    vtkRectf DrawingDevice::units(const Box& box) const {
  return {units(box.left), units(drawing_->height - box.bottom), units(box.width()), units(box.height())};
}

Point DrawingDevice::placed(const float* point) const {
  const double x = point[0], y = point[1];
  const double across = matrix_[0] * x + matrix_[1] * y + matrix_[2];
  const double up = matrix_[3] * x + matrix_[4] * y + matrix_[5];
  return {pixels(across), drawing_->height - pixels(up)};
}

std::vector<Point> DrawingDevice::placed(const float* points, int n) const {
  std::vector<Point> result;
  result.reserve(n);
  for (std::ptrdiff_t i = 0; i < n; ++i) result.push_back(placed(points + 2 * i));
  return result;
}

std::optional<Stroke> DrawingDevice::stroke() const {
  if (Pen->GetLineType() == vtkPen::NO_PEN || Pen->GetOpacity() == 0) return std::nullopt;
  const unsigned char* c = Pen->GetColor();
  const double width = pixels(Pen->GetWidth());
  return Stroke{{c[0], c[1], c[2]}, width, dashes(Pen->GetLineType(), width)};
}

std::optional<Fill> DrawingDevice::fill() const {
  if (Brush->GetOpacity() == 0) return std::nullopt;
  const unsigned char* c = Brush->GetColor();
  return Fill{{c[0], c[1], c[2]}, Brush->GetOpacity() / full};
}

TextStyle DrawingDevice::text_style() const {
  const double* c = TextProp->GetColor();
  const auto channel = [](double share) { return static_cast<std::uint8_t>(std::lround(full * share)); };
  return {.size = pixels(TextProp->GetFontSize()),
          .colour = {channel(c[0]), channel(c[1]), channel(c[2])},
          .across = side(TextProp->GetJustification()),
          .along = side(TextProp->GetVerticalJustification()),
          .upward = TextProp->GetOrientation() == 90,
          .bold = TextProp->GetBold() != 0};
}

void DrawingDevice::line(const std::vector<Point>& points) {
  if (const auto pen = stroke()) drawing_->polyline(points, *pen);
}

void DrawingDevice::DrawPoly(float* points, int n, unsigned char*, int) { line(placed(points, n)); }

void DrawingDevice::DrawLines(float* points, int n, unsigned char*, int) {
  for (std::ptrdiff_t i = 0; i + 1 < n; i += 2) line(placed(points + 2 * i, 2));
}

void DrawingDevice::DrawPoints(float* points, int n, unsigned char*, int) {
  const auto pen = stroke();
  if (!pen) return;
  for (const Point& point : placed(points, n)) drawing_->disc(point, pen->width / 2, Fill{pen->colour}, std::nullopt);
}

void DrawingDevice::DrawMarkers(int, bool, float* points, int n, unsigned char* colors, int components) {
  DrawPoints(points, n, colors, components);
}

void DrawingDevice::DrawQuad(float* points, int n) { DrawPolygon(points, n); }

void DrawingDevice::DrawQuadStrip(float* points, int n) {
  const auto brush = fill();
  if (!brush) return;
  std::vector<Point> first, second;
  for (std::ptrdiff_t i = 0; i + 1 < n; i += 2) {
    first.push_back(placed(points + 2 * i));
    second.push_back(placed(points + 2 * i + 2));
  }
  drawing_->band(first, second, *brush);
}

void DrawingDevice::DrawColoredPolygon(float* points, int n, unsigned char*, int) {
  if (const auto brush = fill()) drawing_->polygon(placed(points, n), brush, std::nullopt);
}

void DrawingDevice::DrawString(float* point, const vtkStdString& text) {
  const TextStyle style = text_style();
  Point at = placed(point);
  (style.upward ? at.x : at.y) -= pixels(TextProp->GetLineOffset());
  drawing_->text(at, text, style);
}

void DrawingDevice::ComputeStringBounds(const vtkStdString& text, float bounds[4]) {
  const TextStyle style = text_style();
  const double size = TextProp->GetFontSize();
  bounds[0] = bounds[1] = 0;
  bounds[2] = static_cast<float>(text_width(text, size, style.bold));
  bounds[3] = static_cast<float>(capital_height * size);
  if (style.upward) std::swap(bounds[2], bounds[3]);
}

void DrawingDevice::ComputeJustifiedStringBounds(const char* text, float bounds[4]) {
  constexpr float share_before[] = {0, 0.5F, 1};
  ComputeStringBounds(vtkStdString(text), bounds);
  const TextStyle style = text_style();
  const float across = share_before[static_cast<int>(style.across)],
              along = share_before[static_cast<int>(style.along)];
  // The base line of what is written upwards is on the right.
  bounds[0] = -bounds[2] * (style.upward ? 1 - along : across);
  bounds[1] = -bounds[3] * (style.upward ? across : along);
}

void DrawingDevice::SetMatrix(vtkMatrix3x3* matrix) { std::copy_n(matrix->GetData(), matrix_.size(), matrix_.begin()); }

void DrawingDevice::GetMatrix(vtkMatrix3x3* matrix) { matrix->DeepCopy(matrix_.data()); }

void DrawingDevice::MultiplyMatrix(vtkMatrix3x3* matrix) {
  Matrix product;
  vtkMatrix3x3::Multiply3x3(matrix_.data(), matrix->GetData(), product.data());
  matrix_ = product;
}

void DrawingDevice::PopMatrix() {
  matrix_ = stack_.back();
  stack_.pop_back();
}

void DrawingDevice::SetClipping(int* box) {
  const double bottom = drawing_->height - pixels(box[1]);
  clip_ = {pixels(box[0]), bottom - pixels(box[3]), pixels(box[0] + box[2]), bottom};
}

void DrawingDevice::EnableClipping(bool enable) {
  if (enable) {
    drawing_->clip(clip_);
  } else {
    drawing_->end_clip();
  }
}

void DrawingDevice::DrawPointSprites(vtkImageData*, float*, int, unsigned char*, int) { refuse("sprites"); }
void DrawingDevice::DrawEllipseWedge(float, float, float, float, float, float, float, float) { refuse("wedges"); }
void DrawingDevice::DrawEllipticArc(float, float, float, float, float, float) { refuse("arcs"); }
void DrawingDevice::DrawString(float*, const vtkUnicodeString&) { refuse("text that is not UTF-8"); }
void DrawingDevice::ComputeStringBounds(const vtkUnicodeString&, float[4]) { refuse("text that is not UTF-8"); }
void DrawingDevice::DrawMathTextString(float*, const vtkStdString&) { refuse("formulas"); }
void DrawingDevice::DrawImage(float[2], float, vtkImageData*) { refuse("images"); }
void DrawingDevice::DrawImage(const vtkRectf&, vtkImageData*) { refuse("images"); }
void DrawingDevice::SetColor4(unsigned char[4]) { refuse("without pen and brush"); }
void DrawingDevice::SetTexture(vtkImageData*, int) { refuse("textures"); }
void DrawingDevice::SetPointSize(float) { refuse("without pen and brush"); }
void DrawingDevice::SetLineWidth(float) { refuse("without pen and brush"); }
void DrawingDevice::SetLineType(int) { refuse("without pen and brush"); }

}  // namespace packstone::viz
