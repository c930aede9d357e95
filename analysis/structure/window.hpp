// The part of a packing that can be taken as homogeneous: a box inside the bed.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "analysis/context.hpp"

namespace packstone::analysis {

/// An axis-aligned box, closed on itself along some axes.
struct Window {
  Vec3 min, max;  ///< [m]
  std::array<bool, 3> periodic = {};

  Vec3 size() const { return max - min; }
  double volume() const { return size().prod(); }
  bool contains(const Vec3& p) const { return (p.array() >= min.array() && p.array() <= max.array()).all(); }
};

/// A window, or why there is none.
struct WindowOrReason {
  std::optional<Window> window;
  std::string reason;
};

/// Along up the bulk, 10 % to 80 % of the bed's height; across it the domain, cut by upright planes, and where other
/// boundaries stand in that box or a slanted plane cuts it, shrunk towards its centre until none does (in a cylinder:
/// the box inscribed). All of a side that is periodic, unless a boundary is in the way;
/// where the box is shrunk, both sides across up lose their images. The sides across up that are
/// not periodic are then moved inwards by the inset [m].
WindowOrReason bulk_window(const Snapshot& snapshot, const Context& context, double inset);

/// In words, for definitions.
inline constexpr const char* window_definition =
    "the bulk's window (10 % to 80 % of the bed's height, across it the domain as far as upright planes and shrunk to "
    "the largest box about its centre that holds no other boundary; the whole domain along periodic axes)";

}  // namespace packstone::analysis
