// The snapshot as a file: docs/format.md.
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/hdf5.hpp"
#include "core/reordered.hpp"
#include "core/snapshot.hpp"
#include "core/snapshot_checks.hpp"
#include "core/snapshot_layout.hpp"

namespace packstone {

namespace {

constexpr std::int64_t format_version = 1;
constexpr std::int64_t vtkhdf_version[2] = {1, 0};
constexpr std::uint8_t vtk_vertex = 1;

std::span<const double> flat(const std::vector<Vec3>& rows) {
  return {rows.empty() ? nullptr : rows.front().data(), rows.size() * 3};
}

void write_vtk_part(hdf5::Writer& file, const Snapshot& s, const std::vector<std::size_t>& order) {
  const auto n = static_cast<std::int64_t>(s.size());
  file.group("/VTKHDF");
  file.attribute("/VTKHDF", "Version", vtkhdf_version);
  file.text_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  for (const char* count : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    file.dataset("/VTKHDF/" + std::string(count), std::vector<std::int64_t>{n});
  }
  std::vector<std::int64_t> rows(s.size() + 1);
  std::iota(rows.begin(), rows.end(), std::int64_t{0});
  file.dataset("/VTKHDF/Offsets", rows);
  file.dataset("/VTKHDF/Connectivity", std::span<const std::int64_t>(rows).first(s.size()));
  file.dataset("/VTKHDF/Types", std::vector<std::uint8_t>(s.size(), vtk_vertex));
  file.dataset(snapshot_points, flat(reordered(s.position, order)), 3);

  file.group("/VTKHDF/PointData");
  const auto point_data = [&](const std::string& name, const auto& values, const std::string& unit,
                              std::size_t columns = 0) {
    file.dataset(snapshot_column(name), values, columns);
    file.text_attribute(snapshot_column(name), "unit", unit);
  };
  point_data("radius", reordered(s.radius, order), "m");
  point_data("id", reordered(s.id, order), "");
  point_data("type", reordered(s.type, order), "");
  point_data("material", reordered(s.material, order), "");
  for (const auto& [name, field] : s.fields) {
    const Field sorted = reordered(field, order);
    point_data(name, sorted.values, field.unit, field.components == 1 ? 0 : field.components);
  }
  file.group("/VTKHDF/FieldData");
  file.dataset("/VTKHDF/FieldData/time", std::vector<double>{s.time});
  file.dataset("/VTKHDF/FieldData/step", std::vector<std::int64_t>{s.step});
}

void write_contacts(hdf5::Writer& file, const Contacts& c) {
  std::vector<std::int64_t> pairs;
  pairs.reserve(2 * c.size());
  for (std::size_t k = 0; k < c.size(); ++k) pairs.insert(pairs.end(), {c.first[k], c.second[k]});
  file.group("/contacts");
  file.dataset("/contacts/pair", pairs, 2);
  file.dataset("/contacts/force", flat(c.force), 3);
  file.dataset("/contacts/normal", flat(c.normal), 3);
  file.dataset("/contacts/overlap", c.overlap);
  file.dataset("/contacts/point", flat(c.point), 3);
  if (!c.sliding.empty() || c.size() == 0) file.dataset("/contacts/slid", c.sliding);
  for (const auto& [name, unit] : {std::pair{"force", "N"}, {"overlap", "m"}, {"point", "m"}}) {
    file.text_attribute(std::string("/contacts/") + name, "unit", unit);
  }
}

void write_boundaries(hdf5::Writer& file, const std::vector<BoundaryRecord>& boundaries) {
  std::vector<std::string> names, kinds;
  std::vector<Vec3> points, normals, axes, surface_points;
  std::vector<double> cross_sections;
  std::vector<std::uint8_t> one_sided;
  std::vector<std::int32_t> corners;
  std::vector<std::int64_t> first_point = {0}, first_triangle = {0};
  for (const auto& boundary : boundaries) {
    names.push_back(boundary.name);
    kinds.push_back(boundary.kind);
    points.push_back(boundary.point);
    normals.push_back(boundary.normal);
    axes.push_back(boundary.axis);
    cross_sections.push_back(boundary.cross_section);
    one_sided.push_back(boundary.one_sided ? 1 : 0);
    surface_points.insert(surface_points.end(), boundary.points.begin(), boundary.points.end());
    for (const auto& triangle : boundary.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
    first_point.push_back(static_cast<std::int64_t>(surface_points.size()));
    first_triangle.push_back(static_cast<std::int64_t>(corners.size() / 3));
  }
  file.group("/boundaries");
  file.texts("/boundaries/name", names);
  file.texts("/boundaries/kind", kinds);
  file.dataset("/boundaries/point", flat(points), 3);
  file.dataset("/boundaries/normal", flat(normals), 3);
  file.dataset("/boundaries/axis", flat(axes), 3);
  file.dataset("/boundaries/cross_section", cross_sections);
  file.dataset("/boundaries/one_sided", one_sided);
  file.dataset("/boundaries/surface_points", flat(surface_points), 3);
  file.dataset("/boundaries/surface_triangles", corners, 3);
  file.dataset("/boundaries/surface_first_point", first_point);
  file.dataset("/boundaries/surface_first_triangle", first_triangle);
  for (const auto& [name, unit] : {std::pair{"point", "m"}, {"cross_section", "m2"}, {"surface_points", "m"}}) {
    file.text_attribute(std::string("/boundaries/") + name, "unit", unit);
  }
}

void write_context(hdf5::Writer& file, const Snapshot& s) {
  std::vector<std::string> group_names, group_materials;
  std::vector<double> densities;
  for (const auto& group : s.groups) {
    group_names.push_back(group.name);
    group_materials.push_back(group.material);
    densities.push_back(group.density);
  }
  file.group("/scene");
  file.text("/scene/text", s.scene_text);
  file.text("/scene/hash", s.scene_hash);
  file.texts("/scene/material_name", s.material_names);
  file.texts("/scene/group_name", group_names);
  file.texts("/scene/group_material", group_materials);
  file.dataset("/scene/group_density", densities);
}

void write_header(hdf5::Writer& file, const Snapshot& s, const std::vector<std::size_t>& order) {
  file.group("/packstone");
  file.dataset("/packstone/format_version", std::vector<std::int64_t>{format_version});
  file.text("/packstone/program", s.program);
  if (!s.notes.empty()) file.texts("/packstone/notes", s.notes);
  std::vector<std::uint8_t> periodic(s.domain.periodic.begin(), s.domain.periodic.end());
  file.dataset("/packstone/domain", flat({s.domain.min, s.domain.max}), 3);
  file.dataset("/packstone/periodic", periodic);
  file.dataset("/packstone/gravity", flat({s.gravity}));

  std::vector<std::int64_t> first_row;
  std::vector<Vec3> bounds;  // low and high corner of the spheres of each chunk
  for (std::size_t first = 0; first < order.size(); first += rows_a_chunk) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t k = first; k < std::min(first + rows_a_chunk, order.size()); ++k) {
      const double r = s.radius[order[k]];
      low = low.cwiseMin(s.position[order[k]].array().operator-(r).matrix());
      high = high.cwiseMax(s.position[order[k]].array().operator+(r).matrix());
    }
    first_row.push_back(static_cast<std::int64_t>(first));
    bounds.insert(bounds.end(), {low, high});
  }
  file.dataset("/packstone/chunk_first_row", first_row);
  file.dataset("/packstone/chunk_bounds", flat(bounds), 6);
}

Contacts read_contacts(const hdf5::Reader& file) {
  Contacts c;
  const auto pairs = file.dataset<std::int64_t>("/contacts/pair", 2);
  for (std::size_t k = 0; k + 1 < pairs.size(); k += 2) {
    c.first.push_back(pairs[k]);
    c.second.push_back(pairs[k + 1]);
  }
  c.force = file.vectors("/contacts/force", 0, c.size());
  c.normal = file.vectors("/contacts/normal", 0, c.size());
  c.overlap = file.dataset<double>("/contacts/overlap", 1, 0, c.size());
  c.point = file.vectors("/contacts/point", 0, c.size());
  if (file.has("/contacts/slid")) c.sliding = file.dataset<std::uint8_t>("/contacts/slid", 1, 0, c.size());
  return c;
}

/// Where each of count boundaries begins among the rows of a dataset, and where the last ends.
std::vector<std::size_t> read_offsets(const hdf5::Reader& file, const std::string& name, std::size_t count,
                                      std::size_t rows) {
  const auto offsets = file.dataset<std::int64_t>(name, 1, 0, count + 1);
  if (offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(rows) ||
      !std::is_sorted(offsets.begin(), offsets.end())) {
    file.fail(name + " does not ascend from 0 to the number of rows");
  }
  return {offsets.begin(), offsets.end()};
}

void read_surfaces(const hdf5::Reader& file, std::vector<BoundaryRecord>& boundaries) {
  const auto points = file.vectors("/boundaries/surface_points");
  const auto corners = file.dataset<std::int32_t>("/boundaries/surface_triangles", 3);
  const auto first_point = read_offsets(file, "/boundaries/surface_first_point", boundaries.size(), points.size());
  const auto first_triangle =
      read_offsets(file, "/boundaries/surface_first_triangle", boundaries.size(), corners.size() / 3);
  if (!all_finite(points)) {
    file.fail("/boundaries/surface_points holds what is not a number");
  }
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    BoundaryRecord& boundary = boundaries[k];
    boundary.points.assign(points.begin() + static_cast<std::ptrdiff_t>(first_point[k]),
                           points.begin() + static_cast<std::ptrdiff_t>(first_point[k + 1]));
    for (std::size_t t = first_triangle[k]; t < first_triangle[k + 1]; ++t) {
      const std::array triangle = {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
      const auto [low, high] = std::minmax_element(triangle.begin(), triangle.end());
      if (*low < 0 || static_cast<std::size_t>(*high) >= boundary.points.size()) {
        file.fail("/boundaries/surface_triangles refers to a point that boundary " + std::to_string(k) +
                  " does not have");
      }
      boundary.triangles.push_back(triangle);
    }
  }
}

void read_boundaries(const hdf5::Reader& file, std::vector<BoundaryRecord>& boundaries) {
  const auto names = file.texts("/boundaries/name");
  const std::size_t count = names.size();
  const auto kinds = file.texts("/boundaries/kind");
  if (kinds.size() != count) file.fail("/boundaries: name and kind differ in length");
  const auto points = file.vectors("/boundaries/point", 0, count);
  const auto normals = file.vectors("/boundaries/normal", 0, count);
  boundaries.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    boundaries[k].name = names[k];
    boundaries[k].kind = kinds[k];
    boundaries[k].point = points[k];
    boundaries[k].normal = normals[k];
  }
  if (!file.has("/boundaries/axis")) return;  // the first files knew planes only
  const auto axes = file.vectors("/boundaries/axis", 0, count);
  const auto cross_sections = file.dataset<double>("/boundaries/cross_section", 1, 0, count);
  const auto one_sided = file.dataset<std::uint8_t>("/boundaries/one_sided", 1, 0, count);
  for (std::size_t k = 0; k < count; ++k) {
    boundaries[k].axis = axes[k];
    boundaries[k].cross_section = cross_sections[k];
    boundaries[k].one_sided = one_sided[k] != 0;
  }
  read_surfaces(file, boundaries);
}

