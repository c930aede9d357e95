#include "viz/plot_frame.hpp"

#include <algorithm>
#include <cmath>

#include "viz/font.hpp"

namespace packstone::viz {

namespace {

using namespace axis_measure;

// As multiples of the font size.
constexpr double room_per_x_tick = 4.5;
constexpr double room_per_y_tick = 3.2;

Ticks ticks_of(const AxisScale& scale, double length, double room) {
  const int count = std::max(2, static_cast<int>(length / room));
  return scale.logarithmic ? logarithmic_ticks(scale.low, scale.high, count)
                           : linear_ticks(scale.low, scale.high, count);
}

Ticks ticks_upwards(const AxisScale& y, double height, double font) {
  return ticks_of(y, height, room_per_y_tick * font);
}

double widest(const std::vector<std::string>& labels, double font) {
  double width = 0;
  for (const std::string& label : labels) width = std::max(width, text_width(label, font));
  return width;
}

}  // namespace

double AxisScale::share(double value) const {
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

Point PlotFrame::place(double x_value, double y_value) const {
  return {box.left + x.share(x_value) * box.width(), box.bottom - y.share(y_value) * box.height()};
}

double left_room(const AxisScale& y, double height, double font) {
  return widest(ticks_upwards(y, height, font).labels, font) + (tick_length + number_gap + label_gap + 1) * font;
}

double lower_room(double font) { return (tick_length + number_gap + capital_height + label_gap + 1) * font; }

Ticks x_ticks(const PlotFrame& frame) { return ticks_of(frame.x, frame.box.width(), room_per_x_tick * frame.font); }

Ticks y_ticks(const PlotFrame& frame) { return ticks_upwards(frame.y, frame.box.height(), frame.font); }

void draw_axes(Drawing& drawing, const PlotFrame& frame) {
  const double font = frame.font;
  const Stroke stroke{ink, line_weight * font, {}};
  const Box& box = frame.box;
  drawing.rectangle(box, std::nullopt, stroke);
  const Ticks across = x_ticks(frame);
  for (std::size_t i = 0; i < across.values.size(); ++i) {
    const double x = frame.place(across.values[i], frame.y.low).x;
    drawing.line({x, box.bottom}, {x, box.bottom + tick_length * font}, stroke);
    drawing.text({x, box.bottom + (tick_length + number_gap) * font}, across.labels[i],
                 {.size = font, .across = Side::middle, .along = Side::high});
  }
  const Ticks up = y_ticks(frame);
  for (std::size_t i = 0; i < up.values.size(); ++i) {
    const double y = frame.place(frame.x.low, up.values[i]).y;
    drawing.line({box.left - tick_length * font, y}, {box.left, y}, stroke);
    drawing.text({box.left - (tick_length + number_gap) * font, y}, up.labels[i],
                 {.size = font, .across = Side::high, .along = Side::middle});
  }
  const double below = (tick_length + number_gap + capital_height + label_gap) * font;
  drawing.text({box.centre().x, box.bottom + below}, with_exponent(frame.x_label, across.exponent),
               {.size = font, .across = Side::middle, .along = Side::high});
  const double beside = (tick_length + number_gap + label_gap) * font + widest(up.labels, font);
  drawing.text({box.left - beside, box.centre().y}, with_exponent(frame.y_label, up.exponent),
               {.size = font, .across = Side::middle, .upward = true});
}

}  // namespace packstone::viz
