// Bond-orientational order of every particle.
#pragma once

#include <vector>

#include "analysis/structure/bonds.hpp"

namespace packstone::analysis {

/// A bond is solid when the normalised product of both ends' q_6m is above this.
inline constexpr double solid_product = 0.7;
/// A particle is crystalline with at least so many solid bonds.
inline constexpr int solid_bonds_of_crystal = 7;

/// Of the particles in their rows; 0 where a particle has no neighbour.
struct BondOrder {
  std::vector<double> q4, q6;  ///< q_l(i) = sqrt(4 pi/(2l+1) sum_m |q_lm(i)|^2), q_lm(i) = <Y_lm> over bonds
  std::vector<double> averaged_q4, averaged_q6;  ///< the same of q_lm averaged over the particle and its neighbours
  std::vector<int> solid_bonds;
  double global_q4 = 0, global_q6 = 0;  ///< of <Y_lm> over all bonds of the chosen particles
  double bond_ends = 0;                 ///< at the chosen particles; a bond between two of them has two
};

/// chosen: (N) whose bonds enter the global order.
/// Sources: Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784, eqs. 1.2-1.4; Lechner, Dellago, J. Chem. Phys.
/// 129 (2008) 114707, eqs. 5-6; ten Wolde, Ruiz-Montero, Frenkel, J. Chem. Phys. 104 (1996) 9932 (solid bonds).
BondOrder bond_order(const Snapshot& snapshot, const Bonds& bonds, const std::vector<char>& chosen);

}  // namespace packstone::analysis