void read_context(const hdf5::Reader& file, Snapshot& s) {
  s.scene_text = file.text("/scene/text");
  s.scene_hash = file.text("/scene/hash");
  s.material_names = file.texts("/scene/material_name");
  const auto group_names = file.texts("/scene/group_name");
  const auto group_materials = file.texts("/scene/group_material");
  const auto densities = file.dataset<double>("/scene/group_density", 1, 0, group_names.size());
  if (group_materials.size() != group_names.size()) file.fail("/scene: group_name and group_material differ in length");
  for (std::size_t k = 0; k < group_names.size(); ++k) {
    s.groups.push_back({group_names[k], group_materials[k], densities[k]});
  }
  s.program = file.text("/packstone/program");
  if (file.has("/packstone/notes")) s.notes = file.texts("/packstone/notes");
  const auto corners = file.vectors("/packstone/domain", 0, 2);
  s.domain.min = corners[0];
  s.domain.max = corners[1];
  const auto periodic = file.dataset<std::uint8_t>("/packstone/periodic", 1, 0, 3);
  for (int k = 0; k < 3; ++k) s.domain.periodic[k] = periodic[k] != 0;
  const auto gravity = file.dataset<double>("/packstone/gravity", 1, 0, 3);
  s.gravity = Vec3(gravity[0], gravity[1], gravity[2]);
}

