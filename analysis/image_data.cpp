#include "analysis/image_data.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/text_output.hpp"

namespace packstone::analysis {

namespace {

constexpr std::size_t cells_at_once = 1 << 16;

std::size_t components_of(const CellArray& array) { return std::max<std::size_t>(1, array.components.size()); }

/// The line that announces an array whose bytes begin at the offset.
std::string announced(const CellArray& array, std::size_t offset) {
  std::string names;
  for (std::size_t k = 0; k < array.components.size(); ++k) {
    names += fmt::format(" ComponentName{}=\"{}\"", k, array.components[k]);
  }
  return fmt::format("        <DataArray type=\"Float64\" Name=\"{}\"{}{} format=\"appended\" offset=\"{}\"/>\n",
                     array.name, names.empty() ? "" : fmt::format(" NumberOfComponents=\"{}\"", components_of(array)),
                     names, offset);
}

void write_values(formats::TextOutput& out, const CellArray& array, std::size_t cells) {
  const std::size_t components = components_of(array);
  const std::uint64_t bytes = cells * components * sizeof(double);
  out.raw(&bytes, sizeof bytes);
  std::vector<double> part(std::min(cells, cells_at_once) * components);
  for (std::size_t first = 0; first < cells; first += cells_at_once) {
    const std::size_t count = std::min(cells_at_once, cells - first);
    for (std::size_t k = 0; k < count; ++k) array.values(first + k, &part[k * components]);
    out.raw(part.data(), count * components * sizeof(double));
  }
}

}  // namespace

void require_image_extension(const std::filesystem::path& path, const char* what) {
  if (path.extension() != ".vti") throw InputError(fmt::format("{}: {}'s name must end in .vti", path.string(), what));
}

void write_image_data(const std::filesystem::path& path, const RegularGrid& grid,
                      const std::vector<CellArray>& arrays) {
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", grid.count[0], grid.count[1], grid.count[2]);
  const Vec3 &origin = grid.origin, &spacing = grid.spacing;
  formats::TextOutput out(path);
  out.print(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "  <ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n"
      "    <Piece Extent=\"{}\">\n"
      "      <PointData/>\n"
      "      <CellData Scalars=\"{}\">\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", extent, origin.x(), origin.y(),
      origin.z(), spacing.x(), spacing.y(), spacing.z(), extent, arrays.front().name);
  std::size_t offset = 0;
  for (const CellArray& array : arrays) {
    out.print("{}", announced(array, offset));
    offset += sizeof(std::uint64_t) + grid.cells() * components_of(array) * sizeof(double);
  }
  out.print(
      "      </CellData>\n"
      "    </Piece>\n"
      "  </ImageData>\n"
      "  <AppendedData encoding=\"raw\">\n_");
  for (const CellArray& array : arrays) write_values(out, array, grid.cells());
  out.print("\n  </AppendedData>\n</VTKFile>\n");
  out.finish();
}

}  // namespace packstone::analysis
