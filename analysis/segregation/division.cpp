#include "analysis/segregation/division.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace packstone::analysis {

namespace {

constexpr double parallel = 1 - 1e-9;     // least component along an axis of one that lies along it
constexpr std::size_t scale_count = 12;   // sizes of cells
constexpr double most_cells_each = 8;     // to a particle
constexpr double edge_growth = 1.25;      // of cells that are too many
constexpr double most_cells_along = 1e9;  // keeps the number of cells within an integer

/// The compartment of a position between 0 and 1; the nearest for one outside.
std::size_t compartment_of(double position, std::size_t count) {
  const double slot = std::floor(position * static_cast<double>(count));
  if (!(slot > 0)) return 0;
  return static_cast<std::size_t>(std::min(slot, static_cast<double>(count - 1)));
}

double all_cells(const CellGrid& grid) {
  double cells = 1;
  for (const std::size_t count : grid.count) cells *= static_cast<double>(count);
  return cells;
}

CellGrid box_of(const Snapshot& snapshot) {
  CellGrid box;
  for (int k = 0; k < 3; ++k) {
    double low = snapshot.domain.min[k], high = snapshot.domain.max[k];
    if (!snapshot.domain.periodic[k]) {
      low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = 0; i < snapshot.size(); ++i) {
        low = std::min(low, snapshot.position[i][k] - snapshot.radius[i]);
        high = std::max(high, snapshot.position[i][k] + snapshot.radius[i]);
      }
    }
    box.low[k] = low;
    box.size[k] = std::min(high - low, std::numeric_limits<double>::max());
  }
  return box;
}

/// In cells of about the edge, or larger ones where they would be too many for so many particles.
CellGrid divided(CellGrid box, double edge, std::size_t particles) {
  const double most = most_cells_each * static_cast<double>(particles);
  do {
    for (int k = 0; k < 3; ++k) {
      const double count = std::clamp(std::round(box.size[k] / edge), 1.0, most_cells_along);
      box.count[static_cast<std::size_t>(k)] = static_cast<std::size_t>(count);
    }
    edge *= edge_growth;
  } while (all_cells(box) > most);
  return box;
}

/// Middle of a boundary's surface.
Vec3 middle_of(const BoundaryRecord& boundary) {
  Vec3 low = boundary.points.front(), high = low;
  for (const Vec3& p : boundary.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (low + high) / 2;
}

const BoundaryRecord* narrowest_container(const Snapshot& snapshot, int axis) {
  const BoundaryRecord* narrowest = nullptr;
  for (const auto& boundary : snapshot.boundaries) {
    const bool encloses = std::abs(boundary.axis[axis]) >= parallel && boundary.cross_section > 0;
    if (!encloses || boundary.points.empty()) continue;
    if (!narrowest || boundary.cross_section < narrowest->cross_section) narrowest = &boundary;
  }
  return narrowest;
}

double squared_distance(const Vec3& from_centre, int axis) {
  const double a = from_centre[(axis + 1) % 3], b = from_centre[(axis + 2) % 3];
  return a * a + b * b;
}

}  // namespace

BedFrame frame_along(const Snapshot& snapshot, const BedFrame& up, int axis) {
  if (axis == up.axis) return up;
  BedFrame frame;
  frame.axis = axis;
  frame.extent = snapshot.domain.size()[axis];
  frame.area = snapshot.domain.size().prod() / frame.extent;
  frame.periodic = snapshot.domain.periodic[axis];
  frame.floor = snapshot.domain.min[axis];
  if (!frame.periodic && snapshot.size() > 0) frame.floor = box_of(snapshot).low[axis];
  for (const Vec3& p : snapshot.position) frame.height.push_back(p[axis] - frame.floor);
  return frame;
}

Division divided_into_layers(const BedFrame& frame, std::span<const double> radius, const Layers& layers) {
  Division division{.count = layers.count};
  division.begin.reserve(radius.size() + 1);
  division.begin.push_back(0);
  for (std::size_t i = 0; i < radius.size(); ++i) {
    for_layer_shares(frame.height[i], radius[i], layers, [&](std::uint32_t layer, double share) {
      division.compartment.push_back(layer);
      division.share.push_back(share);
    });
    division.begin.push_back(division.compartment.size());
  }
  return division;
}

