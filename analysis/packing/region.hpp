// Regions of space whose solid volume is known exactly: boxes, spheres, upright rings.
#pragma once

#include <string>
#include <variant>

#include "core/domain.hpp"
#include "core/vec3.hpp"

namespace packstone::analysis {

/// Axis-aligned [m].
struct BoxRegion {
  Vec3 min;
  Vec3 max;
};

struct SphereRegion {
  Vec3 centre;    ///< [m]
  double radius;  ///< [m]
};

/// Between two cylinders about the same line along an axis, and two heights; a cylinder where the inner radius is 0.
struct RingRegion {
  int axis;
  Vec3 centre;  ///< a point of the line; its coordinate along the axis does not matter [m]
  double inner, outer;
  double lower, upper;  ///< coordinates along the axis [m]
};

using RegionShape = std::variant<BoxRegion, SphereRegion, RingRegion>;

/// A region as the user names it.
struct NamedRegion {
  std::string text;
  RegionShape shape;
};

/// [m3]
double region_volume(const RegionShape& region);

/// Exact volume of the part of a sphere in the region, without periodic images [m3].
double volume_in_region(const RegionShape& region, const Vec3& centre, double radius);

bool contains(const RegionShape& region, const Vec3& point);

/// The smallest box about the region.
BoxRegion bounds(const RegionShape& region);

/// The same box or ring between other coordinates along an axis, which is the ring's own.
RegionShape between(RegionShape region, int axis, double lower, double upper);

/// Reads "box:x0,y0,z0,x1,y1,z1", "slab:AXIS,lower,upper", "sphere:x,y,z,radius",
/// "cylinder:AXIS,u,v,lower,upper,radius" or "ring:AXIS,u,v,lower,upper,inner,outer", where u and v are the axis' other
/// two coordinates in the order x, y, z. Lengths in m, or with a unit of their own ("5 mm"). A slab is a box without
/// end. Throws InputError that says what is wrong and what is expected.
NamedRegion parse_region(const std::string& text);

/// The region without what lies outside of the domain along axes that are not periodic.
/// Throws InputError where nothing is left, where a round side would be cut, and where the region is longer than the
/// domain along a periodic axis, so that it would meet itself (a slab is taken as long as the domain).
RegionShape clipped(const NamedRegion& region, const Domain& domain);

}  // namespace packstone::analysis
