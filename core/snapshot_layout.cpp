#include "core/snapshot_layout.hpp"

#include <cmath>

#include <fmt/format.h>

namespace packstone {

std::string snapshot_column(const std::string& name) { return "/VTKHDF/PointData/" + name; }

std::vector<std::string> field_names(const hdf5::Reader& file) {
  std::vector<std::string> names = file.children("/VTKHDF/PointData");
  std::erase_if(names, [](const std::string& name) {
    return name == "radius" || name == "id" || name == "type" || name == "material";
  });
  return names;
}

double read_time(const hdf5::Reader& file) {
  const double time = file.dataset<double>("/VTKHDF/FieldData/time", 1, 0, 1).front();
  if (!std::isfinite(time)) file.fail(fmt::format("the time {} is not a number", time));
  return time;
}

std::size_t read_row_count(const hdf5::Reader& file) {
  const std::size_t rows = file.shape(snapshot_points).first;
  for (const std::string& name : file.children("/VTKHDF/PointData")) {
    const std::size_t there = file.shape(snapshot_column(name)).first;
    if (there != rows) file.fail(fmt::format("PointData/{} has {} rows for {} points", name, there, rows));
  }
  return rows;
}

std::vector<RowChunk> read_chunks(const hdf5::Reader& file, std::size_t rows) {
  const auto first_row = file.dataset<std::int64_t>("/packstone/chunk_first_row");
  const auto bounds = file.dataset<double>("/packstone/chunk_bounds", 6, 0, first_row.size());
  std::vector<RowChunk> chunks;
  for (std::size_t c = 0; c < first_row.size(); ++c) {
    const auto first = static_cast<std::size_t>(first_row[c]);
    const auto last = c + 1 < first_row.size() ? static_cast<std::size_t>(first_row[c + 1]) : rows;
    const std::size_t expected = c == 0 ? 0 : chunks.back().last;
    if (first != expected || last < first || last > rows) {
      file.fail("/packstone/chunk_first_row does not ascend from 0 within the rows");
    }
    const Eigen::Map<const Vec3> low(&bounds[6 * c]), high(&bounds[6 * c + 3]);
    if (!(low.array() <= high.array()).all()) file.fail("/packstone/chunk_bounds: a box ends before it begins");
    chunks.push_back({first, last, {low, high}});
  }
  if (chunks.empty() && rows > 0) file.fail("/packstone/chunk_first_row has no chunks");
  return chunks;
}

}  // namespace packstone
