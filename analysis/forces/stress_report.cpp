// Stress of the bulk, of layers and of particles as quantities and tables.
#include <cmath>

#include "analysis/forces/histogram.hpp"
#include "analysis/forces/parts.hpp"
#include "analysis/forces/stress.hpp"
#include "core/bed.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

const std::string bulk_region =
    " of the bulk (10 % to 80 % of bed_height, the whole domain where it is periodic along up), compression positive";

Quantity pascals(const std::string& key, const std::string& label, const std::string& definition) {
  return {.key = key, .label = label, .unit = "Pa", .definition = definition};
}

struct BulkQuantities {
  Quantity pressure = pascals(
      "stress_pressure", "pressure of the bulk",
      "trace of the stress / 3" + bulk_region +
          "; stress = (1/V) sum_c f (x) l + (1/V) sum m v' (x) v' (Love-Weber): f the force on a contact's first "
          "particle, l the part of the branch from the second's centre (from the wall) to the first's that lies in the "
          "region, v' the velocity against the region's mean; exact for this snapshot");
  Quantity deviator = pascals("stress_deviator", "deviatoric stress of the bulk",
                              "sqrt(3/2 s:s), s the deviator of the stress' symmetric part" + bulk_region);
  Quantity major = pascals("stress_major", "major principal stress",
                           "largest eigenvalue of the symmetric part of the stress" + bulk_region);
  Quantity intermediate = pascals("stress_intermediate", "intermediate principal stress",
                                  "second eigenvalue of the symmetric part of the stress" + bulk_region);
  Quantity minor = pascals("stress_minor", "minor principal stress",
                           "smallest eigenvalue of the symmetric part of the stress" + bulk_region);
  Quantity angle{.key = "stress_major_angle",
                 .label = "major principal stress to the vertical",
                 .unit = "degrees",
                 .definition = "angle between the direction of stress_major and the vertical, 0 to 90"};
  Quantity asymmetry{
      .key = "stress_asymmetry",
      .label = "asymmetry of the stress",
      .definition = "|stress - its transpose| / |stress| (Frobenius)" + bulk_region + "; 0 where no torque is left"};
  Quantity kinetic = pascals("kinetic_pressure", "kinetic pressure of the bulk", "sum of m v'^2 / (3 V)" + bulk_region);

  std::vector<Quantity*> of_forces() {
    return {&pressure, &deviator, &major, &intermediate, &minor, &angle, &asymmetry};
  }
};

/// The bulk as one layer; no layer where there is none.
Layers bulk_layer(const Context& context) {
  const BedFrame& frame = context.frame;
  if (frame.periodic) return {.bottom = 0, .thickness = frame.extent, .count = 1, .periodic = true};
  const double height = context.bed.height;
  return {.bottom = bulk_lower * height,
          .thickness = (bulk_upper - bulk_lower) * height,
          .count = height > 0 ? std::size_t{1} : std::size_t{0}};
}

void set_bulk(BulkQuantities& q, const LayerStress& stress, const BedFrame& frame, bool moves) {
  const Mat3 total = stress.total();
  const PrincipalStress axes = principal(total);
  q.pressure.value = pressure(total);
  q.deviator.value = deviator(total);
  q.major.value = axes.value[0];
  q.intermediate.value = axes.value[1];
  q.minor.value = axes.value[2];
  if (total.isZero(0)) {
    q.angle = not_applicable(q.angle, "the bulk carries no stress");
    q.asymmetry = not_applicable(q.asymmetry, "the bulk carries no stress");
  } else {
    q.angle.value = angle_to_vertical(axes.direction.col(0), frame);
    q.asymmetry.value = (total - total.transpose()).norm() / total.norm();
  }
  if (moves) return;
  for (Quantity* each : q.of_forces())
    each->note = "without the kinetic part: the snapshot holds no velocities or no masses";
}

const std::vector<Column> tensor_columns = {{"xx", "Pa"}, {"yy", "Pa"}, {"zz", "Pa"},
                                            {"xy", "Pa"}, {"xz", "Pa"}, {"yz", "Pa"}};

void append_tensor(std::vector<double>& row, const Mat3& stress) {
  const Mat3 s = symmetric(stress);
  row.insert(row.end(), {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)});
}

Table principal_table(const std::vector<LayerStress>& bulk, const BedFrame& frame) {
  Table table{.key = "stress_principal",
              .caption = "Principal stresses" + bulk_region +
                         ": from the largest to the smallest, unit vectors of their directions, angles to the vertical",
              .columns = {{"stress", "Pa"}, {"x"}, {"y"}, {"z"}, {"angle", "degrees"}}};
  if (bulk.empty()) return table;
  const PrincipalStress axes = principal(bulk[0].total());
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = axes.direction.col(k);
    table.rows.push_back({axes.value[k], d.x(), d.y(), d.z(), angle_to_vertical(d, frame)});
  }
  return table;
}

