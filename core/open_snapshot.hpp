// A snapshot to look at without reading all of it.
#pragma once

#include <filesystem>
#include <memory>

#include "core/particle_view.hpp"
#include "core/snapshot.hpp"

namespace packstone {

/// Holds what a view of particles looks at: packstone's own file, mapped into memory, of which the system reads what is
/// looked at, and may forget it again; or a snapshot in memory.
class OpenSnapshot {
 public:
  explicit OpenSnapshot(Snapshot snapshot);
  /// Columns that do not lie in the file as they do in memory, such as compressed ones, are read. Throws InputError as
  /// read_snapshot does, for rows as late as check_rows.
  explicit OpenSnapshot(const std::filesystem::path& path);
  ~OpenSnapshot();
  OpenSnapshot(OpenSnapshot&&) noexcept;
  OpenSnapshot& operator=(OpenSnapshot&&) noexcept;

  const ParticleView& view() const;

 private:
  class Columns;
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace packstone
