// VTK's XML files, written without VTK: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html.

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <numeric>
#include <string>

#include "core/formats/text_output.hpp"
#include "core/formats/vtk_appended.hpp"
#include "core/formats/vtk_file.hpp"

namespace packstone::formats {

namespace {

constexpr std::uint8_t vtk_vertex = 1;

void declare_point_data(VtkAppended& data, const Snapshot& s) {
  data.declare("radius", "Float64", 1, s.radius.data(), s.size());
  data.declare("id", "Int64", 1, s.id.data(), s.size());
  data.declare("type", "Int32", 1, s.type.data(), s.size());
  for (const auto& [name, field] : s.fields) {
    data.declare(name, "Float64", field.components, field.values.data(), field.values.size());
  }
}

}  // namespace

bool is_vtk_file(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  return text.starts_with("# vtk DataFile") || text.starts_with("<?xml") || text.starts_with("<VTKFile");
}

void write_vtk_file(const std::filesystem::path& path, const Snapshot& s) {
  const bool poly = path.extension() == ".vtp";
  const char* const kind = poly ? "PolyData" : "UnstructuredGrid";
  const std::array corners = {s.domain.min.x(), s.domain.min.y(), s.domain.min.z(),
                              s.domain.max.x(), s.domain.max.y(), s.domain.max.z()};
  const std::array<std::uint8_t, 3> periodic = {s.domain.periodic[0], s.domain.periodic[1], s.domain.periodic[2]};
  std::vector<std::int64_t> rows(s.size() + 1);
  std::iota(rows.begin(), rows.end(), std::int64_t{0});
  const std::vector<std::uint8_t> types(s.size(), vtk_vertex);

  TextOutput out(path);
  VtkAppended data(out);
  out.print(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<{}>\n<FieldData>\n",
      kind, kind);
  data.declare(vtk_time_name, "Float64", 1, &s.time, 1, true);
  data.declare(vtk_step_name, "Int64", 1, &s.step, 1, true);
  data.declare(vtk_domain_name, "Float64", 1, corners.data(), corners.size(), true);
  data.declare(vtk_periodic_name, "UInt8", 1, periodic.data(), periodic.size(), true);
  out.print("</FieldData>\n<Piece NumberOfPoints=\"{}\" {}=\"{}\">\n<PointData>\n", s.size(),
            poly ? "NumberOfVerts" : "NumberOfCells", s.size());
  declare_point_data(data, s);
  out.print("</PointData>\n<Points>\n");
  data.declare("Points", "Float64", 3, s.position.empty() ? nullptr : s.position.front().data(), 3 * s.size());
  out.print("</Points>\n<{}>\n", poly ? "Verts" : "Cells");
  data.declare("connectivity", "Int64", 1, rows.data(), s.size());
  data.declare("offsets", "Int64", 1, rows.data() + 1, s.size());
  if (!poly) data.declare("types", "UInt8", 1, types.data(), types.size());
  out.print("</{}>\n</Piece>\n</{}>\n", poly ? "Verts" : "Cells", kind);
  data.write();
  out.print("</VTKFile>\n");
  out.finish();
}

}  // namespace packstone::formats
