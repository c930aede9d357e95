// Exact volumes that a sphere shares with boxes and cylinders. Half spaces and slabs: core/geometry.hpp; other spheres:
// lens.hpp.
#pragma once

#include "core/vec3.hpp"

namespace packstone::analysis {

/// Volume of the part of a sphere about the origin where x < corner.x, y < corner.y and z < corner.z [m3]; coordinates
/// may be infinite. radius [m], 0 gives 0. Exact within 1e-14 of the sphere's volume, at tangencies too.
///
/// Divergence theorem on the part beyond three planes at distances a, b, c >= 0 of the unit sphere's centre, its
/// surface by Gauss and Bonnet's theorem (own derivation; the same volume in Strobl, Formella, Poeschel, J. Comput.
/// Phys. 311 (2016) 158):
///   V = 1/3 [sum over pairs (atan(q_ab / ab) + ab q_ab) - pi - 3 abc] - sum over a of (a/2 - a^3/6) phi_a,
///   q_ab = sqrt(1 - a^2 - b^2),  phi_a = atan(q_ab / b) + atan(q_ac / c) - pi / 2,
/// beyond two planes
///   V = 2/3 [atan(q_ab / ab) + ab q_ab] - (a - a^3/3) atan(q_ab / b) - (b - b^3/3) atan(q_ab / a).
double sphere_corner_volume(double radius, const Vec3& corner);

/// Volume of the part of a sphere that lies in an axis-aligned box [m3]; a box with min > max along an axis is empty.
/// Exact within 1e-14 of the sphere's volume; the volume of a box that the sphere holds is exact.
double sphere_box_volume(const Vec3& centre, double radius, const Vec3& min, const Vec3& max);

/// An endless cylinder cut off between two heights, seen from a sphere's centre.
struct CylinderPart {
  double distance = 0;  ///< of the sphere's centre from the axis [m]
  double radius = 0;    ///< of the cylinder [m]
  double lower = 0;     ///< along the axis, from the sphere's centre [m]; may be infinite
  double upper = 0;
};

/// Volume of the part of a sphere inside the cylinder and between the heights [m3], within 1e-11 of the sphere's
/// volume.
///
/// Divergence theorem in the plane across the axis: the thickness of the sphere's part over a point at distance s of
/// its centre, integrated, is the flux of phi(s) s through the outline of the two circles' common area. The sphere's
/// arc is elementary; on the cylinder's arc sin(beta / 2) = k sin(theta) makes the integrand smooth (the substitution
/// of Legendre's elliptic integrals, in which Lamarche and Leroy, Comput. Phys. Commun. 59 (1990) 359 give the volume
/// without cut ends), for Gauss and Legendre's rule.
double sphere_cylinder_volume(double radius, const CylinderPart& cylinder);

}  // namespace packstone::analysis