void append_rows(const hdf5::Reader& file, Snapshot& s, std::size_t first, std::size_t rows,
                 const ReadOptions& options) {
  const auto append = [](auto& to, auto&& from) {
    if (to.empty()) {
      to = std::move(from);
    } else {
      to.insert(to.end(), from.begin(), from.end());
    }
  };
  append(s.position, file.vectors(snapshot_points, first, rows));
  append(s.radius, file.dataset<double>(snapshot_column("radius"), 1, first, rows));
  append(s.id, file.dataset<std::int64_t>(snapshot_column("id"), 1, first, rows));
  append(s.type, file.dataset<std::int32_t>(snapshot_column("type"), 1, first, rows));
  append(s.material, file.dataset<std::int32_t>(snapshot_column("material"), 1, first, rows));
  if (!options.fields) return;
  for (const auto& name : field_names(file)) {
    const std::string set = snapshot_column(name);
    Field& field = s.fields[name];
    field.components = static_cast<int>(file.shape(set).second);
    field.unit = file.text_attribute(set, "unit");
    append(field.values, file.dataset<double>(set, field.components, first, rows));
  }
}

/// The particles of those chunks that can touch the region.
void read_chunks_in(const Region& region, const hdf5::Reader& file, Snapshot& s, std::size_t total,
                    const ReadOptions& options) {
  std::size_t first = 0, rows = 0;  // of chunks one after the other that can
  for (const RowChunk& chunk : read_chunks(file, total)) {
    const bool outside =
        (chunk.box.min.array() > region.max.array()).any() || (chunk.box.max.array() < region.min.array()).any();
    if (outside) continue;
    if (rows > 0 && first + rows != chunk.first) {
      append_rows(file, s, first, rows, options);
      rows = 0;
    }
    if (rows == 0) first = chunk.first;
    rows += chunk.last - chunk.first;
  }
  append_rows(file, s, first, rows, options);  // also of none, for the fields' names
}

}  // namespace

