// Verlet list: for each particle all others within its reach plus a margin, so that it serves for many steps.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/archive.hpp"
#include "core/domain.hpp"
#include "engine/aligned_vector.hpp"
#include "engine/detection/hierarchical_grid.hpp"
#include "engine/detection/margin_policy.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// Particles whose forces are summed in one go, one a lane; or one particle with many neighbours, whose neighbours are
/// spread over the lanes. Both particles of a pair that can touch list each other, so that each gathers its own forces
/// in an order that no thread count changes.
struct NeighbourGroup {
  std::int32_t slot;  ///< of the first particle
  std::int32_t rows;  ///< of `width` entries each
  std::int64_t first_row;
  std::uint32_t lanes;  ///< bits of those that hold a particle; 1 for a shared group
  bool shared;          ///< all lanes belong to the particle in `slot`
  bool images;          ///< a neighbour lies across a periodic side

  void archive(Archive& a) { a(slot, rows, first_row, lanes, shared, images); }
};

/// Groups that one thread takes in one go; sums over a block are made in order, whoever makes them.
struct GroupBlock {
  std::int32_t first, last;
};

class NeighbourList {
 public:
  /// width: lanes of a group. range: gap across which particles act on each other [m]. margin: as in MarginPolicy.
  /// Periodic sides must be at least least_periodic_side wide.
  NeighbourList(const Domain& domain, int width, double range = 0, std::optional<double> margin = std::nullopt)
      : domain_(domain), width_(width), range_(range), policy_(margin) {}

  /// Smallest periodic side at which a particle meets only one image of another [m].
  static double least_periodic_side(double largest_radius, double range = 0);

  /// Wraps positions into the box along periodic axes, finds every pair whose surfaces are nearer than its margins, and
  /// moves the particles into slots that keep neighbours close. least_share: of its radius, that each may move at
  /// least.
  void build(Particles& particles, const Growth& growth, double dt, double least_share = 0);

  /// Tells where the particles are after a step: the largest share of its margin that one has used, squared, and the
  /// sum of their displacements since the list was built [m]. A share that is not a number counts as infinite.
  void moved(double largest_share_squared, const Vec3& displacement_sum, double dt);

  /// Whether a contact could be missing, or a narrower list would pay.
  bool outdated(const Growth& growth) const;

  /// The order of a list decides that of sums: one built anew would not give the same bits.
  void archive(Archive& a);

  int width() const { return width_; }
  const std::vector<NeighbourGroup>& groups() const { return groups_; }
  const std::vector<GroupBlock>& blocks() const { return blocks_; }
  /// A row's neighbours, one a lane, as places in the array of Rows counted in doubles, which is what vector loads
  /// want; that of Particles::nobody where there is none.
  const std::uint32_t* row(std::int64_t row) const { return entries_.data() + row * width_; }
  static std::int32_t slot(std::uint32_t entry) { return static_cast<std::int32_t>(entry / Row::doubles); }
  std::int64_t rows() const { return static_cast<std::int64_t>(entries_.size()) / width_; }
  /// Neighbours, each pair counted twice.
  std::int64_t pairs() const { return pairs_; }

  /// Of radius and margin, as the grid allows for them [m].
  double largest_extent() const { return grid_.largest_extent(); }
  /// Where each particle was when the list was built [m].
  const VectorArray& reference() const { return reference_; }
  /// By how much all are expected to have moved by the end of the coming step [m]: a motion that all share brings no
  /// two closer.
  Vec3 expected_displacement() const { return displacement_ + (displacement_ - displacement_before_); }
  /// 1/margin^2 of each slot, 0 of an empty one [1/m2].
  const AlignedVector<double>& inverse_margin_squared() const { return inverse_margin_squared_; }

  /// Up to which common displacement, that of the coming step included, the margins hold [m].
  double common_displacement() const { return common_; }

  // What the list was built for.
  double largest_scale() const { return largest_scale_; }       ///< of growing radii
  double range() const { return range_; }                       ///< of attraction [m]
  double planned_life() const { return life_; }                 ///< [s]
  const Vec3& mean_velocity() const { return mean_velocity_; }  ///< of the particles [m/s]
  double mean_radius() const { return mean_radius_; }           ///< [m]

  /// How often the list was built.
  std::int64_t builds() const { return builds_; }

 private:
  /// What the search finds for particles first..last of the grid's order.
  struct Found {
    std::vector<std::int32_t> neighbours;  ///< by place in the order, one particle after the other; then room to spare
    std::size_t used = 0;                  ///< of neighbours
    std::vector<std::int32_t> end;         ///< of each particle's neighbours
    std::vector<std::uint8_t> images;      ///< whether one is across a periodic side
  };

  void choose_extents(Particles& particles, const Growth& growth, double dt, double least_share);
  void search();
  void search_one(std::size_t place, Found& found) const;
  void assign_slots();
  void fill_rows(std::int32_t nobody);
  void make_blocks();
  bool image_across(const Vec3& point, double reach) const;

  Domain domain_;
  int width_;
  double range_;
  MarginPolicy policy_;
  HierarchicalGrid grid_;
  std::vector<NeighbourGroup> groups_;
  std::vector<GroupBlock> blocks_;
  AlignedVector<std::uint32_t> entries_;
  VectorArray reference_;
  AlignedVector<double> inverse_margin_squared_;
  std::int64_t builds_ = 0;
  std::int64_t pairs_ = 0;

  // Since the list was built.
  std::int64_t steps_ = 0;
  double largest_scale_ = 0;  ///< of the growth that the extents allow for
  double used_squared_ = 0;
  double dt_ = 0;
  std::size_t particles_ = 0;
  Vec3 displacement_ = Vec3::Zero(), displacement_before_ = Vec3::Zero();
  double common_ = 0;
  double life_ = 0, mean_radius_ = 0;
  Vec3 mean_velocity_ = Vec3::Zero();

  // While it is built: in the particles' order before, in the grid's order, by slot.
  VectorArray position_;
  AlignedVector<double> extent_, margin_;
  std::vector<std::int32_t> slot_before_;
  std::vector<Found> found_;
  std::vector<std::int32_t> slot_of_;   ///< by place in the grid's order
  std::vector<std::int32_t> place_of_;  ///< by slot; no_particle in an empty one
};

}  // namespace packstone::engine
