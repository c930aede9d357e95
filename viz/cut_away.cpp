#include "viz/cut_away.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"

namespace packstone::viz {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

HalfSpace half_space(const std::string& text, const std::string& whole) {
  const std::string condition = trimmed(text);
  const std::size_t sign = condition.find_first_of("<>");
  const std::string axis = sign == std::string::npos ? "" : trimmed(condition.substr(0, sign));
  if (axis != "x" && axis != "y" && axis != "z") {
    throw InputError(fmt::format("'{}' does not say what to cut away; 'x>0.3' or 'x>300 mm,y<0.2' would", whole));
  }
  return {axis[0] - 'x', condition[sign] == '>', parse_quantity(trimmed(condition.substr(sign + 1)), unit::metre)};
}

}  // namespace

CutAway cut_from_text(const std::string& text) {
  CutAway cut;
  for (std::size_t first = 0, comma = 0; !text.empty() && comma != std::string::npos; first = comma + 1) {
    comma = text.find(',', first);
    cut.push_back(half_space(text.substr(first, comma - first), text));
  }
  return cut;
}

bool is_cut_away(const CutAway& cut, const Vec3& centre) {
  return !cut.empty() && std::all_of(cut.begin(), cut.end(), [&](const HalfSpace& half) { return half.holds(centre); });
}

bool is_cut_away(const CutAway& cut, const Region& box) {
  return is_cut_away(cut, box.min) && is_cut_away(cut, box.max);  // the planes are across the axes
}

// Beside an edge of a corner that it does not reach, a sphere may count as cut in part; its rays then find it whole.
CutShare cut_share(const CutAway& cut, const Vec3& centre, double radius) {
  CutShare share = cut.empty() ? CutShare::none : CutShare::all;
  for (const HalfSpace& half : cut) {
    const double inside = (half.above ? 1 : -1) * (centre[half.axis] - half.place);
    if (inside <= -radius) return CutShare::none;
    if (inside < radius) share = CutShare::part;
  }
  return share;
}

}  // namespace packstone::viz
