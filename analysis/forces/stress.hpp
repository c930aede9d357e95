// Stress of particles and of regions, from contact forces and motion. Compression is positive throughout, as in
// geotechnics.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/forces/force_network.hpp"
#include "analysis/layers.hpp"

namespace packstone::analysis {

using Mat3 = Eigen::Matrix3d;

/// The symmetric part of a stress tensor in its own axes.
struct PrincipalStress {
  Vec3 value = Vec3::Zero();          ///< from the largest (most compressive) to the smallest [Pa]
  Mat3 direction = Mat3::Identity();  ///< columns: unit vectors, in the same order
};

PrincipalStress principal(const Mat3& stress);

inline double pressure(const Mat3& stress) { return stress.trace() / 3; }

/// sqrt(3/2 s:s) of the deviator s of the symmetric part; sigma_1 - sigma_3 in triaxial compression.
double deviator(const Mat3& stress);

/// Symmetric part.
inline Mat3 symmetric(const Mat3& stress) { return 0.5 * (stress + stress.transpose()); }

/// (N) sum_c f_c (x) l_c of the contacts of every particle [J]: f the force on it, l from the contact to its centre,
/// so that compression is positive. Over the particle's volume it is its mean stress.
/// l is the particle's share of the branch (ForceContact), so that the sums of both partners make up f (x) branch.
/// Source: Christoffersen, Mehrabadi, Nemat-Nasser, J. Appl. Mech. 48 (1981) 339; Peters et al. (force_chains.hpp).
std::vector<Mat3> particle_force_moments(const Snapshot& snapshot, const ForceNetwork& network);

/// Stress of one layer.
struct LayerStress {
  Mat3 contact = Mat3::Zero();  ///< [Pa]
  Mat3 kinetic = Mat3::Zero();  ///< [Pa]; 0 where the snapshot holds no velocity
  Mat3 total() const { return contact + kinetic; }
};

/// (layers.count) Love-Weber stress of every layer of volume V = area x thickness,
///   sigma = (1/V) sum_c f (x) l + (1/V) sum_i m v' (x) v',
/// f on the first particle, l the part of the branch that lies in the layer, so that neighbouring layers add up;
/// v' against the mean velocity (by mass) of the particles whose centres lie in the layer.
/// Source: Weber, Bulletin de liaison des Ponts et Chaussees 20 (1966) 1.
std::vector<LayerStress> layer_stress(const Snapshot& snapshot, const BedFrame& frame, const ForceNetwork& network,
                                      const Layers& layers);

/// The particles' velocities by rows; empty unless the field "velocity" is there, a vector and finite, and all
/// masses are known.
std::span<const double> velocities(const Snapshot& snapshot);

/// Angle between a direction, either way along it, and the vertical [degrees].
double angle_to_vertical(const Vec3& direction, const BedFrame& frame);

}  // namespace packstone::analysis
