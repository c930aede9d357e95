// Measure "packing": how densely and how high the bed lies.
#include <cmath>

#include "analysis/layers.hpp"
#include "analysis/measures.hpp"
#include "analysis/packing/container.hpp"
#include "analysis/packing/fractions.hpp"
#include "analysis/packing/interior.hpp"
#include "analysis/packing/lens.hpp"
#include "core/bed.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

constexpr double error_blocks = 10;  // of the bulk, for the uncertainty

const char* const fraction_definition =
    "solid volume (exact sphere slabs, overlaps counted twice) between 10 % and 80 % of bed_height above the floor, "
    "over "
    "that slab's volume with the bed's cross-section; uncertainty: standard error over equal blocks of the slab, at "
    "least one number-mean diameter thick";
const char* const height_definition =
    "height of the bed that holds all solid at bulk_fraction: h = solid_volume / (cross_section * bulk_fraction), "
    "solved "
    "together with bulk_fraction; above the floor (the highest flat upward boundary, else the domain's lower face)";
const char* const periodic_fraction_definition =
    "solid volume (overlaps counted twice) over the volume of the domain, which is periodic along up: no floor, no "
    "surface; uncertainty: standard error over equal horizontal blocks, at least one number-mean diameter thick";

struct Slab {
  double lower, upper;  // [m]
};

/// Standard error of the fraction over blocks of the slab; none when it is too thin for two.
std::optional<double> fraction_error(const Snapshot& snapshot, const Context& context, const Slab& slab) {
  const double thickness = slab.upper - slab.lower;
  const double blocks = std::min(error_blocks, std::floor(thickness / (2 * context.mean_radius)));
  if (!(blocks >= 2)) return std::nullopt;
  const Layers layers{.bottom = slab.lower,
                      .thickness = thickness / blocks,
                      .count = static_cast<std::size_t>(blocks),
                      .periodic = context.frame.periodic};
  const auto volumes = volume_by_layer(context.frame.height, snapshot.radius, layers);
  const double block_volume = context.frame.area * layers.thickness;
  double mean = 0, squares = 0;
  for (double v : volumes) mean += v / block_volume / blocks;
  for (double v : volumes) squares += (v / block_volume - mean) * (v / block_volume - mean);
  return std::sqrt(squares / (blocks - 1) / blocks);
}

Table vertical_profile(const Snapshot& snapshot, const Context& context) {
  const double wanted = context.options.profile_layer > 0 ? context.options.profile_layer : context.mean_radius;
  const Layers layers = layers_over_bed(context.frame, snapshot.radius, wanted);
  const auto volumes = volume_by_layer(context.frame.height, snapshot.radius, layers);
  Table table{.key = "profile",
              .caption =
                  "Solid fraction by height above the floor: exact sphere slabs over the bed's cross-section "
                  "times the layer's thickness (default one mean radius; at most 2000 layers)",
              .columns = {{"lower", "m"}, {"upper", "m"}, {"fraction"}}};
  for (std::size_t k = 0; k < layers.count; ++k) {
    table.rows.push_back({layers.lower(k), layers.upper(k), volumes[k] / (context.frame.area * layers.thickness)});
  }
  return table;
}

std::string reason_against(const Snapshot& snapshot, double solid) {
  if (snapshot.size() == 0) return "no particles";
  return solid > 0 ? "" : "all radii are 0";
}

void add_bed(MeasureResult& result, const Snapshot& snapshot, const Context& context, double solid) {
  const BedFrame& frame = context.frame;
  Quantity fraction{.key = "bulk_fraction",
                    .label = "bulk solid fraction",
                    .definition = frame.periodic ? periodic_fraction_definition : fraction_definition};
  Quantity height{.key = "bed_height", .label = "bed height", .unit = "m", .definition = height_definition};
  std::string reason = reason_against(snapshot, solid);
  if (reason.empty() && !frame.periodic && !(context.bed.height > 0)) reason = "all particles lie below the floor";
  if (!reason.empty()) {
    fraction = not_applicable(fraction, reason);
    height = not_applicable(height, reason);
  } else if (frame.periodic) {
    fraction.value = solid / (frame.area * frame.extent);
    fraction.uncertainty = fraction_error(snapshot, context, {0, frame.extent});
    height = not_applicable(height, "the domain is periodic along up: the packing has no surface");
  } else {
    const BedState& bed = context.bed;
    fraction.value = bed.bulk_fraction;
    fraction.uncertainty = fraction_error(snapshot, context, {bulk_lower * bed.height, bulk_upper * bed.height});
    height.value = bed.height;
  }
  result.quantities.push_back(fraction);
  result.quantities.push_back(height);
}

void add_overlap_share(MeasureResult& result, const Snapshot& snapshot, const Context& context, double solid) {
  Quantity share{.key = "overlap_share",
                 .label = "volume counted twice",
                 .definition =
                     "sum of the exact lens volumes of all pairs in contact over solid_volume: by so much the "
                     "solid fractions count overlaps twice"};
  if (const std::string reason = reason_against(snapshot, solid); !reason.empty()) {
    result.quantities.push_back(not_applicable(share, reason));
    return;
  }
  double volume = 0;
  for (const auto& pair : context.contacts.pairs) {
    volume += lens_volume(snapshot.radius[pair.first], snapshot.radius[pair.second], pair.overlap);
  }
  share.value = volume / solid;
  share.note = context.contacts.source();
  result.quantities.push_back(share);
}

}  // namespace

MeasureResult measure_packing(const Snapshot& snapshot, const Context& context) {
  double solid = 0;
  for (double r : snapshot.radius) solid += sphere_volume(r);
  MeasureResult result{.name = "packing"};
  add_bed(result, snapshot, context, solid);
  result.quantities.push_back({.key = "solid_volume",
                               .label = "solid volume",
                               .value = solid,
                               .unit = "m3",
                               .definition = "sum of the volumes of all spheres"});
  result.quantities.push_back(
      {.key = "cross_section",
       .label = "cross-section",
       .value = context.frame.area,
       .unit = "m2",
       .definition =
           "area perpendicular to up: the domain's, or that of the narrowest upright cylinder or box boundary"});
  add_overlap_share(result, snapshot, context, solid);
  const Container container = container_of(snapshot, context.frame);
  const Interior interior = interior_of(snapshot, context, container);
  add_interior(result, snapshot, context, interior);
  add_map(result, snapshot, context, container, interior);
  result.tables.push_back(vertical_profile(snapshot, context));
  add_wall_profiles(result, snapshot, context, container);
  add_regions(result, snapshot, context);
  return result;
}

}  // namespace packstone::analysis
