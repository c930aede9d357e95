#include "core/formats/packing_output.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/csv_table.hpp"
#include "core/formats/lammps_data.hpp"
#include "core/formats/lammps_dump.hpp"
#include "core/formats/vtk_file.hpp"
#include "core/formats/xyz.hpp"

namespace packstone {

namespace {

struct Writer {
  const char* extension;
  bool series;
  void (*write)(const std::filesystem::path&, const Snapshot&, bool append);
};

void write_own(const std::filesystem::path& path, const Snapshot& s, bool) { write_snapshot(path, s); }
void write_data(const std::filesystem::path& path, const Snapshot& s, bool) { formats::write_lammps_data(path, s); }
void write_csv(const std::filesystem::path& path, const Snapshot& s, bool) { formats::write_csv_table(path, s); }
void write_vtk(const std::filesystem::path& path, const Snapshot& s, bool) { formats::write_vtk_file(path, s); }

constexpr std::array writers = {Writer{".vtkhdf", false, write_own},
                                Writer{".dump", true, formats::write_lammps_dump},
                                Writer{".lammpstrj", true, formats::write_lammps_dump},
                                Writer{".liggghts", true, formats::write_lammps_dump},
                                Writer{".data", false, write_data},
                                Writer{".csv", false, write_csv},
                                Writer{".xyz", true, formats::write_xyz},
                                Writer{".extxyz", true, formats::write_xyz},
                                Writer{".vtu", false, write_vtk},
                                Writer{".vtp", false, write_vtk}};

const Writer& writer_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto found =
      std::find_if(writers.begin(), writers.end(), [&](const Writer& w) { return extension == w.extension; });
  if (found != writers.end()) return *found;
  throw InputError(
      fmt::format("{}: \"{}\" is no format that is written; there are {}", path.string(), extension, writable_formats));
}

}  // namespace

bool holds_series(const std::filesystem::path& path) { return writer_of(path).series; }

void write_packing(const std::filesystem::path& path, const Snapshot& snapshot, bool append) {
  const Writer& writer = writer_of(path);
  if (append && !writer.series) throw InputError(path.string() + ": the format holds one instant");
  if (writer.write == write_own || std::is_sorted(snapshot.id.begin(), snapshot.id.end())) {
    writer.write(path, snapshot, append);
  } else {
    writer.write(path, with_rows(snapshot, id_order(snapshot)), append);
  }
}

}  // namespace packstone
