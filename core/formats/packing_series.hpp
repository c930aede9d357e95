// Packings in files, of packstone or of another program, as a series of instants.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/lammps_dump.hpp"
#include "core/formats/xyz.hpp"
#include "core/snapshot.hpp"

namespace packstone {

/// What a file of another program does not say itself.
struct PackingOptions {
  double time_step = 0;            ///< between steps that have no time [s]; 0: their time is 0
  std::filesystem::path contacts;  ///< dump of contacts; empty: a file FILE.local beside FILE, if there is one
  std::vector<std::string> contact_columns;  ///< as formats::read_local_dump takes them
  /// Dump of contacts with walls; empty: a file FILE.wall beside FILE, if there is one.
  std::filesystem::path wall_contacts;
  std::vector<std::string> wall_columns;  ///< as formats::read_wall_dump takes them
};

/// The kinds of file that are read, for messages and help.
inline constexpr const char* readable_formats =
    "a packstone snapshot, a LAMMPS or LIGGGHTS text dump, a LAMMPS data file, Yade's text, CSV, extended XYZ, or VTK "
    "(.vtu, .vtp, .vtk)";

/// A file, or files in natural order, each with one instant or several. What a file is its content says.
class PackingSeries {
 public:
  /// A last part of the path with * or ? stands for all files of that name in its folder, "post/dump_*.liggghts".
  /// Reads what stands above each frame, not the particles.
  /// Throws InputError "FILE:LINE: what; what would be right" for a file that is none of the formats or damaged.
  explicit PackingSeries(const std::vector<std::filesystem::path>& paths, const PackingOptions& options = {});

  std::size_t size() const { return frames_.size(); }
  const std::filesystem::path& file(std::size_t index) const { return frames_.at(index).file; }
  double time(std::size_t index) const { return frames_.at(index).time; }  ///< [s]
  /// Whether the file is packstone's own snapshot.
  bool is_snapshot(std::size_t index) const { return frames_.at(index).format == Format::snapshot; }

  /// The particles are checked; contacts come where a file has them. Throws InputError as above.
  Snapshot snapshot(std::size_t index, const ReadOptions& read = {}) const;

 private:
  enum class Format { snapshot, lammps_dump, lammps_data, yade_text, csv, xyz, vtk };

  struct Frame {
    std::filesystem::path file;
    Format format = Format::snapshot;
    double time = 0;
    formats::DumpFrame dump{};
    formats::XyzFrame xyz{};
  };

  static Format format_of(const std::filesystem::path& path, std::string_view text);
  void add_file(const std::filesystem::path& path);
  Snapshot foreign(const Frame& frame) const;
  void add_contacts(const Frame& frame, Snapshot& snapshot) const;
  void add_wall_contacts(const Frame& frame, Snapshot& snapshot) const;

  PackingOptions options_;
  std::vector<Frame> frames_;
};

/// The last instant in a file. Throws InputError.
Snapshot read_packing(const std::filesystem::path& path, const PackingOptions& options = {});

}  // namespace packstone
