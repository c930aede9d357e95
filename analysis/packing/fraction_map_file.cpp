// The map as VTK XML ImageData (VTK file formats, "Serial XML file formats"), values appended raw.
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "analysis/packing/fraction_map.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace packstone::analysis {

namespace {

void append_bytes(std::string& text, const void* data, std::size_t bytes) {
  const std::size_t end = text.size();
  text.resize(end + bytes);
  std::memcpy(text.data() + end, data, bytes);
}

void require_extension(const std::filesystem::path& path) {
  if (path.extension() != ".vti") throw InputError(path.string() + ": a map's name must end in .vti");
}

}  // namespace

void write_vti(const std::filesystem::path& path, const FractionMap& map) {
  require_extension(path);
  if (map.cells() == 0) throw InputError(path.string() + ": there is nothing to map, no particle lies above the floor");
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", map.count[0], map.count[1], map.count[2]);
  const char* const order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "  <ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n"
      "    <Piece Extent=\"{}\">\n"
      "      <PointData/>\n"
      "      <CellData Scalars=\"solid_fraction\">\n"
      "        <DataArray type=\"Float64\" Name=\"solid_fraction\" format=\"appended\" offset=\"0\"/>\n"
      "      </CellData>\n"
      "    </Piece>\n"
      "  </ImageData>\n"
      "  <AppendedData encoding=\"raw\">\n_",
      order, extent, map.origin.x(), map.origin.y(), map.origin.z(), map.spacing.x(), map.spacing.y(), map.spacing.z(),
      extent);
  const char* const tail = "\n  </AppendedData>\n</VTKFile>\n";
  const std::uint64_t bytes = map.fraction.size() * sizeof(double);
  text.reserve(text.size() + sizeof bytes + bytes + std::strlen(tail));
  append_bytes(text, &bytes, sizeof bytes);
  append_bytes(text, map.fraction.data(), bytes);
  text += tail;
  write_text_file(path, text);
}

void write_fraction_map(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options) {
  require_extension(path);  // before the work
  const Context context = make_context(snapshot, options);
  write_vti(path, fraction_map(snapshot, context, container_of(snapshot, context.frame)));
}

}  // namespace packstone::analysis
