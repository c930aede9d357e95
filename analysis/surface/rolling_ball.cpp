#include "analysis/surface/rolling_ball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analysis/mean_diameter.hpp"
#include "analysis/packing/images.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double steps_a_radius = 8;  // of the default step
constexpr double tiles_a_reach = 3;   // wide enough to be few, small enough to be covered by single spheres

/// A sphere swollen by the probe's radius: where the probe's centre cannot be.
struct Swollen {
  double u, v, height, radius;
};

struct Span {
  std::size_t first, last;  // without the last
};

double squared(double x) { return x * x; }

/// Columns whose middles lie between two coordinates along one side.
Span columns_between(const SurfaceHeights& grid, int side, double lower, double upper) {
  const double count = static_cast<double>(grid.count[side]);
  const auto index = [&](double x) { return (x - grid.origin[side]) / grid.step[side]; };
  return {static_cast<std::size_t>(std::clamp(std::ceil(index(lower)), 0.0, count)),
          static_cast<std::size_t>(std::clamp(std::floor(index(upper)) + 1, 0.0, count))};
}

double column_middle(const SurfaceHeights& grid, int side, std::size_t index) {
  return grid.origin[side] + grid.step[side] * static_cast<double>(index);
}

/// Squares of columns, each with the swollen spheres that may be the highest over one of its columns.
class Tiles {
 public:
  Tiles(const SurfaceHeights& grid, const std::vector<Swollen>& balls) : grid_(grid) {
    double reach = 0;
    for (const Swollen& ball : balls) reach += ball.radius / static_cast<double>(balls.size());
    const double width = std::ceil(reach / std::max(grid.step[0], grid.step[1]) / tiles_a_reach);
    width_ = static_cast<std::size_t>(std::max(1.0, width));
    for (int side = 0; side < 2; ++side) tiles_[side] = (grid.count[side] + width_ - 1) / width_;
    covered_.assign(tiles_[0] * tiles_[1], grid.probe);  // by the floor
    for (const Swollen& ball : balls) {
      for_each_tile(ball, [&](std::size_t tile, double, double farthest) {
        if (farthest < squared(ball.radius)) raise(tile, ball.height + std::sqrt(squared(ball.radius) - farthest));
      });
    }
    list(balls);
  }

  std::size_t size() const { return covered_.size(); }
  Span columns(std::size_t tile, int side) const {
    const std::size_t index = side == 0 ? tile % tiles_[0] : tile / tiles_[0];
    return {index * width_, std::min((index + 1) * width_, grid_.count[side])};
  }
  /// Calls visit(index of the ball).
  template <class Visit>
  void for_each_ball(std::size_t tile, Visit&& visit) const {
    for (std::size_t k = first_[tile]; k < first_[tile + 1]; ++k) visit(ball_[k]);
  }

 private:
  /// Calls visit(tile, nearest, farthest), the squared distances of the tile's columns from the ball's centre.
  template <class Visit>
  void for_each_tile(const Swollen& ball, Visit&& visit) const {
    const Span u = columns_between(grid_, 0, ball.u - ball.radius, ball.u + ball.radius);
    const Span v = columns_between(grid_, 1, ball.v - ball.radius, ball.v + ball.radius);
    if (u.first >= u.last || v.first >= v.last) return;
    for (std::size_t j = v.first / width_; j <= (v.last - 1) / width_; ++j) {
      const auto [near_v, far_v] = distances(j * tiles_[0], 1, ball.v);
      for (std::size_t i = u.first / width_; i <= (u.last - 1) / width_; ++i) {
        const auto [near_u, far_u] = distances(i, 0, ball.u);
        visit(i + tiles_[0] * j, squared(near_u) + squared(near_v), squared(far_u) + squared(far_v));
      }
    }
  }

  /// Of a coordinate from the nearest and the farthest column of a tile along one side.
  std::pair<double, double> distances(std::size_t tile, int side, double x) const {
    const Span span = columns(tile, side);
    const double low = column_middle(grid_, side, span.first) - x, high = column_middle(grid_, side, span.last - 1) - x;
    return {std::max({low, -high, 0.0}), std::max(std::abs(low), std::abs(high))};
  }

  void raise(std::size_t tile, double height) { covered_[tile] = std::max(covered_[tile], height); }