void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot) {
  const auto order = space_filling_order(snapshot);
  hdf5::Writer file(path);
  write_vtk_part(file, snapshot, order);
  if (snapshot.contacts) write_contacts(file, *snapshot.contacts);
  write_boundaries(file, snapshot.boundaries);
  write_context(file, snapshot);
  write_header(file, snapshot, order);
  file.finish(Lasting::yes);
}

Snapshot read_snapshot(const std::filesystem::path& path, const ReadOptions& options) {
  const hdf5::Reader file(path);
  if (!file.has("/packstone/format_version")) file.fail("not a packstone snapshot");
  const auto version = file.dataset<std::int64_t>("/packstone/format_version", 1, 0, 1).front();
  if (version > format_version) {
    file.fail("written by a newer packstone (format " + std::to_string(version) + "); this one reads up to " +
              std::to_string(format_version));
  }
  if (version < 1) file.fail("format " + std::to_string(version) + " was never written");
  Snapshot s;
  read_boundaries(file, s.boundaries);
  read_context(file, s);
  check_context(file, s);
  s.time = read_time(file);
  s.step = file.dataset<std::int64_t>("/VTKHDF/FieldData/step", 1, 0, 1).front();
  const std::size_t total = read_row_count(file);
  if (options.rows && options.region) {
    read_chunks_in(*options.region, file, s, total, options);
  } else if (options.rows) {
    append_rows(file, s, 0, total, options);
  }
  if (options.region) s = restricted(s, *options.region);
  if (options.contacts && file.has("/contacts/pair")) {
    s.contacts = read_contacts(file);
    check_contacts(file, s);
  }
  check_particles(file, s);
  if (options.rows && !options.region) check_ids(file, s);
  return s;
}

}  // namespace packstone
