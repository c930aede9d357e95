// Verlet list: for each particle all others within its reach plus a margin, so that it serves for many steps.
#pragma once

#include <cstdint>
#include <vector>

#include "core/domain.hpp"
#include "engine/detection/cell_grid.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// One neighbour as a particle's row holds it: both particles of a pair list each other, so that each gathers its own
/// forces in an order that no thread count changes.
struct Neighbour {
  std::int32_t index;
  std::int32_t image;  ///< which periodic image of it, into NeighbourList::shifts
};

class NeighbourList {
 public:
  /// Periodic sides must be at least least_periodic_side wide.
  NeighbourList(const Domain& domain, double largest_radius);

  /// Smallest periodic side at which a particle meets only one image of another [m].
  static double least_periodic_side(double largest_radius);

  /// Wraps positions into the box along periodic axes and finds every pair whose surfaces are nearer than the margin.
  void build(Particles& particles, const Growth& growth);

  /// Whether, after the largest displacement since build [m], squared, and growth, a contact could be missing. True for
  /// a displacement that is not a number.
  bool outdated(double largest_displacement_squared, const Growth& growth) const;

  std::size_t first(std::size_t i) const { return first_[i]; }
  std::size_t last(std::size_t i) const { return first_[i + 1]; }
  const Neighbour& entry(std::size_t k) const { return entries_[k]; }
  std::size_t size() const { return entries_.size(); }
  /// Displacement of image k from the particle itself [m].
  const Vec3& shift(std::int32_t k) const { return shifts_[k]; }
  /// Where each particle was when the list was built [m].
  const VectorArray& reference() const { return reference_; }
  /// How often the list was built.
  std::int64_t builds() const { return builds_; }

 private:
  void append_neighbours(const Particles& particles, std::size_t i, double scale, std::vector<Neighbour>& row) const;

  Domain domain_;
  double largest_radius_;
  double margin_;
  double built_scale_ = 1;
  std::int64_t builds_ = 0;
  CellGrid grid_;
  VectorArray reference_;
  std::vector<std::size_t> first_;
  std::vector<Neighbour> entries_;
  std::vector<std::vector<Neighbour>> found_;  ///< by block of particles, before they are laid end to end
  std::vector<Vec3> shifts_;
};

}  // namespace packstone::engine
