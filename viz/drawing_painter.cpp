#include "viz/drawing_painter.hpp"

#include <algorithm>
#include <cmath>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextDevice2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include "viz/font.hpp"
#include "viz/offscreen.hpp"

namespace packstone::viz {

namespace {

/// Draws marks with VTK, whose y runs up.
class MarkPainter {
 public:
  MarkPainter(vtkContext2D* context, const Drawing& drawing, int scale)
      : context_(context), height_(drawing.height), scale_(scale) {}

  void operator()(const LineMark& mark) {
    apply(mark.stroke);
    for (const auto& piece : dashed(mark.points, mark.stroke.dashes)) {
      if (piece.size() < 2) continue;
      std::vector<float> points = flat(piece);
      context_->DrawPoly(points.data(), static_cast<int>(piece.size()));
    }
  }

  void operator()(const PolygonMark& mark) {
    if (mark.fill) {
      apply(*mark.fill);
      std::vector<float> points = flat(mark.corners);
      context_->DrawPolygon(points.data(), static_cast<int>(mark.corners.size()));
    }
    if (mark.outline) {
      std::vector<Point> ring = mark.corners;
      ring.push_back(ring.front());
      (*this)(LineMark{ring, *mark.outline});
    }
  }

  void operator()(const DiscMark& mark) {
    // So many corners that none is further than this from the circle [px].
    constexpr double tolerance = 0.1;
    constexpr double fewest_corners = 12;
    const double pixels = mark.radius * scale_;
    const double corners = std::ceil(M_PI / std::acos(1 - std::min(1.0, tolerance / std::max(pixels, tolerance))));
    PolygonMark polygon{{}, mark.fill, mark.outline};
    const int count = static_cast<int>(std::max(fewest_corners, corners));
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count;
      polygon.corners.push_back(
          {mark.centre.x + mark.radius * std::cos(angle), mark.centre.y + mark.radius * std::sin(angle)});
    }
    (*this)(polygon);
  }

  void operator()(const BandMark& mark) {
    apply(mark.fill);
    for (std::size_t i = 0; i + 1 < mark.first.size(); ++i) {
      std::vector<float> quad = flat({mark.first[i], mark.first[i + 1], mark.second[i + 1], mark.second[i]});
      context_->DrawQuad(quad.data());
    }
  }

  void operator()(const TextMark& mark);

  void operator()(const ClipMark& mark) {
    vtkContextDevice2D* device = context_->GetDevice();
    device->EnableClipping(mark.box.has_value());
    if (!mark.box) return;
    const Point corner = place({mark.box->left, mark.box->bottom});
    int box[4] = {static_cast<int>(std::lround(corner.x)), static_cast<int>(std::lround(corner.y)),
                  static_cast<int>(std::lround(mark.box->width() * scale_)),
                  static_cast<int>(std::lround(mark.box->height() * scale_))};
    device->SetClipping(box);
  }

 private:
  Point place(Point p) const { return {p.x * scale_, (height_ - p.y) * scale_}; }

  std::vector<float> flat(const std::vector<Point>& points) const {
    std::vector<float> result;
    result.reserve(points.size() * 2);
    for (const Point& p : points) {
      const Point q = place(p);
      result.push_back(static_cast<float>(q.x));
      result.push_back(static_cast<float>(q.y));
    }
    return result;
  }

  void apply(const Stroke& stroke) {
    context_->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    context_->GetPen()->SetColor(stroke.colour.r, stroke.colour.g, stroke.colour.b);
    context_->GetPen()->SetWidth(static_cast<float>(stroke.width * scale_));
  }

  void apply(const Fill& fill) {
    context_->GetPen()->SetLineType(vtkPen::NO_PEN);
    context_->GetBrush()->SetColor(fill.colour.r, fill.colour.g, fill.colour.b);
    context_->GetBrush()->SetOpacityF(fill.opacity);
  }

  vtkContext2D* context_;
  double height_;
  double scale_;
};

void MarkPainter::operator()(const TextMark& mark) {
  const TextStyle& style = mark.style;
  constexpr double upward_angle = 90;
  constexpr double descent = 0.21;  // VTK's text boxes begin this share of the size below the base line
  vtkTextProperty* property = context_->GetTextProp();
  property->SetFontSize(static_cast<int>(std::lround(style.size * scale_)));
  use_font(property, style.bold);
  property->SetColor(style.colour.r / 255.0, style.colour.g / 255.0, style.colour.b / 255.0);
  property->SetOrientation(style.upward ? upward_angle : 0);
  property->SetVerticalJustificationToBottom();
  switch (style.across) {
    case Side::low:
      property->SetJustificationToLeft();
      break;
    case Side::middle:
      property->SetJustificationToCentered();
      break;
    case Side::high:
      property->SetJustificationToRight();
      break;
  }
  const double shift = (baseline_shift(style.along) + descent) * style.size;
  const Point at = place(style.upward ? Point{mark.at.x + shift, mark.at.y} : Point{mark.at.x, mark.at.y + shift});
  context_->DrawString(static_cast<float>(at.x), static_cast<float>(at.y), vtkStdString(mark.text));
}

class DrawingItem : public vtkContextItem {
 public:
  vtkTypeMacro(DrawingItem, vtkContextItem) static DrawingItem* New();

  bool Paint(vtkContext2D* context) override {
    MarkPainter painter(context, *drawing, scale);
    for (const Mark& mark : drawing->marks) std::visit(painter, mark);
    return true;
  }

  const Drawing* drawing = nullptr;
  int scale = 1;
};
vtkStandardNewMacro(DrawingItem);

}  // namespace

struct DrawingPainter::Stage {
  Stage() : window(1, 1) {
    constexpr int dots_per_inch = 72;  // a point of the font is a pixel
    actor->GetScene()->AddItem(item);
    renderer->AddActor(actor);
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    window.window()->SetDPI(dots_per_inch);
    window.window()->AddRenderer(renderer);
    actor->GetScene()->SetRenderer(renderer);
  }

  OffscreenWindow window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  vtkNew<DrawingItem> item;
};

DrawingPainter::DrawingPainter() : stage_(std::make_unique<Stage>()) {}

DrawingPainter::~DrawingPainter() = default;

Layer DrawingPainter::paint(const Drawing& drawing, int supersampling) {
  OffscreenWindow& window = stage_->window;
  stage_->item->drawing = &drawing;
  stage_->item->scale = supersampling;
  window.resize(drawing.width * supersampling, drawing.height * supersampling);
  window.render();
  return average_down(window.rgba().data(), window.width(), window.height(), supersampling, Rows::bottom_first);
}

Image draw_image(const Drawing& drawing, int supersampling) {
  const Layer layer = DrawingPainter().paint(drawing, supersampling);
  return flatten({&layer}, paper);
}

}  // namespace packstone::viz
