#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>
#include <vtkTransform2D.h>

#include "viz/drawing_device.hpp"
#include "viz/font.hpp"

using namespace packstone::viz;

namespace {

constexpr int sheet_height = 100;
constexpr auto in_units = [](double pixels) { return DrawingDevice::units(pixels); };

/// Paints as VTK's charts do.
struct Painting {
  Drawing drawing{200, sheet_height, {}};
  vtkNew<DrawingDevice> device;
  vtkNew<vtkContext2D> painter;

  Painting() {
    device->record_into(drawing);
    painter->Begin(device);
    painter->GetPen()->SetWidth(in_units(2));
    painter->GetPen()->SetColor(10, 20, 30);
    painter->GetTextProp()->SetFontSize(static_cast<int>(in_units(20)));
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
  }

  template <class Kind>
  Kind last() const {
    REQUIRE(!drawing.marks.empty());
    REQUIRE(std::holds_alternative<Kind>(drawing.marks.back()));
    return std::get<Kind>(drawing.marks.back());
  }

  LineMark line() {
    painter->DrawLine(0, 0, in_units(10), in_units(30));
    return last<LineMark>();
  }

  Box justified(const char* text) {
    float bounds[4];
    painter->ComputeJustifiedStringBounds(text, bounds);
    constexpr double pixel = DrawingDevice::units_per_pixel;
    return {bounds[0] / pixel, bounds[1] / pixel, (bounds[0] + bounds[2]) / pixel, (bounds[1] + bounds[3]) / pixel};
  }
};

}  // namespace

TEST_CASE("lines have the pen's colour and width, and y runs upwards") {
  Painting painting;
  const LineMark line = painting.line();
  CHECK(line.points == std::vector<Point>{{0, sheet_height}, {10, sheet_height - 30}});
  CHECK(line.stroke == Stroke{{10, 20, 30}, 2, {}});
}

TEST_CASE("each type of line has dashes of its own, in widths of the pen") {
  Painting painting;
  std::vector<std::vector<double>> patterns = {{}};
  for (const int type : {vtkPen::DASH_LINE, vtkPen::DOT_LINE, vtkPen::DASH_DOT_LINE, vtkPen::DASH_DOT_DOT_LINE,
                         vtkPen::DENSE_DOT_LINE}) {
    painting.painter->GetPen()->SetLineType(type);
    painting.painter->GetPen()->SetWidth(in_units(2));
    const auto dashes = painting.line().stroke.dashes;
    CHECK(dashes.size() % 2 == 0);
    CHECK(std::find(patterns.begin(), patterns.end(), dashes) == patterns.end());
    patterns.push_back(dashes);
    painting.painter->GetPen()->SetWidth(in_units(4));
    CHECK(painting.line().stroke.dashes[0] == Approx(2 * dashes[0]));
  }
}

TEST_CASE("without a pen or without opacity nothing is drawn") {
  Painting painting;
  painting.painter->GetBrush()->SetOpacity(0);
  SECTION("no pen") { painting.painter->GetPen()->SetLineType(vtkPen::NO_PEN); }
  SECTION("a pen that does not cover") { painting.painter->GetPen()->SetOpacity(0); }
  painting.painter->DrawLine(0, 0, 1, 1);
  painting.painter->DrawRect(0, 0, 1, 1);
  painting.painter->DrawPoint(0, 0);
  CHECK(painting.drawing.marks.empty());
}

TEST_CASE("pairs of points are lines of their own") {
  Painting painting;
  float points[] = {0, 0, 64, 0, 64, 64, 0, 64};
  painting.painter->DrawLines(points, 4);
  REQUIRE(painting.drawing.marks.size() == 2);
  CHECK(painting.last<LineMark>().points == std::vector<Point>{{1, sheet_height - 1}, {0, sheet_height - 1}});
}

TEST_CASE("areas have the brush's colour and opacity") {
  Painting painting;
  painting.painter->GetBrush()->SetColor(1, 2, 3, 51);
  painting.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painting.painter->DrawRect(in_units(1), in_units(2), in_units(3), in_units(4));
  const PolygonMark rectangle = painting.last<PolygonMark>();
  CHECK(rectangle.corners == std::vector<Point>{{1, 98}, {4, 98}, {4, 94}, {1, 94}});
  REQUIRE(rectangle.fill);
  CHECK(rectangle.fill->colour == Colour{1, 2, 3});
  CHECK(rectangle.fill->opacity == Approx(0.2));

  float strip[] = {0, 0, 0, 64, 128, 0, 128, 192};
  painting.painter->DrawQuadStrip(strip, 4);
  const BandMark band = painting.last<BandMark>();
  CHECK(band.first == std::vector<Point>{{0, 100}, {2, 100}});
  CHECK(band.second == std::vector<Point>{{0, 99}, {2, 97}});
}

