#include "core/formats/packing_series.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fnmatch.h>

#include "core/error.hpp"
#include "core/formats/csv_table.hpp"
#include "core/formats/lammps_data.hpp"
#include "core/formats/local_dump.hpp"
#include "core/formats/mapped_file.hpp"
#include "core/formats/vtk_file.hpp"
#include "core/formats/yade_text.hpp"
#include "core/hdf5.hpp"
#include "core/snapshot_layout.hpp"

namespace packstone {

namespace fs = std::filesystem;
using namespace formats;

namespace {

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
constexpr std::string_view gzip_signature = "\x1f\x8b";
constexpr const char* local_extension = ".local";
constexpr const char* wall_extension = ".wall";

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view leading_digits(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::string_view digits = text.substr(0, end);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

/// dump_2 before dump_10: runs of digits compare as numbers.
bool natural_less(const std::string& one, const std::string& other) {
  std::string_view a = one, b = other;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = leading_digits(a), y = leading_digits(b);
      if (x != y) return x.size() != y.size() ? x.size() < y.size() : x < y;
      while (!a.empty() && is_digit(a.front())) a.remove_prefix(1);
      while (!b.empty() && is_digit(b.front())) b.remove_prefix(1);
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() != b.size() ? a.size() < b.size() : one < other;
}

/// The files that a path means: itself, or those its pattern fits; dumps of contacts beside them are not meant.
std::vector<fs::path> expanded(const fs::path& path) {
  const std::string pattern = path.filename().string();
  std::error_code error;
  if (fs::exists(path, error) || pattern.find_first_of("*?") == std::string::npos) return {path};
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const fs::path extension = entry.path().extension();
    if (fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) != 0) continue;
    if (extension == local_extension || extension == wall_extension) continue;
    files.push_back(path.has_parent_path() ? entry.path() : fs::path(name));
  }
  if (files.empty()) throw InputError(path.string() + ": no file has such a name");
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return files;
}

/// Where Yade's VTKRecorder puts the interactions that go with NAME-spheres.NUMBER.vtu, and its VTKExporter those of
/// NAME-spheres-NUMBER.vtk.
fs::path yade_interactions(const fs::path& spheres) {
  constexpr std::string_view part = "spheres";
  std::string name = spheres.stem().string();
  const std::size_t at = name.rfind(part);
  if (at == std::string::npos) return {};
  const std::string extension = spheres.extension() == ".vtu" ? ".vtp" : spheres.extension().string();
  return spheres.parent_path() / (name.replace(at, part.size(), "intrs") + extension);
}

}  // namespace

PackingSeries::PackingSeries(const std::vector<fs::path>& paths, const PackingOptions& options) : options_(options) {
  for (const fs::path& path : paths) {
    for (const fs::path& file : expanded(path)) add_file(file);
  }
}

PackingSeries::Format PackingSeries::format_of(const fs::path& path, std::string_view text) {
  if (text.starts_with(hdf5_signature) || path.extension() == ".vtkhdf") return Format::snapshot;
  if (is_lammps_dump(text)) return Format::lammps_dump;
  if (is_vtk_file(text)) return Format::vtk;
  if (is_xyz(text)) return Format::xyz;
  if (is_lammps_data(text)) return Format::lammps_data;
  if (is_csv_table(text) || path.extension() == ".csv") return Format::csv;
  if (is_yade_text(text)) return Format::yade_text;
  if (text.starts_with(gzip_signature)) throw InputError(path.string() + ": is compressed; unpack it first");
  throw InputError(fmt::format("{}: is no packing; expected a run folder, {}", path.string(), readable_formats));
}

void PackingSeries::add_file(const fs::path& path) {
  const MappedFile file(path);
  const std::string source = path.string();
  const Format format = format_of(path, file.text());
  if (format == Format::lammps_dump) {
    for (DumpFrame& frame : index_dump(file.text(), source)) {
      const double time = frame.time.value_or(options_.time_step * static_cast<double>(frame.step));
      frames_.push_back({path, format, time, std::move(frame), {}});
    }
  } else if (format == Format::xyz) {
    for (XyzFrame& frame : index_xyz(file.text(), source)) {
      const double time = frame.time.value_or(options_.time_step * static_cast<double>(frame.step));
      frames_.push_back({path, format, time, {}, std::move(frame)});
    }
  } else if (format == Format::snapshot) {
    frames_.push_back({path, format, read_time(hdf5::Reader(path))});
  } else {
    frames_.push_back({path, format});
  }
}

