#include "viz/legend.hpp"

#include <algorithm>

#include "viz/font.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

// All as multiples of the font size.
constexpr double line_height = 1.6;
constexpr double swatch_radius = 0.45;
constexpr double swatch_room = 1.4;  ///< from the left edge to the name
constexpr double bar_width = 1.1;
constexpr double bar_height = 14;
constexpr double tick_length = 0.3;
constexpr double label_gap = 0.3;
constexpr double line_weight = 0.06;
constexpr int bar_ticks = 5;
constexpr int bar_shades = 128;

/// As many as have room on a bar of that height, in font sizes.
Ticks bar_scale(const ColourKey& key, double height) {
  constexpr double room = 2;
  const int ticks = std::clamp(static_cast<int>(height / room), 1, bar_ticks);
  return linear_ticks(key.range->first, key.range->second, ticks);
}

void draw_bar(Drawing& drawing, const Box& bar, const ColourKey& key, const Ticks& ticks, double font) {
  for (int i = 0; i < bar_shades; ++i) {
    // Each shade reaches to the bar's end under the next, so that no seam can show.
    const double top = bar.bottom - bar.height() * (i + 1) / bar_shades;
    const double bottom = bar.bottom - bar.height() * i / bar_shades;
    drawing.rectangle({bar.left, top, bar.right, i == 0 ? bottom : bottom + bar.height() / bar_shades / 2},
                      Fill{sequential_colour((i + 0.5) / bar_shades, key.map)}, std::nullopt);
  }
  drawing.rectangle(bar, std::nullopt, Stroke{ink, font * line_weight, {}});
  const auto [low, high] = *key.range;
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = bar.bottom - bar.height() * (ticks.values[i] - low) / (high - low);
    drawing.line({bar.right, y}, {bar.right + tick_length * font, y}, Stroke{ink, font * line_weight, {}});
    drawing.text({bar.right + (tick_length + label_gap) * font, y}, ticks.labels[i],
                 {.size = font, .along = Side::middle});
  }
}

}  // namespace

double legend_width(const ColourKey& key, double font) {
  if (key.range) {
    const Ticks ticks = bar_scale(key, bar_height);
    double label = 0;
    for (const std::string& text : ticks.labels) label = std::max(label, text_width(text, font));
    const double title = text_width(with_exponent(key.title, ticks.exponent), font);
    return std::max(title, (bar_width + tick_length + label_gap) * font + label);
  }
  double width = key.title.empty() ? 0 : text_width(key.title, font);
  for (const LegendEntry& entry : key.entries) {
    width = std::max(width, swatch_room * font + text_width(entry.name, font));
  }
  return width;
}

double draw_legend(Drawing& drawing, const Box& column, const ColourKey& key, double font) {
  double y = column.top;
  const double line = key.title.empty() ? 0 : line_height * font;
  const double bottom = std::min(y + line + bar_height * font, column.bottom);
  std::optional<Ticks> ticks;
  if (key.range) ticks = bar_scale(key, (bottom - y - line) / font);
  if (!key.title.empty()) {
    const std::string title = ticks ? with_exponent(key.title, ticks->exponent) : key.title;
    drawing.text({column.left, y}, title, {.size = font, .along = Side::high});
    y += line;
  }
  if (ticks) {
    draw_bar(drawing, {column.left, y, column.left + bar_width * font, bottom}, key, *ticks, font);
    return bottom;
  }
  for (const LegendEntry& entry : key.entries) {
    const double middle = y + capital_height / 2 * font;
    drawing.disc({column.left + swatch_radius * font, middle}, swatch_radius * font, Fill{entry.colour}, std::nullopt);
    drawing.text({column.left + swatch_room * font, middle}, entry.name, {.size = font, .along = Side::middle});
    y += line_height * font;
  }
  return y;
}

void draw_scale_bar(Drawing& drawing, Point lower_left, double metres_per_pixel, double room, double font) {
  constexpr double thickness = 0.22;
  constexpr double text_gap = 0.35;
  const double length = round_below(room * metres_per_pixel);
  const double right = lower_left.x + length / metres_per_pixel;
  const double top = lower_left.y - thickness * font;
  drawing.rectangle({lower_left.x, top, right, lower_left.y}, Fill{ink}, std::nullopt);
  drawing.text({(lower_left.x + right) / 2, top - text_gap * font}, length_text(length),
               {.size = font, .across = Side::middle});
}

}  // namespace packstone::viz
