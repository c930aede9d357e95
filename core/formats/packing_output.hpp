// Packings written for other programs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/snapshot.hpp"

namespace packstone {

/// The extensions that are written, for messages and help.
inline constexpr const char* writable_formats =
    ".vtkhdf (snapshot), .dump, .lammpstrj or .liggghts (LAMMPS text dump), .data (LAMMPS data file), .csv, .xyz or "
    ".extxyz (extended XYZ), .vtu, .vtp, or a folder (run)";

/// Whether a file of this extension holds several instants.
bool holds_series(const std::filesystem::path& path);

/// A file in the format of its extension. It appears under its name only after finish(), whole.
class PackingWriter {
 public:
  /// Throws InputError for an extension that is not written.
  explicit PackingWriter(const std::filesystem::path& path);
  /// Without finish() nothing is left behind.
  ~PackingWriter();
  PackingWriter(PackingWriter&&) noexcept;
  PackingWriter& operator=(PackingWriter&&) noexcept;

  /// Particles go by ascending id (those of packstone's own along a curve through space), so that the rows of
  /// successive instants agree. Throws InputError for a second instant of a format that holds one and for a snapshot
  /// that the format cannot hold, RunError when the disk refuses.
  void write(const Snapshot& snapshot);
  /// Throws RunError when the disk refuses.
  void finish();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

/// One instant, as PackingWriter does.
void write_packing(const std::filesystem::path& path, const Snapshot& snapshot);

}  // namespace packstone
