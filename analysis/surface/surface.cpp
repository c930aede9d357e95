// Measure "surface": the volume under the free surface beside that of base times height.
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/measures.hpp"
#include "analysis/surface/rolling_ball.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

struct HeightStatistics {
  double mean = 0, deviation = 0;  // over the cross-section [m]
  double lowest = 0, highest = 0;
};

HeightStatistics statistics(const SurfaceHeights& surface) {
  HeightStatistics result{.lowest = std::numeric_limits<double>::infinity()};
  double columns = 0, squares = 0;
  for (const double h : surface.height) {
    if (std::isnan(h)) continue;
    const double off = h - result.mean;
    result.mean += off / ++columns;
    squares += off * (h - result.mean);
    result.lowest = std::min(result.lowest, h);
    result.highest = std::max(result.highest, h);
  }
  result.deviation = std::sqrt(squares / columns);
  return result;
}

/// Of the spheres whose centres lie in the cross-section, above the floor [m3].
double solid_below_surface(const Snapshot& snapshot, const Context& context, const Container& container) {
  double solid = 0;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    if (container.wall_distance(snapshot.position[i]) < 0) continue;
    const double r = snapshot.radius[i];
    solid += sphere_volume(r) - sphere_volume_below(r, -context.frame.height[i]);
  }
  return solid;
}

/// All of the measure's numbers, still without values.
struct SurfaceQuantities {
  Quantity volume{.key = "surface_volume",
                  .label = "volume under the free surface",
                  .unit = "m3",
                  .definition =
                      "mean height of the free surface over the cross-section, times its area; the surface: "
                      "what a ball of surface_probe rolling over the bed from above, its centre within the "
                      "side walls, does not reach (closing of the spheres by a ball: an alpha shape with "
                      "radii, seen from above); uncertainty: difference to twice surface_step"};
  Quantity fraction{.key = "surface_fraction",
                    .label = "solid fraction under the free surface",
                    .definition =
                        "solid volume above the floor of spheres with centres in the cross-section (overlaps "
                        "counted twice) over surface_volume; uncertainty: that of the volume"};
  Quantity base_height{.key = "base_height_volume",
                       .label = "base times height",
                       .unit = "m3",
                       .definition = "cross_section times bed_height, to compare with surface_volume"};
  Quantity height{.key = "surface_height",
                  .label = "mean height of the surface",
                  .unit = "m",
                  .definition = "mean over the cross-section, above the floor"};
  Quantity roughness{.key = "surface_roughness",
                     .label = "roughness of the surface",
                     .unit = "m",
                     .definition = "standard deviation of its height over the cross-section"};
  Quantity lowest{.key = "surface_lowest",
                  .label = "lowest point of the surface",
                  .unit = "m",
                  .definition = "above the floor, over the columns"};
  Quantity highest{.key = "surface_highest",
                   .label = "highest point of the surface",
                   .unit = "m",
                   .definition = "above the floor, over the columns"};
  Quantity probe{.key = "surface_probe",
                 .label = "radius of the rolling ball",
                 .unit = "m",
                 .definition = "as asked for; default: half of sum d^4 / sum d^3"};
  Quantity step{.key = "surface_step",
                .label = "step of the surface",
                .unit = "m",
                .definition =
                    "greatest distance of neighbouring columns along a side; as asked for; default: an eighth "
                    "of the smaller of the ball's and the volume-mean radius"};

  std::vector<Quantity> all() const {
    return {volume, fraction, base_height, height, roughness, lowest, highest, probe, step};
  }
};

std::string reason_against(const Snapshot& snapshot, const Context& context, const Container& container) {
  if (snapshot.size() == 0) return "no particles";
  if (context.frame.periodic) return "the domain is periodic along up: the packing has no surface";
  if (!container.unknown.empty()) return container.unknown;
  if (!(surface_probe(snapshot, context) > 0)) return "all radii are 0";
  return region_volume(container.column(0, 0, 1)) > 0 ? "" : "the cross-section is empty";
}

}  // namespace

MeasureResult measure_surface(const Snapshot& snapshot, const Context& context) {
  MeasureResult result{.name = "surface"};
  SurfaceQuantities q;
  const Container container = container_of(snapshot, context.frame);
  const auto without_values = [&](const std::string& reason) {
    for (const Quantity& each : q.all()) result.quantities.push_back(not_applicable(each, reason));
    return result;
  };
  if (const std::string reason = reason_against(snapshot, context, container); !reason.empty()) {
    return without_values(reason);
  }
  const double area = region_volume(container.column(0, 0, 1));
  const double step = surface_step(snapshot, context, container);
  const SurfaceHeights surface = free_surface(snapshot, context, container, step);
  const HeightStatistics fine = statistics(surface);
  if (!(fine.mean > 0)) return without_values("no column holds anything above the floor");
  const double coarse = statistics(free_surface(snapshot, context, container, 2 * step)).mean;
  const double relative = std::abs(coarse - fine.mean) / fine.mean;

  q.volume.value = area * fine.mean;
  q.volume.uncertainty = relative * *q.volume.value;
  q.fraction.value = solid_below_surface(snapshot, context, container) / *q.volume.value;
  q.fraction.uncertainty = relative * *q.fraction.value;
  q.base_height.value = context.frame.area * context.bed.height;
  q.height.value = fine.mean;
  q.roughness.value = fine.deviation;
  q.lowest.value = fine.lowest;
  q.highest.value = fine.highest;
  q.probe.value = surface.probe;
  q.step.value = std::max(surface.step[0], surface.step[1]);
  result.quantities = q.all();
  return result;
}

}  // namespace packstone::analysis
