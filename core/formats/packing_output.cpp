#include "core/formats/packing_output.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/csv_table.hpp"
#include "core/formats/lammps_data.hpp"
#include "core/formats/lammps_dump.hpp"
#include "core/formats/text_output.hpp"
#include "core/formats/vtk_file.hpp"
#include "core/formats/xyz.hpp"

namespace packstone {

namespace {

using WriteWhole = void (*)(const std::filesystem::path&, const Snapshot&);
using AddFrame = void (*)(formats::TextOutput&, const Snapshot&);

struct Format {
  const char* extension;
  WriteWhole write;
  AddFrame add_frame = nullptr;  ///< instead, of formats that hold series
};

constexpr std::array known_formats = {Format{".vtkhdf", write_snapshot},
                                      Format{".dump", nullptr, formats::write_lammps_dump},
                                      Format{".lammpstrj", nullptr, formats::write_lammps_dump},
                                      Format{".liggghts", nullptr, formats::write_lammps_dump},
                                      Format{".data", formats::write_lammps_data},
                                      Format{".csv", formats::write_csv_table},
                                      Format{".xyz", nullptr, formats::write_xyz},
                                      Format{".extxyz", nullptr, formats::write_xyz},
                                      Format{".vtu", formats::write_vtk_file},
                                      Format{".vtp", formats::write_vtk_file}};

const Format& format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto found = std::find_if(known_formats.begin(), known_formats.end(),
                                  [&](const Format& format) { return extension == format.extension; });
  if (found != known_formats.end()) return *found;
  throw InputError(
      fmt::format("{}: \"{}\" is no format that is written; there are {}", path.string(), extension, writable_formats));
}

}  // namespace

bool holds_series(const std::filesystem::path& path) { return format_of(path).add_frame != nullptr; }

struct PackingWriter::Output {
  std::filesystem::path path;
  WriteWhole write_whole;  ///< null for formats that hold series
  AddFrame add_frame;
  std::optional<formats::TextOutput> series{};  ///< open from the first instant on
  int instants = 0;

  void write(const Snapshot& s) {
    if (add_frame) {
      if (!series) series.emplace(path);
      add_frame(*series, s);
    } else if (instants > 0) {
      throw InputError(path.string() + ": the format holds one instant");
    } else {
      write_whole(path, s);
    }
    ++instants;
  }
};

PackingWriter::PackingWriter(const std::filesystem::path& path)
    : output_(new Output{path, format_of(path).write, format_of(path).add_frame}) {}
PackingWriter::~PackingWriter() = default;
PackingWriter::PackingWriter(PackingWriter&&) noexcept = default;
PackingWriter& PackingWriter::operator=(PackingWriter&&) noexcept = default;

void PackingWriter::write(const Snapshot& snapshot) {
  const bool own = output_->write_whole == write_snapshot;  // which has an order of its own
  if (own || std::is_sorted(snapshot.id.begin(), snapshot.id.end())) {
    output_->write(snapshot);
  } else {
    output_->write(with_rows(snapshot, id_order(snapshot)));
  }
}

void PackingWriter::finish() {
  if (output_->series) output_->series->finish();
}

void write_packing(const std::filesystem::path& path, const Snapshot& snapshot) {
  PackingWriter writer(path);
  writer.write(snapshot);
  writer.finish();
}

}  // namespace packstone