double Rings::outer(std::size_t ring) const {
  return reach * std::sqrt(static_cast<double>(ring + 1) / static_cast<double>(count));
}

Rings rings_about(const Snapshot& snapshot, int axis, std::size_t wanted, double diameter) {
  Rings rings{.axis = axis};
  const BoundaryRecord* container = narrowest_container(snapshot, axis);
  const auto& periodic = snapshot.domain.periodic;
  if (!container &&
      (periodic[static_cast<std::size_t>(axis + 1) % 3] || periodic[static_cast<std::size_t>(axis + 2) % 3])) {
    rings.missing = "the domain is periodic across the axis, and no boundary encloses the bed";
    return rings;
  }
  rings.centre = container ? middle_of(*container) : Vec3((snapshot.domain.min + snapshot.domain.max) / 2);
  double farthest = 0;
  for (const Vec3& p : snapshot.position) farthest = std::max(farthest, squared_distance(p - rings.centre, axis));
  rings.reach = std::sqrt(farthest);
  if (!(rings.reach > 0)) {
    rings.missing = "all particles lie on the axis";
    return rings;
  }
  // Of n rings of equal area the outermost is reach / (2 n) wide.
  const double by_width = diameter > 0 ? std::round(rings.reach / (2 * diameter)) : 0;
  const double count = wanted > 0 ? static_cast<double>(wanted) : by_width;
  rings.count = static_cast<std::size_t>(std::clamp(count, 2.0, static_cast<double>(most_layers)));
  return rings;
}

Division divided_into_rings(const Snapshot& snapshot, const Rings& rings) {
  Division division{.count = rings.count};
  division.compartment.reserve(snapshot.size());
  const double area = rings.reach * rings.reach;  // over pi
  for (const Vec3& p : snapshot.position) {
    const double position = squared_distance(p - rings.centre, rings.axis) / area;
    division.compartment.push_back(static_cast<std::uint32_t>(compartment_of(position, rings.count)));
  }
  return division;
}

double CellGrid::edge() const {
  double edge = 1;  // cube roots first: the volume of a box out to a lost particle may overflow
  for (int k = 0; k < 3; ++k) edge *= std::cbrt(size[k] / static_cast<double>(count[static_cast<std::size_t>(k)]));
  return edge;
}

int longest_axis(const Snapshot& snapshot) {
  int axis = 0;
  box_of(snapshot).size.maxCoeff(&axis);
  return axis;
}

CellGrid cell_grid(const Snapshot& snapshot, double edge) { return divided(box_of(snapshot), edge, snapshot.size()); }

Division divided_into_cells(const Snapshot& snapshot, const CellGrid& grid) {
  constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(static_cast<std::size_t>(all_cells(grid)), unseen);
  Division division;
  division.compartment.reserve(snapshot.size());
  for (const Vec3& p : snapshot.position) {
    std::size_t cell = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t count = grid.count[static_cast<std::size_t>(k)];
      cell = cell * count + compartment_of((p[k] - grid.low[k]) / grid.size[k], count);
    }
    if (number[cell] == unseen) number[cell] = static_cast<std::uint32_t>(division.count++);
    division.compartment.push_back(number[cell]);
  }
  return division;
}

std::vector<CellGrid> grids_of_all_scales(const Snapshot& snapshot, double finest_edge) {
  std::vector<CellGrid> grids;
  const CellGrid box = box_of(snapshot);
  const double whole = box.size.maxCoeff();
  if (!(finest_edge > 0) || !(whole > finest_edge)) return grids;
  for (std::size_t k = 0; k < scale_count; ++k) {
    const double step = static_cast<double>(k) / static_cast<double>(scale_count - 1);
    const CellGrid grid = divided(box, finest_edge * std::pow(whole / finest_edge, step), snapshot.size());
    const bool again = !grids.empty() && grids.back().count == grid.count;
    if (!again && all_cells(grid) >= 2) grids.push_back(grid);
  }
  return grids;
}

}  // namespace packstone::analysis
