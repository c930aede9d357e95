// A flat picture as a list of marks: charts, slices, legends. Drawn once, then turned into pixels (drawing_painter.hpp)
// or SVG (svg.hpp). Lengths are pixels of the finished picture; x runs to the right, y down.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "viz/style.hpp"

namespace packstone::viz {

struct Point {
  double x = 0;
  double y = 0;

  bool operator==(const Point&) const = default;
};

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Point centre() const { return {(left + right) / 2, (top + bottom) / 2}; }

  bool operator==(const Box&) const = default;
};

struct Stroke {
  Colour colour = ink;
  double width = 1;
  std::vector<double> dashes;  ///< lengths drawn and left out in turn; empty for a solid line

  bool operator==(const Stroke&) const = default;
};

struct Fill {
  Colour colour;
  double opacity = 1;

  bool operator==(const Fill&) const = default;
};

/// An open line.
struct LineMark {
  std::vector<Point> points;
  Stroke stroke;

  bool operator==(const LineMark&) const = default;
};

/// A convex polygon.
struct PolygonMark {
  std::vector<Point> corners;
  std::optional<Fill> fill;
  std::optional<Stroke> outline;

  bool operator==(const PolygonMark&) const = default;
};

struct DiscMark {
  Point centre;
  double radius = 0;
  Fill fill;
  std::optional<Stroke> outline;

  bool operator==(const DiscMark&) const = default;
};

/// The area between two lines of equally many points.
struct BandMark {
  std::vector<Point> first;
  std::vector<Point> second;
  Fill fill;

  bool operator==(const BandMark&) const = default;
};

enum class Side { low, middle, high };

struct TextStyle {
  double size = 12;
  Colour colour = ink;
  Side across = Side::low;  ///< which end of the text lies at the point, along the line of writing
  Side along = Side::low;   ///< low: the base line is at the point; high: the capitals' top is
  bool upward = false;      ///< written from bottom to top
  bool bold = false;

  bool operator==(const TextStyle&) const = default;
};

struct TextMark {
  Point at;
  std::string text;  ///< UTF-8, one line
  TextStyle style;

  bool operator==(const TextMark&) const = default;
};

/// From here on nothing is drawn outside the convex polygon; without corners everything is again.
struct ClipMark {
  std::vector<Point> corners;

  bool operator==(const ClipMark&) const = default;
};

using Mark = std::variant<LineMark, PolygonMark, DiscMark, BandMark, TextMark, ClipMark>;

/// What a drawing takes on paper.
struct PaperSize {
  double width_mm = 0;
  double height_mm = 0;
  double dots_per_inch = 0;  ///< pixels of the drawing to an inch

  bool operator==(const PaperSize&) const = default;
};

/// The marks in the order they are drawn.
struct Drawing {
  int width = 0;
  int height = 0;
  std::vector<Mark> marks;
  std::optional<PaperSize> paper_size = std::nullopt;  ///< where it is made for paper (print_size.hpp)
  Colour ground = paper;

  void line(Point from, Point to, const Stroke& stroke) { polyline({from, to}, stroke); }
  void polyline(const std::vector<Point>& points, const Stroke& stroke);
  void rectangle(const Box& box, std::optional<Fill> fill, const std::optional<Stroke>& outline);
  void polygon(const std::vector<Point>& corners, std::optional<Fill> fill, const std::optional<Stroke>& outline);
  void disc(Point centre, double radius, Fill fill, const std::optional<Stroke>& outline);
  void band(const std::vector<Point>& first, const std::vector<Point>& second, Fill fill);
  /// Nothing where the text is empty.
  void text(Point at, const std::string& text, TextStyle style);
  void clip(const std::vector<Point>& corners);
  void clip(const Box& box);
  void end_clip();

  bool operator==(const Drawing&) const = default;
};

/// The same marks on another ground than white.
Drawing themed(Drawing drawing, Ground ground);

/// Width of a line of text [px].
double text_width(const std::string& text, double size, bool bold = false);

/// How far below the point the base line of a text lies, as a share of its size.
double baseline_shift(Side along);

/// The pieces of a line that a dash pattern draws; the whole line when the pattern is empty.
std::vector<std::vector<Point>> dashed(const std::vector<Point>& line, const std::vector<double>& dashes);

}  // namespace packstone::viz
