#include "analysis/voronoi/radical_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <numeric>
#include <utility>

#include "analysis/voronoi/cell_walls.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double particles_per_block = 5;         // of space; the speed hardly depends on it from 3 to 8
constexpr int particles_at_first = 8;             // a block has memory for
constexpr double most_tests_each = 4000;          // partners in its own block, mean over the particles
constexpr double coincidence = 1e-6;              // of the mean distance between particles
constexpr double largest_radius_slack = 1e-12;    // against round-off in voro++'s search
constexpr std::size_t most_particles = 1u << 28;  // voro++ counts blocks, times 8 where periodic, in 32 bits
constexpr int blocks_at_once = 8;                 // that a thread takes
constexpr double inside_side = 1e-13;             // of a box side; voro++ drops particles on the upper side

/// Takes away all but one of the particles at each place, which voro++ cannot tell apart: the largest stays, of equal
/// ones the first. Particles at one place are near each other along any direction; a slanted one has few others there.
void leave_one_of_each_place(std::vector<std::uint32_t>& rows, std::span<const Vec3> centre,
                             std::span<const double> radius, const Domain& box, double distance) {
  const Vec3 direction = Vec3(1, std::numbers::sqrt2, std::numbers::sqrt3).normalized();
  std::vector<std::pair<double, std::uint32_t>> order;  // along the direction
  order.reserve(rows.size());
  for (const std::uint32_t row : rows) {
    Vec3 p = centre[row];
    for (int k = 0; k < 3; ++k) {
      if (box.periodic[k] && p[k] > box.max[k] - distance) p[k] -= box.size()[k];  // to its like on the lower side
    }
    order.emplace_back(direction.dot(p), row);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> covered;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first < distance; ++j) {
      const std::uint32_t first = std::min(order[i].second, order[j].second);
      const std::uint32_t second = std::max(order[i].second, order[j].second);
      if (!(box.separation(centre[first], centre[second]).norm() < distance)) continue;
      covered.push_back(radius[first] >= radius[second] ? second : first);
    }
  }
  if (covered.empty()) return;
  std::sort(covered.begin(), covered.end());
  std::erase_if(rows, [&](std::uint32_t row) { return std::binary_search(covered.begin(), covered.end(), row); });
}

using Blocks = std::array<int, 3>;

std::size_t product(const Blocks& blocks) {
  return static_cast<std::size_t>(blocks[0]) * static_cast<std::size_t>(blocks[1]) *
         static_cast<std::size_t>(blocks[2]);
}

/// Blocks for a few particles each where the particles are, but no more blocks than particles.
Blocks blocks_for(const std::vector<Vec3>& at, const Vec3& size) {
  Vec3 low = at.front(), high = at.front();
  for (const Vec3& p : at) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double n = static_cast<double>(at.size());
  const double filled = (high - low).prod();
  double edge = std::cbrt(particles_per_block * std::max(filled, size.prod() / n) / n);
  constexpr double growth = 1.1;
  Blocks blocks;
  do {
    for (int k = 0; k < 3; ++k) blocks[k] = static_cast<int>(std::clamp(std::ceil(size[k] / edge), 1.0, n));
    edge *= growth;
  } while (product(blocks) > at.size());
  return blocks;
}

void check_spread(const voro::container_poly& space, const Blocks& blocks, std::size_t particles) {
  double tests = 0, crowd = 0;
  for (std::size_t b = 0; b < product(blocks); ++b) {
    tests += static_cast<double>(space.co[b]) * space.co[b];
    crowd = std::max(crowd, static_cast<double>(space.co[b]));
  }
  if (tests <= most_tests_each * static_cast<double>(particles)) return;
  throw InputError("voronoi: " + std::to_string(static_cast<std::size_t>(crowd)) + " of " + std::to_string(particles) +
                   " particles crowd in one of " + std::to_string(product(blocks)) +
                   " equal parts of the container; take away the particles that lie far from the others");
}

/// What one thread works with: a view of the shared particles, and a search of its own.
class Search {
 public:
  /// The container's search keeps the radius of the particle at work in the container itself. So every thread has a
  /// copy of its members, which shares the particles, and is never destroyed since it owns nothing.
  Search(const voro::container_poly& space, const Blocks& blocks)
      : view_(*new (memory_) voro::container_poly(space)),
        compute_(view_, masked(space.xperiodic, blocks[0]), masked(space.yperiodic, blocks[1]),
                 masked(space.zperiodic, blocks[2])) {}
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  bool compute(voro::voronoicell& cell, int block, int slot, const Blocks& at) {
    return compute_.compute_cell(cell, block, slot, at[0], at[1], at[2]);
  }

 private:
  static int masked(bool periodic, int blocks) { return periodic ? 2 * blocks + 1 : blocks; }

  alignas(voro::container_poly) std::byte memory_[sizeof(voro::container_poly)];
  voro::container_poly& view_;
  voro::voro_compute<voro::container_poly> compute_;
};

