#include "analysis/packing/fraction_map.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/mean_diameter.hpp"
#include "analysis/packing/fractions.hpp"
#include "analysis/packing/images.hpp"
#include "analysis/packing/interior.hpp"
#include "analysis/packing/overlap_volume.hpp"

namespace packstone::analysis {

namespace {

constexpr double cells_a_particle = 8;  // of the default cell, at most
constexpr std::size_t most_bands = 32;  // for threads to share

struct Ball {
  Vec3 centre;
  double radius;
};

/// The box about the container, from floor to the highest sphere.
BoxRegion mapped_box(const Snapshot& snapshot, const Context& context, const Container& container) {
  const BedFrame& frame = context.frame;
  const Domain& domain = snapshot.domain;
  const double height = frame.periodic ? frame.extent : frame.top(snapshot.radius);
  const auto [low, high] = std::minmax({frame.floor, frame.floor + frame.sign * height});
  BoxRegion box = bounds(container.column(0, low, high));
  for (int k = 0; k < 3; ++k) {
    if (domain.periodic[k]) continue;
    box.min[k] = std::max(box.min[k], domain.min[k]);
    box.max[k] = std::min(box.max[k], domain.max[k]);
  }
  return box;
}

double cell_width(const Snapshot& snapshot, const Context& context, double volume) {
  if (context.options.map_cell > 0) return context.options.map_cell;
  return suitable_width(volume_mean_diameter(snapshot.radius), volume,
                        cells_a_particle * static_cast<double>(snapshot.size()), most_map_cells / 2);
}

/// Cells along one axis, from first to without last.
struct Range {
  std::size_t first, last;

  std::size_t size() const { return last - first; }
};

Range cells_between(const FractionMap& map, int axis, double lower, double upper) {
  const double count = static_cast<double>(map.count[axis]);
  const auto cell = [&](double x) { return std::floor((x - map.origin[axis]) / map.spacing[axis]); };
  return {static_cast<std::size_t>(std::clamp(cell(lower), 0.0, count)),
          static_cast<std::size_t>(std::clamp(cell(upper) + 1, 0.0, count))};
}

/// Adds spheres to the cells that they touch. The volume below a corner of the grid, differenced along the three axes,
/// takes one evaluation a corner rather than eight a cell.
class SphereAdder {
 public:
  explicit SphereAdder(FractionMap& map) : map_(map), cell_volume_(map.cell_volume()) {}

  void add(const Ball& ball, const Range& layers) {
    const Range x = cells_between(map_, 0, ball.centre.x() - ball.radius, ball.centre.x() + ball.radius);
    const Range y = cells_between(map_, 1, ball.centre.y() - ball.radius, ball.centre.y() + ball.radius);
    if (x.first >= x.last || y.first >= y.last) return;
    below_layer(ball, x, y, layers.first, under_);
    for (std::size_t z = layers.first; z < layers.last; ++z) {
      below_layer(ball, x, y, z + 1, over_);
      for (std::size_t j = 0; j < y.size(); ++j) {
        double* const row = &map_.fraction[((z * map_.count[1]) + y.first + j) * map_.count[0] + x.first];
        for (std::size_t i = 0; i < x.size(); ++i)
          row[i] += std::max(0.0, cell_part(i, j, x.size() + 1)) / cell_volume_;
      }
      under_.swap(over_);
    }
  }

 private:
  double corner(int axis, std::size_t index) const {
    return map_.origin[axis] + map_.spacing[axis] * static_cast<double>(index);
  }

  /// Of the sphere, below every corner of the grid at the lower side of a layer.
  void below_layer(const Ball& ball, const Range& x, const Range& y, std::size_t z, std::vector<double>& volume) {
    volume.clear();
    const double height = corner(2, z) - ball.centre.z();
    for (std::size_t j = y.first; j <= y.last; ++j) {
      for (std::size_t i = x.first; i <= x.last; ++i) {
        volume.push_back(sphere_corner_volume(
            ball.radius, {corner(0, i) - ball.centre.x(), corner(1, j) - ball.centre.y(), height}));
      }
    }
  }

  /// Of the layer between under_ and over_, in one cell of it.
  double cell_part(std::size_t i, std::size_t j, std::size_t row) const {
    const auto column = [&](std::size_t k) { return over_[k] - under_[k]; };
    const std::size_t k = j * row + i;
    return (column(k + row + 1) - column(k + row)) - (column(k + 1) - column(k));
  }

  FractionMap& map_;
  double cell_volume_;
  std::vector<double> under_, over_;
};

/// All images of spheres that reach the grid, sorted by the bands of layers that they touch; within a band by row.
struct Bands {
  std::size_t layers;              // of a band
  std::vector<std::size_t> begin;  // (bands + 1)
  std::vector<Ball> ball;