  void list(const std::vector<Swollen>& balls) {
    const double lowest = *std::min_element(covered_.begin(), covered_.end());
    const auto for_each_candidate = [&](auto&& visit) {
      for (std::size_t b = 0; b < balls.size(); ++b) {
        if (balls[b].height + balls[b].radius < lowest) continue;
        for_each_tile(balls[b], [&](std::size_t tile, double nearest, double) {
          const double rise = squared(balls[b].radius) - nearest;
          if (rise > 0 && balls[b].height + std::sqrt(rise) >= covered_[tile]) visit(tile, b);
        });
      }
    };
    first_.assign(size() + 1, 0);
    for_each_candidate([&](std::size_t tile, std::size_t) { ++first_[tile + 1]; });
    for (std::size_t tile = 0; tile < size(); ++tile) first_[tile + 1] += first_[tile];
    ball_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_candidate([&](std::size_t tile, std::size_t b) { ball_[next[tile]++] = b; });
  }

  const SurfaceHeights& grid_;
  std::size_t width_ = 1;  // columns
  std::array<std::size_t, 2> tiles_ = {};
  std::vector<double> covered_;  // (tiles) height that some sphere reaches over all of the tile [m]
  std::vector<std::size_t> first_, ball_;
};

/// The grid without heights; no columns where there is no cross-section.
SurfaceHeights empty_grid(const Context& context, const Container& container, double step) {
  SurfaceHeights grid;
  const BoxRegion box = bounds(container.column(0, 0, 1));
  double columns = 1;
  for (int side = 0; side < 2; ++side) {
    const int k = (context.frame.axis + 1 + side) % 3;
    const double width = box.max[k] - box.min[k];
    const double count = std::max(1.0, std::ceil(width / step));
    columns *= count;
    if (columns > most_surface_columns) {
      throw InputError(
          fmt::format("a step of {:g} m divides the surface into more than {:g} columns; a larger one "
                      "(--surface-step) makes fewer",
                      step, most_surface_columns));
    }
    grid.across[side] = k;
    grid.step[side] = width / count;
    grid.origin[side] = box.min[k] + grid.step[side] / 2;
    grid.count[side] = width > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return grid;
}

std::vector<Swollen> swollen_spheres(const Snapshot& snapshot, const Context& context, const Container& container,
                                     const SurfaceHeights& grid) {
  BoxRegion box = bounds(container.column(0, 0, 1));
  box.min[context.frame.axis] = -infinite;
  box.max[context.frame.axis] = infinite;
  std::vector<Swollen> balls;
  balls.reserve(snapshot.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const double radius = snapshot.radius[i] + grid.probe;
    for_each_image(snapshot.domain, snapshot.position[i], radius, box, [&](const Vec3& image) {
      balls.push_back({image[grid.across[0]], image[grid.across[1]], context.frame.height[i], radius});
    });
  }
  return balls;
}

/// Height of the probe's centre where it rests over every column (c in the header).
std::vector<double> centre_heights(const SurfaceHeights& grid, const std::vector<Swollen>& balls) {
  std::vector<double> centre(grid.count[0] * grid.count[1], grid.probe);  // on the floor
  const Tiles tiles(grid, balls);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const Span u = tiles.columns(tile, 0), v = tiles.columns(tile, 1);
    tiles.for_each_ball(tile, [&](std::size_t b) {
      const Swollen& ball = balls[b];
      for (std::size_t j = v.first; j < v.last; ++j) {
        const double left = squared(ball.radius) - squared(column_middle(grid, 1, j) - ball.v);
        for (std::size_t i = u.first; i < u.last; ++i) {
          const double rise = left - squared(column_middle(grid, 0, i) - ball.u);
          double& highest = centre[i + grid.count[0] * j];
          if (rise > 0) highest = std::max(highest, ball.height + std::sqrt(rise));
        }
      }
    });
  }
  return centre;
}

/// The centre heights with a margin all around: images across periodic sides, else no place for the probe.
struct Padded {
  std::array<std::size_t, 2> margin, count;
  std::vector<double> height;
};

