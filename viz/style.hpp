// Colours and sizes that all pictures share: safe for colour-blind readers and for grey print, on white paper.
#pragma once

#include <cstddef>
#include <cstdint>

namespace packstone::viz {

struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  bool operator==(const Colour&) const = default;
};

inline constexpr Colour paper = {255, 255, 255};
inline constexpr Colour ink = {34, 34, 34};            ///< text, axes
inline constexpr Colour faint_ink = {150, 150, 150};   ///< periodic sides
inline constexpr Colour grid_line = {228, 228, 228};   ///< of charts
inline constexpr Colour plate_fill = {232, 232, 232};  ///< walls that lie behind the particles
inline constexpr Colour wall_edge = {110, 110, 110};   ///< walls in outline, and cut
inline constexpr Colour no_value = {190, 190, 190};    ///< particles whose value is not a number

inline constexpr Colour offending = {213, 94, 0};  ///< particles because of which a run was stopped
inline constexpr Colour touching = {0, 114, 178};  ///< those in contact with one

/// What pictures stand on: paper, or dark for slides.
enum class Ground { white, dark };

/// The colour of the same use on another ground: of paper, ink, walls and lines; any other colour stays.
Colour themed(Colour colour, Ground ground);

/// Fill colour of a category, Okabe and Ito's set (https://jfly.uni-koeln.de/color/) in an order whose neighbours also
/// differ in grey. Begins anew after the last.
Colour category_colour(std::size_t index);

/// The same set for lines: without those too light on white.
Colour line_colour(std::size_t index);
/// Lines of the same colour differ by their round through the set: 0 for the first.
std::size_t line_round(std::size_t index);

/// From dark blue to yellow, both even in lightness: viridis for particles, plasma, by way of red, for what is drawn
/// among them.
enum class ColourMap { viridis, plasma };

/// The map's colour at t, 0 dark to 1 light; t outside is clamped, NaN gives no_value.
Colour sequential_colour(double t, ColourMap map = ColourMap::viridis);

/// White around charts and slices, as a multiple of the font size.
inline constexpr double usual_margin = 1.2;
/// On paper, where the page has its own: room for half a number at the upper end of an axis.
inline constexpr double print_margin = 0.5;

/// Height of the letters' body for a picture of this size [px].
double font_size(int width, int height);

}  // namespace packstone::viz