TEST_CASE("markers are discs as wide as the pen") {
  Painting painting;
  float points[] = {64, 64};
  painting.painter->DrawMarkers(VTK_MARKER_CIRCLE, false, points, 1);
  CHECK(painting.last<DiscMark>() == DiscMark{{1, sheet_height - 1}, 1, Fill{{10, 20, 30}}, std::nullopt});
}

TEST_CASE("text has the bounds of our font, and stands where its justification says") {
  Painting painting;
  vtkTextProperty* style = painting.painter->GetTextProp();
  const double width = text_width("10\u207b\u2075", 20), tall = capital_height * 20;
  constexpr double tolerance = 0.01;  // [px]
  const auto check = [&](Box expected) {
    const Box box = painting.justified("10\u207b\u2075");
    CHECK(box.left == Approx(expected.left).margin(tolerance));
    CHECK(box.top == Approx(expected.top).margin(tolerance));
    CHECK(box.right == Approx(expected.right).margin(tolerance));
    CHECK(box.bottom == Approx(expected.bottom).margin(tolerance));
  };
  SECTION("to the right of its point") { check({0, 0, width, tall}); }
  SECTION("left of and below it") {
    style->SetJustificationToRight();
    style->SetVerticalJustificationToTop();
    check({-width, -tall, 0, 0});
  }
  SECTION("upwards, its base line at the point") {
    style->SetOrientation(90);
    style->SetJustificationToCentered();
    check({-tall, -width / 2, 0, width / 2});
  }
  SECTION("upwards, its capitals' top at the point") {
    style->SetOrientation(90);
    style->SetVerticalJustificationToTop();
    check({0, 0, tall, width});
  }
}

TEST_CASE("text keeps its style") {
  Painting painting;
  vtkTextProperty* style = painting.painter->GetTextProp();
  style->SetColor(1, 0.2, 0);
  style->SetBold(1);
  style->SetJustificationToCentered();
  style->SetVerticalJustificationToTop();
  painting.painter->DrawString(in_units(50), in_units(40), "Zeit");
  const TextMark text = painting.last<TextMark>();
  CHECK(text.text == "Zeit");
  CHECK(text.at == Point{50, 60});
  CHECK(text.style == TextStyle{20, {255, 51, 0}, Side::middle, Side::high, false, true});

  SECTION("its line offset raises it") {
    style->SetLineOffset(in_units(5));
    painting.painter->DrawString(in_units(50), in_units(40), "Zeit");
    CHECK(painting.last<TextMark>().at == Point{50, 55});
  }
  SECTION("to the left where it is written upwards") {
    style->SetLineOffset(in_units(5));
    style->SetOrientation(90);
    painting.painter->DrawString(in_units(50), in_units(40), "Zeit");
    CHECK(painting.last<TextMark>().at == Point{45, 60});
    CHECK(painting.last<TextMark>().style.upward);
  }
}

TEST_CASE("clipping is to the box, until it is disabled") {
  Painting painting;
  int box[] = {64, 128, 640, 320};
  painting.device->SetClipping(box);
  CHECK(painting.drawing.marks.empty());
  painting.device->EnableClipping(true);
  CHECK(painting.last<ClipMark>().corners == std::vector<Point>{{1, 93}, {11, 93}, {11, 98}, {1, 98}});
  painting.device->EnableClipping(false);
  CHECK(painting.last<ClipMark>().corners.empty());
}

TEST_CASE("transforms apply to what is within them, and stack") {
  Painting painting;
  vtkNew<vtkTransform2D> shift, stretch;
  shift->Translate(in_units(5), in_units(7));
  stretch->Scale(2, 3);
  painting.painter->PushMatrix();
  painting.painter->AppendTransform(shift);
  CHECK(painting.line().points == std::vector<Point>{{5, 93}, {15, 63}});
  painting.painter->PushMatrix();
  painting.painter->AppendTransform(stretch);
  CHECK(painting.line().points == std::vector<Point>{{5, 93}, {25, 3}});
  CHECK(painting.line().stroke.width == Approx(2));  // a pen is as wide everywhere
  painting.painter->PopMatrix();
  CHECK(painting.line().points == std::vector<Point>{{5, 93}, {15, 63}});
  painting.painter->PopMatrix();
  CHECK(painting.line().points == std::vector<Point>{{0, 100}, {10, 70}});
  painting.painter->SetTransform(stretch);
  CHECK(painting.line().points == std::vector<Point>{{0, 100}, {20, 10}});
  CHECK(painting.painter->GetTransform()->GetMatrix()->GetElement(1, 1) == Approx(3));
}

TEST_CASE("what charts do not use is refused") {
  Painting painting;
  CHECK_THROWS_AS(painting.painter->DrawArc(0, 0, 1, 0, 90), std::logic_error);
  CHECK_THROWS_AS(painting.painter->DrawMathTextString(0.F, 0.F, "x"), std::logic_error);
}
