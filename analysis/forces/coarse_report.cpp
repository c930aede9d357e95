// Coarse-grained fields as tables.

#include <fmt/format.h>

#include "analysis/forces/coarse_fields.hpp"
#include "analysis/forces/parts.hpp"

namespace packstone::analysis {

namespace {

std::vector<Column> field_columns() {
  return {{"solid_fraction"},    {"density", "kg/m3"}, {"velocity_x", "m/s"}, {"velocity_y", "m/s"},
          {"velocity_z", "m/s"}, {"xx", "Pa"},         {"yy", "Pa"},          {"zz", "Pa"},
          {"xy", "Pa"},          {"xz", "Pa"},         {"yz", "Pa"},          {"kinetic_pressure", "Pa"}};
}

void append_fields(std::vector<double>& row, const CoarseCell& cell, const KnownFields& known) {
  row.push_back(cell.solid_fraction);
  row.push_back(known.mass ? cell.density : no_value);
  for (int k = 0; k < 3; ++k) {
    row.push_back(known.velocity && cell.density > 0 ? cell.momentum[k] / cell.density : no_value);
  }
  const Mat3 stress = symmetric(cell.contact + cell.kinetic);
  for (const double s : {stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1), stress(0, 2), stress(1, 2)}) {
    row.push_back(known.forces ? s : no_value);
  }
  row.push_back(known.velocity ? pressure(cell.kinetic) : no_value);
}

std::string kernel_text(Kernel kernel, double width) {
  return fmt::format("{} kernel of width {:g} m", kernel == Kernel::lucy ? "Lucy's" : "Gaussian", width);
}

Table profile_table(const Snapshot& snapshot, const Context& context, const ForceNetwork& network, double width) {
  const Kernel kind = context.options.forces.kernel;
  Table table{
      .key = "coarse_profile",
      .caption =
          "Coarse-grained fields (Goldhirsch, Granular Matter 12 (2010) 239) by height above the floor, " +
          kernel_text(kind, width) +
          ": means over the cross-section and the layer of solid fraction, density, velocity, stress (contacts and "
          "motion, symmetric part, compression positive), kinetic pressure, and upward force of "
          "boundaries on the particles; what lies farther below the floor than the kernel's range is "
          "left out",
      .columns = {{"lower", "m"}, {"upper", "m"}}};
  const auto columns = field_columns();
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  table.columns.push_back({"wall_force", "N/m3"});
  if (!(width > 0)) return table;

  const CoarseKernel kernel(kind, width);
  const BedFrame& frame = context.frame;
  const Layers layers = coarse_layers(frame, snapshot.radius, kernel, width, profile_thickness(context));
  const auto cells = coarse_profile(snapshot, frame, network, kernel, layers);
  const KnownFields known = known_fields(snapshot, network);
  for (std::size_t k = 0; k < layers.count; ++k) {
    std::vector<double> row{layers.lower(k), layers.upper(k)};
    append_fields(row, cells[k], known);
    row.push_back(known.forces ? frame.sign * cells[k].wall_force[frame.axis] : no_value);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

void add_coarse_fields(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                       const ForceNetwork& network) {
  const double width = kernel_width(snapshot, context);
  Quantity used{.key = "kernel_width",
                .label = "width of the coarse-graining kernel",
                .unit = "m",
                .definition =
                    "standard deviation along an axis of the kernel of coarse_profile (of the Gaussian before its cut "
                    "at 3 widths; Lucy's range is sqrt(12) widths); default one mean radius, so that Lucy's kernel is "
                    "1.3 mean diameters wide at half its height"};
  if (width > 0) {
    used.value = width;
  } else {
    used = not_applicable(used, snapshot.size() == 0 ? "no particles" : "all radii are 0");
  }
  result.quantities.push_back(used);
  result.tables.push_back(profile_table(snapshot, context, network, width));
}

}  // namespace packstone::analysis