Padded padded(const SurfaceHeights& grid, const std::vector<double>& centre, const Container& container) {
  Padded result;
  for (int side = 0; side < 2; ++side) {
    result.margin[side] = static_cast<std::size_t>(std::ceil(grid.probe / grid.step[side]));
    result.count[side] = grid.count[side] + 2 * result.margin[side];
  }
  /// Column in the grid of one in the padded grid; none behind a wall.
  const auto inner = [&](std::size_t k, int side) -> std::optional<std::size_t> {
    const auto index = static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(result.margin[side]);
    const auto count = static_cast<std::ptrdiff_t>(grid.count[side]);
    const bool wall = container.round || container.walled[grid.across[side]];
    if (wall && (index < 0 || index >= count)) return std::nullopt;
    return static_cast<std::size_t>(((index % count) + count) % count);
  };
  result.height.assign(result.count[0] * result.count[1], infinite);
  for (std::size_t j = 0; j < result.count[1]; ++j) {
    const auto row = inner(j, 1);
    if (!row) continue;
    for (std::size_t i = 0; i < result.count[0]; ++i) {
      const auto column = inner(i, 0);
      if (column) result.height[i + result.count[0] * j] = centre[*column + grid.count[0] * *row];
    }
  }
  return result;
}

/// Where the probe's lower half reaches down to, of all its places (h in the header).
void roll(SurfaceHeights& grid, const Padded& centre) {
  const std::size_t nu = grid.count[0], nv = grid.count[1];
  const std::size_t wide = 2 * centre.margin[0] + 1, high = 2 * centre.margin[1] + 1;
  grid.height.assign(nu * nv, infinite);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t j = 0; j < nv; ++j) {
    double* const row = &grid.height[nu * j];
    for (std::size_t b = 0; b < high; ++b) {
      const double dv = grid.step[1] * (static_cast<double>(b) - static_cast<double>(centre.margin[1]));
      for (std::size_t a = 0; a < wide; ++a) {
        const double du = grid.step[0] * (static_cast<double>(a) - static_cast<double>(centre.margin[0]));
        const double under = squared(grid.probe) - squared(du) - squared(dv);
        if (under < 0) continue;
        const double depth = std::sqrt(under);
        const double* const from = &centre.height[a + centre.count[0] * (j + b)];
#pragma omp simd
        for (std::size_t i = 0; i < nu; ++i) row[i] = std::min(row[i], from[i] - depth);
      }
    }
  }
}

/// Sets all columns whose middles lie outside of a round container.
void leave_out(const SurfaceHeights& grid, const Container& container, std::vector<double>& height, double value) {
  if (!container.round) return;
  Vec3 point = container.centre;
  for (std::size_t j = 0; j < grid.count[1]; ++j) {
    for (std::size_t i = 0; i < grid.count[0]; ++i) {
      point[grid.across[0]] = column_middle(grid, 0, i);
      point[grid.across[1]] = column_middle(grid, 1, j);
      if (container.wall_distance(point) < 0) height[i + grid.count[0] * j] = value;
    }
  }
}

}  // namespace

double surface_probe(const Snapshot& snapshot, const Context& context) {
  const double wanted = context.options.surface_probe;
  return wanted > 0 ? wanted : volume_mean_diameter(snapshot.radius) / 2;
}

double surface_step(const Snapshot& snapshot, const Context& context, const Container& container) {
  if (context.options.surface_step > 0) return context.options.surface_step;
  const double radius = std::min(surface_probe(snapshot, context), volume_mean_diameter(snapshot.radius) / 2);
  const double area = region_volume(container.column(0, 0, 1));
  return std::max(radius / steps_a_radius, std::sqrt(area / (most_surface_columns / 4)));
}

SurfaceHeights free_surface(const Snapshot& snapshot, const Context& context, const Container& container, double step) {
  const double probe = surface_probe(snapshot, context);
  if (!container.unknown.empty() || context.frame.periodic || !(probe > 0)) return {};
  SurfaceHeights grid = empty_grid(context, container, step);
  if (grid.count[0] * grid.count[1] == 0) return {};
  grid.probe = probe;
  auto centre = centre_heights(grid, swollen_spheres(snapshot, context, container, grid));
  leave_out(grid, container, centre, infinite);
  roll(grid, padded(grid, centre, container));
  leave_out(grid, container, grid.height, std::numeric_limits<double>::quiet_NaN());
  return grid;
}

}  // namespace packstone::analysis