  std::size_t count() const { return begin.size() - 1; }
};

template <class Visit>
void for_each_band(const FractionMap& map, const Ball& ball, std::size_t layers, Visit&& visit) {
  const Range z = cells_between(map, 2, ball.centre.z() - ball.radius, ball.centre.z() + ball.radius);
  if (z.first >= z.last) return;
  for (std::size_t band = z.first / layers; band <= (z.last - 1) / layers; ++band) visit(band);
}

Bands sorted_into_bands(const Snapshot& snapshot, const FractionMap& map) {
  const BoxRegion box{map.origin, map.cell(map.count[0] - 1, map.count[1] - 1, map.count[2] - 1).max};
  Bands bands;
  bands.layers = (map.count[2] + most_bands - 1) / most_bands;
  bands.begin.assign((map.count[2] + bands.layers - 1) / bands.layers + 1, 0);
  const auto for_each_piece = [&](const auto& visit) {
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      const double r = snapshot.radius[i];
      if (!(r > 0)) continue;
      for_each_image(snapshot.domain, snapshot.position[i], r, box, [&](const Vec3& image) {
        const Ball ball{image, r};
        for_each_band(map, ball, bands.layers, [&](std::size_t band) { visit(band, ball); });
      });
    }
  };
  for_each_piece([&](std::size_t band, const Ball&) { ++bands.begin[band + 1]; });
  for (std::size_t b = 0; b < bands.count(); ++b) bands.begin[b + 1] += bands.begin[b];
  bands.ball.resize(bands.begin.back());
  std::vector<std::size_t> next(bands.begin.begin(), bands.begin.end() - 1);
  for_each_piece([&](std::size_t band, const Ball& ball) { bands.ball[next[band]++] = ball; });
  return bands;
}

bool holds(const RegionShape& region, const BoxRegion& cell) {
  if (const auto* box = std::get_if<BoxRegion>(&region)) {
    return (cell.min - box->min).minCoeff() >= 0 && (box->max - cell.max).minCoeff() >= 0;
  }
  const auto& ring = std::get<RingRegion>(region);
  double farthest = 0;
  for (int k = 0; k < 3; ++k) {
    if (k == ring.axis) continue;
    const double side = std::max(ring.centre[k] - cell.min[k], cell.max[k] - ring.centre[k]);
    farthest += side * side;
  }
  return cell.min[ring.axis] >= ring.lower && cell.max[ring.axis] <= ring.upper && farthest <= ring.outer * ring.outer;
}

struct Spread {
  double cells = 0, mean = 0, deviation = 0;
};

Spread spread_over(const FractionMap& map, const RegionShape& region) {
  Spread spread;
  double sum = 0, squares = 0;
  const auto for_each_inside = [&](const auto& visit) {
    std::size_t k = 0;
    for (std::size_t z = 0; z < map.count[2]; ++z) {
      for (std::size_t y = 0; y < map.count[1]; ++y) {
        for (std::size_t x = 0; x < map.count[0]; ++x, ++k) {
          if (holds(region, map.cell(x, y, z))) visit(map.fraction[k]);
        }
      }
    }
  };
  for_each_inside([&](double f) {
    sum += f;
    ++spread.cells;
  });
  spread.mean = sum / std::max(spread.cells, 1.0);
  for_each_inside([&](double f) { squares += (f - spread.mean) * (f - spread.mean); });
  if (spread.cells > 1) spread.deviation = std::sqrt(squares / (spread.cells - 1));
  return spread;
}

}  // namespace

FractionMap fraction_map(const Snapshot& snapshot, const Context& context, const Container& container) {
  const BoxRegion box = mapped_box(snapshot, context, container);
  if (snapshot.size() == 0 || !((box.max - box.min).minCoeff() > 0)) return {};
  const double width = cell_width(snapshot, context, (box.max - box.min).prod());
  FractionMap map{divided(box, width, most_map_cells, "a map"), {}};
  map.fraction.assign(map.cells(), 0.0);
  const Bands bands = sorted_into_bands(snapshot, map);
#pragma omp parallel
  {
    SphereAdder adder(map);
#pragma omp for schedule(dynamic)
    for (std::size_t band = 0; band < bands.count(); ++band) {
      for (std::size_t k = bands.begin[band]; k < bands.begin[band + 1]; ++k) {
        const Ball& ball = bands.ball[k];
        const Range z = cells_between(map, 2, ball.centre.z() - ball.radius, ball.centre.z() + ball.radius);
        adder.add(ball, {std::max(z.first, band * bands.layers), std::min(z.last, (band + 1) * bands.layers)});
      }
    }
  }
  return map;
}

void add_map(MeasureResult& result, const Snapshot& snapshot, const Context& context, const Container& container,
             const Interior& interior) {
  const std::string cells =
      "cells of a regular grid, about one mean diameter (sum d^4 / sum d^3) or as chosen wide, that lie wholly in the "
      "region of interior_fraction; exact parts of spheres, overlaps counted twice";
  Quantity mean{.key = "map_fraction_mean",
                .label = "mean local solid fraction",
                .definition = "mean of the solid fraction over the " + cells};
  Quantity deviation{.key = "map_fraction_deviation",
                     .label = "spread of local solid fraction",
                     .definition = "sample standard deviation of the solid fraction over the " + cells};
  Quantity size{.key = "map_cell",
                .label = "cell of the map",
                .unit = "m",
                .definition = "cube root of the volume of a cell of the map"};
  const FractionMap map = fraction_map(snapshot, context, container);
  const Spread spread = interior.shape ? spread_over(map, *interior.shape) : Spread{};
  const std::string few = interior.shape ? "too few cells lie wholly in the interior" : interior.reason;
  if (map.cells() > 0) {
    size.value = std::cbrt(map.cell_volume());
  } else {
    size = not_applicable(size, snapshot.size() == 0 ? "no particles" : "no particle lies above the floor");
  }
  mean.value = spread.mean;
  deviation.value = spread.deviation;
  result.quantities.push_back(spread.cells > 0 ? mean : not_applicable(mean, few));
  result.quantities.push_back(spread.cells > 1 ? deviation : not_applicable(deviation, few));
  result.quantities.push_back(size);
}

}  // namespace packstone::analysis
