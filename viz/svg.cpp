#include "viz/svg.hpp"

#include <iterator>

#include <fmt/format.h>

#include "viz/font.hpp"

namespace packstone::viz {

namespace {

std::string hex(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

std::string coordinates(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points) text += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
  if (!text.empty()) text.pop_back();
  return text;
}

std::string fill_text(const std::optional<Fill>& fill) {
  if (!fill) return "fill='none'";
  if (fill->opacity == 1) return fmt::format("fill='{}'", hex(fill->colour));
  return fmt::format("fill='{}' fill-opacity='{:.3g}'", hex(fill->colour), fill->opacity);
}

std::string stroke_text(const std::optional<Stroke>& stroke) {
  if (!stroke) return "";
  std::string text = fmt::format(" stroke='{}' stroke-width='{:.3g}'", hex(stroke->colour), stroke->width);
  if (!stroke->dashes.empty()) {
    text += " stroke-dasharray='";
    for (const double dash : stroke->dashes) text += fmt::format("{:.3g} ", dash);
    text.back() = '\'';
  }
  return text;
}

std::string size_text(const Drawing& drawing) {
  if (!drawing.paper_size) return fmt::format("width='{}' height='{}'", drawing.width, drawing.height);
  return fmt::format("width='{:g}mm' height='{:g}mm'", drawing.paper_size->width_mm, drawing.paper_size->height_mm);
}

/// One element a mark.
class Writer {
 public:
  explicit Writer(std::string& out) : out_(out) {}

  void operator()(const LineMark& mark) {
    add("<polyline points='{}' fill='none'{} stroke-linejoin='round'/>", coordinates(mark.points),
        stroke_text(mark.stroke));
  }

  void operator()(const PolygonMark& mark) {
    add("<polygon points='{}' {}{}/>", coordinates(mark.corners), fill_text(mark.fill), stroke_text(mark.outline));
  }

  void operator()(const DiscMark& mark) {
    add("<circle cx='{:.3f}' cy='{:.3f}' r='{:.3f}' {}{}/>", mark.centre.x, mark.centre.y, mark.radius,
        fill_text(mark.fill), stroke_text(mark.outline));
  }

  void operator()(const BandMark& mark) {
    std::vector<Point> ring = mark.first;
    ring.insert(ring.end(), mark.second.rbegin(), mark.second.rend());
    add("<polygon points='{}' {}/>", coordinates(ring), fill_text(mark.fill));
  }

  void operator()(const TextMark& mark) {
    constexpr const char* anchors[] = {"start", "middle", "end"};
    const TextStyle& style = mark.style;
    const double shift = baseline_shift(style.along) * style.size;
    const Point at = style.upward ? Point{mark.at.x + shift, mark.at.y} : Point{mark.at.x, mark.at.y + shift};
    const std::string turn = style.upward ? fmt::format(" transform='rotate(-90 {:.2f} {:.2f})'", at.x, at.y) : "";
    add("<text x='{:.2f}' y='{:.2f}' font-size='{:.2f}' text-anchor='{}' fill='{}'{}{}>{}</text>", at.x, at.y,
        style.size, anchors[static_cast<int>(style.across)], hex(style.colour), style.bold ? " font-weight='bold'" : "",
        turn, escaped(mark.text));
  }

  void operator()(const ClipMark& mark) {
    if (clipping_) add("</g>");
    clipping_ = !mark.corners.empty();
    if (!clipping_) return;
    ++clips_;
    add("<clipPath id='clip{}'><polygon points='{}'/></clipPath>", clips_, coordinates(mark.corners));
    add("<g clip-path='url(#clip{})'>", clips_);
  }

  void finish() { (*this)(ClipMark{}); }

 private:
  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    out_ += fmt::format(form, std::forward<Arguments>(arguments)...);
    out_ += '\n';
  }

  std::string& out_;
  bool clipping_ = false;
  int clips_ = 0;
};

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if (byte >= 0x20 || c == '\n' || c == '\t') result += c;
    }
  }
  return result;
}

std::string svg_text(const Drawing& drawing, const std::string& title) {
  std::string out = fmt::format(
      "<?xml version='1.0' encoding='UTF-8'?>\n"
      "<svg xmlns='http://www.w3.org/2000/svg' {0} viewBox='0 0 {1} {2}' font-family='{3}'>\n",
      size_text(drawing), drawing.width, drawing.height, font_names);
  if (!title.empty()) out += fmt::format("<title>{}</title>\n", escaped(title));
  out += fmt::format("<rect width='100%' height='100%' fill='{}'/>\n", hex(drawing.ground));
  Writer writer(out);
  for (const Mark& mark : drawing.marks) std::visit(writer, mark);
  writer.finish();
  return out + "</svg>\n";
}

}  // namespace packstone::viz