Snapshot PackingSeries::foreign(const Frame& frame) const {
  if (frame.format == Format::vtk) return to_snapshot(read_vtk_file(frame.file));
  const MappedFile file(frame.file);
  const std::string source = frame.file.string();
  switch (frame.format) {
    case Format::lammps_dump:
      return to_snapshot(read_dump_frame(file.text(), source, frame.dump));
    case Format::xyz:
      return to_snapshot(read_xyz_frame(file.text(), source, frame.xyz));
    case Format::lammps_data:
      return to_snapshot(read_lammps_data(file.text(), source));
    case Format::yade_text:
      return to_snapshot(read_yade_text(file.text(), source));
    default:
      return to_snapshot(read_csv_table(file.text(), source));
  }
}

void PackingSeries::add_contacts(const Frame& frame, Snapshot& s) const {
  fs::path path = options_.contacts;
  const bool given = !path.empty();
  if (!given && frame.format == Format::vtk) path = yade_interactions(frame.file);
  if (!given && frame.format != Format::vtk) path = fs::path(frame.file.string() + local_extension);
  if (path.empty() || (!given && !fs::is_regular_file(path))) {
    if (options_.wall_contacts.empty()) return;
    throw InputError(
        options_.wall_contacts.string() +
        ": contacts with walls take the contacts between particles beside them; name those with --contacts");
  }
  if (is_vtk_file(MappedFile(path).text())) {
    const PairForces pairs = read_yade_interactions(path);
    s.contacts = contacts_of_pairs(s, pairs);
    if (!pairs.with_friction) {
      s.notes.emplace_back("forces of contacts are their normal parts: friction's direction is not in the file");
    }
  } else {
    s.contacts = contacts_of_pairs(s, read_local_dump(path, s.step, options_.contact_columns));
  }
  add_wall_contacts(frame, s);
}

/// Walls are boundaries without a place: what they look like the dump does not say.
void PackingSeries::add_wall_contacts(const Frame& frame, Snapshot& s) const {
  fs::path path = options_.wall_contacts;
  if (path.empty()) path = fs::path(frame.file.string() + wall_extension);
  if (options_.wall_contacts.empty() && !fs::is_regular_file(path)) {
    s.notes.emplace_back("contacts with boundaries are not known");
    return;
  }
  const WallForces walls = read_wall_dump(path, s.step, options_.wall_columns);
  s.contacts->append(contacts_with_walls(s, walls));
  const std::int32_t last = walls.wall.empty() ? -1 : *std::max_element(walls.wall.begin(), walls.wall.end());
  for (std::int32_t k = 0; k <= last; ++k) s.boundaries.push_back({fmt::format("wall {}", k), "mesh"});
  if (last >= 0) s.notes.emplace_back(note_no_walls);
}

Snapshot PackingSeries::snapshot(std::size_t index, const ReadOptions& read) const {
  const Frame& frame = frames_.at(index);
  if (frame.format == Format::snapshot) return read_snapshot(frame.file, read);
  Snapshot s = foreign(frame);
  if (frame.format == Format::lammps_dump || frame.format == Format::xyz) s.time = frame.time;
  if (frame.format == Format::lammps_dump && !frame.dump.time && !(options_.time_step > 0)) {
    s.notes.emplace_back("the file has steps, not times: the time is 0 (convert --time-step gives it)");
  }
  if (read.contacts) add_contacts(frame, s);
  return read.region ? restricted(s, *read.region) : s;
}

Snapshot read_packing(const fs::path& path, const PackingOptions& options) {
  const PackingSeries series({path}, options);
  return series.snapshot(series.size() - 1);
}

}  // namespace packstone
