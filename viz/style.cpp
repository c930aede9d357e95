#include "viz/style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace packstone::viz {

namespace {

constexpr Colour orange = {230, 159, 0};
constexpr Colour blue = {0, 114, 178};
constexpr Colour yellow = {240, 228, 66};
constexpr Colour vermillion = {213, 94, 0};
constexpr Colour sky = {86, 180, 233};
constexpr Colour green = {0, 158, 115};
constexpr Colour purple = {204, 121, 167};
constexpr Colour black = {51, 51, 51};

constexpr std::array categories = {orange, blue, yellow, vermillion, sky, black, purple, green};
constexpr std::array lines = {blue, vermillion, green, purple, orange, sky, black};

// Ten evenly spaced colours of matplotlib's maps (CC0), linear between them.
using Shades = std::array<Colour, 10>;
constexpr Shades viridis = {{{68, 1, 84},
                             {72, 40, 120},
                             {62, 74, 137},
                             {49, 104, 142},
                             {38, 130, 142},
                             {31, 158, 137},
                             {53, 183, 121},
                             {109, 205, 89},
                             {180, 222, 44},
                             {253, 231, 37}}};
constexpr Shades plasma = {{{13, 8, 135},
                            {70, 3, 159},
                            {114, 1, 168},
                            {156, 23, 158},
                            {189, 55, 134},
                            {216, 87, 107},
                            {237, 121, 83},
                            {251, 159, 58},
                            {253, 202, 38},
                            {240, 249, 33}}};

constexpr double font_share = 0.022;  ///< of the picture's mean side: 8 pt where 1920 px are printed 17 cm wide
constexpr double smallest_font = 9;   ///< [px] still readable

std::uint8_t between(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

}  // namespace

Colour themed(Colour colour, Ground ground) {
  constexpr std::array<std::pair<Colour, Colour>, 6> on_dark = {{{paper, {22, 24, 29}},
                                                                 {ink, {235, 235, 235}},
                                                                 {faint_ink, {120, 122, 126}},
                                                                 {grid_line, {52, 55, 61}},
                                                                 {plate_fill, {58, 61, 68}},
                                                                 {wall_edge, {160, 162, 166}}}};
  if (ground == Ground::white) return colour;
  const auto found =
      std::find_if(on_dark.begin(), on_dark.end(), [&](const auto& pair) { return pair.first == colour; });
  return found == on_dark.end() ? colour : found->second;
}

Colour category_colour(std::size_t index) { return categories[index % categories.size()]; }

Colour line_colour(std::size_t index) { return lines[index % lines.size()]; }

std::size_t line_round(std::size_t index) { return index / lines.size(); }

Colour sequential_colour(double t, ColourMap map) {
  if (std::isnan(t)) return no_value;
  const Shades& shades = map == ColourMap::viridis ? viridis : plasma;
  const double place = std::clamp(t, 0.0, 1.0) * (shades.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), shades.size() - 2);
  const double share = place - static_cast<double>(low);
  const Colour& a = shades[low];
  const Colour& b = shades[low + 1];
  return {between(a.r, b.r, share), between(a.g, b.g, share), between(a.b, b.b, share)};
}

double font_size(int width, int height) {
  return std::max(smallest_font, font_share * std::sqrt(static_cast<double>(width) * height));
}

}  // namespace packstone::viz