CellState state_of(voro::voronoicell& cell, const Vec3& centre, double unit, const BedSurface& surface) {
  if (surface.above_ball(centre, reach(cell) * unit)) return CellState::whole;
  for (int v = 0; v < cell.p; ++v) {
    const Vec3 corner(cell.pts[3 * v], cell.pts[3 * v + 1], cell.pts[3 * v + 2]);
    if (surface.below(centre + corner * (unit / 2))) return CellState::surface;  // voro++ keeps corners doubled
  }
  return CellState::whole;
}

/// The particles in blocks, scaled.
class Space {
 public:
  Space(const std::vector<std::uint32_t>& rows, const std::vector<Vec3>& at, std::span<const double> radius,
        const Domain& box, double unit)
      : size_(box.size() / unit),
        blocks_(blocks_for(at, size_)),
        particles_(0, size_.x(), 0, size_.y(), 0, size_.z(), blocks_[0], blocks_[1], blocks_[2], box.periodic[0],
                   box.periodic[1], box.periodic[2], particles_at_first) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Vec3 p = at[i];
      for (int k = 0; k < 3; ++k) {
        if (!box.periodic[k]) p[k] = std::min(p[k], size_[k] * (1 - inside_side));
      }
      particles_.put(static_cast<int>(rows[i]), p.x(), p.y(), p.z(), radius[rows[i]] / unit);
    }
    check_spread(particles_, blocks_, rows.size());
    // The largest spheres' search ends at comparisons of equal numbers, which round-off may turn: let it go a little
    // farther. (voro++ after 0.4.6 does so itself: its issue 43.)
    particles_.max_radius *= 1 + largest_radius_slack;
  }

  /// Calls visit(row, cell, at) for every particle that has a cell, from several threads at once.
  template <class Visit>
  void for_each_cell(const CellWalls& walls, Visit&& visit) {
    const int blocks = static_cast<int>(product(blocks_));
#pragma omp parallel
    {
      Search search(particles_, blocks_);
      voro::voronoicell cell;
#pragma omp for schedule(dynamic, blocks_at_once)
      for (int block = 0; block < blocks; ++block) {
        const Blocks place = place_of(block);
        for (int slot = 0; slot < particles_.co[block]; ++slot) {
          const Vec3 at = centre(block, slot);
          if (search.compute(cell, block, slot, place) && walls.cut(cell, at)) {
            visit(static_cast<std::size_t>(particles_.id[block][slot]), cell, at);
          }
        }
      }
    }
  }

 private:
  Blocks place_of(int block) const {
    return {block % blocks_[0], block / blocks_[0] % blocks_[1], block / blocks_[0] / blocks_[1]};
  }

  Vec3 centre(int block, int slot) const {
    const double* p = particles_.p[block] + particles_.ps * slot;
    return {p[0], p[1], p[2]};
  }

  Vec3 size_;
  Blocks blocks_;
  voro::container_poly particles_;
};

}  // namespace

RadicalCells radical_cells(std::span<const Vec3> centre, std::span<const double> radius, const CellContainer& container,
                           const BedSurface& surface) {
  const std::size_t n = centre.size();
  if (n > most_particles) {
    throw InputError("voronoi: " + std::to_string(n) + " particles; at most 2^28 can have cells");
  }
  RadicalCells cells{.volume = std::vector<double>(n, 0.0),
                     .faces = std::vector<std::uint16_t>(n, 0),
                     .state = std::vector<CellState>(n, CellState::empty)};
  const Domain& box = container.box;
  const CellFrame frame{box.min, std::cbrt(box.size().prod() / static_cast<double>(n))};
  const double mean_radius = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(n);
  const CellWalls walls(container, frame, mean_radius);
  const double unit_volume = frame.unit * frame.unit * frame.unit;
  cells.container_volume = walls.volume_within(box.size() / frame.unit) * unit_volume;

  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < n; ++i) {
    if (container.holds(centre[i])) {
      rows.push_back(static_cast<std::uint32_t>(i));
    } else {
      cells.state[i] = CellState::outside;
    }
  }
  leave_one_of_each_place(rows, centre, radius, box, coincidence * frame.unit);
  if (rows.empty()) return cells;
  std::vector<Vec3> at;
  for (const std::uint32_t row : rows) at.push_back(frame.scaled(centre[row]));

  Space space(rows, at, radius, box, frame.unit);
  space.for_each_cell(walls, [&](std::size_t row, voro::voronoicell& cell, const Vec3& place) {
    cells.volume[row] = cell.volume() * unit_volume;
    cells.faces[row] = static_cast<std::uint16_t>(2 + cell.number_of_edges() - cell.p);  // Euler
    cells.state[row] = state_of(cell, frame.origin + place * frame.unit, frame.unit, surface);
  });
  return cells;
}

}  // namespace packstone::analysis