Table tensor_table(const std::vector<LayerStress>& bulk) {
  Table table{.key = "stress_tensor",
              .caption = "Stress" + bulk_region +
                         ": row and columns x, y, z; rows by the force's component, "
                         "columns by the branch's",
              .columns = {{"x", "Pa"}, {"y", "Pa"}, {"z", "Pa"}}};
  for (int k = 0; k < 3 && !bulk.empty(); ++k) {
    const auto row = bulk[0].total().row(k).eval();
    table.rows.push_back({row[0], row[1], row[2]});
  }
  return table;
}

Table profile_table(const Snapshot& snapshot, const Context& context, const ForceNetwork& network) {
  Table table{.key = "stress_profile",
              .caption =
                  "Love-Weber stress by height above the floor, compression positive: contacts by the part of their "
                  "branch in the layer, particles' motion by their centres; symmetric part with the kinetic part, "
                  "pressure, deviator, principal stresses, angle of the largest to the vertical, kinetic pressure "
                  "(default layer one mean radius; at most 2000 layers)",
              .columns = {{"lower", "m"}, {"upper", "m"}}};
  table.columns.insert(table.columns.end(), tensor_columns.begin(), tensor_columns.end());
  for (const char* name : {"pressure", "deviator", "major", "intermediate", "minor"}) {
    table.columns.push_back({name, "Pa"});
  }
  table.columns.push_back({"angle", "degrees"});
  table.columns.push_back({"kinetic_pressure", "Pa"});
  if (!network.missing.empty()) return table;

  const Layers layers = layers_over_bed(context.frame, snapshot.radius, profile_thickness(context));
  const auto stress = layer_stress(snapshot, context.frame, network, layers);
  for (std::size_t k = 0; k < layers.count; ++k) {
    const Mat3 total = stress[k].total();
    const PrincipalStress axes = principal(total);
    const double angle = total.isZero(0) ? no_value : angle_to_vertical(axes.direction.col(0), context.frame);
    std::vector<double> row{layers.lower(k), layers.upper(k)};
    append_tensor(row, total);
    row.insert(row.end(), {pressure(total), deviator(total), axes.value[0], axes.value[1], axes.value[2], angle,
                           pressure(stress[k].kinetic)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

void add_particle_pressure(MeasureResult& result, const Snapshot& snapshot, const ForceNetwork& network) {
  Quantity mean = pascals("particle_pressure_mean", "mean pressure of the particles",
                          "mean over all particles of volume V_i = 4/3 pi r^3 of tr(sigma_i) / 3, sigma_i = (1/V_i) "
                          "sum_c f_c (x) l_c: f the force on the particle, l from the contact to its centre, the share "
                          "r_i / (r_i + r_j) of the branch; compression positive");
  Quantity spread = pascals("particle_pressure_deviation", "spread of the particles' pressure",
                            "standard deviation of tr(sigma_i) / 3 over the same particles");
  std::vector<double> pressures;
  if (network.missing.empty()) {
    const auto moments = particle_force_moments(snapshot, network);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      if (const double volume = sphere_volume(snapshot.radius[i]); volume > 0) {
        pressures.push_back(pressure(moments[i]) / volume);
      }
    }
  }
  if (!network.missing.empty() || pressures.empty()) {
    const std::string reason = network.missing.empty() ? "all radii are 0" : network.missing;
    for (Quantity* each : {&mean, &spread}) *each = not_applicable(*each, reason);
  } else {
    const double n = static_cast<double>(pressures.size());
    double sum = 0, squares = 0;
    for (const double p : pressures) sum += p;
    for (const double p : pressures) squares += (p - sum / n) * (p - sum / n);
    mean.value = sum / n;
    spread.value = std::sqrt(squares / n);
  }
  result.quantities.push_back(mean);
  result.quantities.push_back(spread);
  result.tables.push_back(histogram(
      {.key = "particle_pressure_distribution", .caption = "Particles by their pressure over particle_pressure_mean"},
      pressures, mean.value.value_or(0)));
}

}  // namespace

void add_stress(MeasureResult& result, const Snapshot& snapshot, const Context& context, const ForceNetwork& network) {
  BulkQuantities q;
  const Layers layer = bulk_layer(context);
  const bool moves = !velocities(snapshot).empty();
  std::vector<LayerStress> bulk;
  if (layer.count > 0 && snapshot.size() > 0) bulk = layer_stress(snapshot, context.frame, network, layer);
  if (bulk.empty() || !moves) {
    q.kinetic =
        not_applicable(q.kinetic, bulk.empty() ? "there is no bulk" : "the snapshot holds no velocities or no masses");
  } else {
    q.kinetic.value = pressure(bulk[0].kinetic);
  }
  if (!network.missing.empty()) bulk.clear();
  if (bulk.empty()) {
    const std::string reason = network.missing.empty() ? "there is no bulk" : network.missing;
    for (Quantity* each : q.of_forces()) *each = not_applicable(*each, reason);
  } else {
    set_bulk(q, bulk[0], context.frame, moves);
  }
  for (Quantity* each : q.of_forces()) result.quantities.push_back(*each);
  result.quantities.push_back(q.kinetic);
  add_particle_pressure(result, snapshot, network);
  result.tables.push_back(principal_table(bulk, context.frame));
  result.tables.push_back(tensor_table(bulk));
  result.tables.push_back(profile_table(snapshot, context, network));
}

}  // namespace packstone::analysis
