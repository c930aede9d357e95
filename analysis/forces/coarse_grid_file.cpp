// Coarse-grained fields on a grid as a file of VTK.
#include <algorithm>

#include "analysis/forces/coarse_grid.hpp"
#include "analysis/image_data.hpp"
#include "analysis/result.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

const std::vector<std::string> vector_names = {"x", "y", "z"};
const std::vector<std::string> tensor_names = {"xx", "yy", "zz", "xy", "yz", "xz"};  // VTK's order

void put_vector(const Vec3& vector, double* values) { std::copy_n(vector.data(), 3, values); }

/// The symmetric part.
void put_tensor(const Mat3& tensor, double* values) {
  const Mat3 s = symmetric(tensor);
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(values) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
}

std::vector<CellArray> arrays_of(const CoarseGrid& grid, const KnownFields& known) {
  // value(fields of a cell, numbers to write)
  const auto array = [&](const char* name, const std::vector<std::string>& components, const auto& value) {
    return CellArray{name, components, [&grid, value](std::size_t k, double* out) { value(grid.at(k), out); }};
  };
  using Cell = CoarseCell;
  std::vector<CellArray> arrays = {
      array("solid_fraction", {}, [](const Cell& c, double* v) { *v = c.solid_fraction; })};
  if (known.mass) arrays.push_back(array("density", {}, [](const Cell& c, double* v) { *v = c.density; }));
  if (known.velocity) {
    arrays.push_back(array("momentum", vector_names, [](const Cell& c, double* v) { put_vector(c.momentum, v); }));
    arrays.push_back(array("velocity", vector_names, [](const Cell& c, double* v) {
      put_vector(c.density > 0 ? Vec3(c.momentum / c.density) : Vec3::Constant(no_value), v);
    }));
    arrays.push_back(array("kinetic_pressure", {}, [](const Cell& c, double* v) { *v = pressure(c.kinetic); }));
    arrays.push_back(array("granular_temperature", {}, [](const Cell& c, double* v) {
      *v = c.density > 0 ? pressure(c.kinetic) / c.density : no_value;
    }));
  }
  if (known.forces) {
    arrays.push_back(
        array("stress", tensor_names, [](const Cell& c, double* v) { put_tensor(c.contact + c.kinetic, v); }));
    arrays.push_back(array("pressure", {}, [](const Cell& c, double* v) { *v = pressure(c.contact + c.kinetic); }));
    arrays.push_back(array("contact_stress", tensor_names, [](const Cell& c, double* v) { put_tensor(c.contact, v); }));
    arrays.push_back(array("wall_force", vector_names, [](const Cell& c, double* v) { put_vector(c.wall_force, v); }));
  }
  return arrays;
}

}  // namespace

void write_coarse_fields(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options) {
  constexpr const char* what = "a file of coarse-grained fields";
  require_image_extension(path, what);  // before the work
  const Context context = make_context(snapshot, options);
  const ForceNetwork network = force_network(snapshot);
  const CoarseGrid grid = coarse_grid(snapshot, context, network);
  if (grid.cells() == 0) {
    throw InputError(path.string() + ": there is nothing to coarse-grain: " +
                     (snapshot.size() == 0 ? "no particles" : "all radii are 0"));
  }
  write_image_data(path, grid, arrays_of(grid, known_fields(snapshot, network)));
}

}  // namespace packstone::analysis
