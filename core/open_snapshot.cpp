#include "core/open_snapshot.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/mapped_file.hpp"
#include "core/hdf5.hpp"
#include "core/snapshot_layout.hpp"

namespace packstone {

/// Columns of a file that are looked at in it where they can be.
class OpenSnapshot::Columns {
 public:
  explicit Columns(const std::filesystem::path& path) : reader_(path), file_(path) {}

  const hdf5::Reader& reader() const { return reader_; }

  /// (rows * columns) numbers of a dataset.
  template <class T>
  std::span<const T> numbers(const std::string& name, std::size_t columns, std::size_t rows) {
    const auto place = reader_.place_of<T>(name, columns, rows);
    if (!place) return kept(reader_.dataset<T>(name, columns, 0, rows));
    const char* const first = file_.text().data() + *place;
    if (reinterpret_cast<std::uintptr_t>(first) % alignof(T) != 0)
      return kept(reader_.dataset<T>(name, columns, 0, rows));
    return {reinterpret_cast<const T*>(first), rows * columns};
  }

  std::span<const Vec3> vectors(const std::string& name, std::size_t rows) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double) && alignof(Vec3) == alignof(double));
    const auto values = numbers<double>(name, 3, rows);
    return {reinterpret_cast<const Vec3*>(values.data()), rows};
  }

 private:
  template <class T>
  std::span<const T> kept(std::vector<T> values) {
    const auto own = std::make_shared<const std::vector<T>>(std::move(values));
    copies_.push_back(own);
    return *own;
  }

  hdf5::Reader reader_;
  formats::MappedFile file_;
  std::vector<std::shared_ptr<const void>> copies_;
};

struct OpenSnapshot::Held {
  Snapshot snapshot;
  std::unique_ptr<Columns> columns{};
  ParticleView view{snapshot};
};

OpenSnapshot::OpenSnapshot(Snapshot snapshot) : held_(new Held{std::move(snapshot)}) {}

OpenSnapshot::OpenSnapshot(const std::filesystem::path& path)
    : held_(new Held{read_snapshot(path, {.region = {}, .contacts = false, .fields = false, .rows = false})}) {
  held_->columns = std::make_unique<Columns>(path);
  Columns& columns = *held_->columns;
  const hdf5::Reader& reader = columns.reader();
  ParticleView& view = held_->view;
  const std::size_t rows = read_row_count(reader);
  view.position = columns.vectors(snapshot_points, rows);
  view.radius = columns.numbers<double>(snapshot_column("radius"), 1, rows);
  view.type = columns.numbers<std::int32_t>(snapshot_column("type"), 1, rows);
  view.material = columns.numbers<std::int32_t>(snapshot_column("material"), 1, rows);
  for (const std::string& name : field_names(reader)) {
    const std::string set = snapshot_column(name);
    const std::size_t components = reader.shape(set).second;
    view.fields.emplace(name, FieldColumn{static_cast<int>(components), reader.text_attribute(set, "unit"),
                                          columns.numbers<double>(set, components, rows)});
  }
  view.chunks = read_chunks(reader, rows);
  view.unchecked_file = path.string();
}

OpenSnapshot::~OpenSnapshot() = default;
OpenSnapshot::OpenSnapshot(OpenSnapshot&&) noexcept = default;
OpenSnapshot& OpenSnapshot::operator=(OpenSnapshot&&) noexcept = default;

const ParticleView& OpenSnapshot::view() const { return held_->view; }

}  // namespace packstone
