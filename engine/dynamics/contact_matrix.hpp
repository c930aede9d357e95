// How the forces of central contacts change with the particles' positions: a sparse matrix of 3 x 3 blocks, by slot.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "engine/detection/neighbour_list.hpp"

namespace packstone::engine {

using Mat3 = Eigen::Matrix3d;

/// A vector a slot.
using SlotVectors = std::vector<Vec3>;

/// k n n^T of contacts: -dF/dx apart from the force's turning with the normal, F/(k d) as much, without which it is
/// never negative. Both particles of a contact have it in their rows.
class ContactMatrix {
 public:
  struct Entry {
    std::int32_t other;  ///< slot; none for a wall
    Vec3 normal;
    double stiffness;  ///< k [N/m]
  };
  static constexpr std::int32_t wall = -1;

  /// Of a block of groups, one after the other; each slot's entries follow each other.
  struct Block {
    std::vector<Entry> entries;
    std::vector<std::pair<std::int32_t, std::int32_t>> ends;  ///< slot, end of its entries
    double energy = 0;                                        ///< stored in walls' contacts and half of the others' [J]
  };
  std::vector<Block>& blocks() { return blocks_; }

  /// y = (share / mobility + K) x, with nothing where the mobility is 0 [N/m]. share: 1/h [1/s].
  void multiply(const std::vector<double>& mobility, double share, const SlotVectors& x, SlotVectors& y) const;

  /// Inverses of the 3 x 3 blocks on the diagonal, by slot [m/N].
  void invert_diagonal(const std::vector<double>& mobility, double share, std::vector<Mat3>& inverse) const;

  /// Stored in all contacts [J].
  double energy() const;

  /// Gershgorin's bound on the eigenvalues of mobility K [1/s].
  double largest_rate(const std::vector<double>& mobility) const;

 private:
  std::vector<Block> blocks_;
};

}  // namespace packstone::engine
