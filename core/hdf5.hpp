// A thin, throwing layer over the HDF5 C library: handles that close themselves, arrays in and out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "core/checksums.hpp"
#include "core/files.hpp"
#include "core/vec3.hpp"

namespace packstone::hdf5 {

/// Owns one HDF5 identifier of any kind.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  /// Closes now; false when HDF5 reports an error, as on a full disk.
  bool close() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

/// For files that PendingFile locks, or that nobody writes any more.
Handle access_without_locks();

template <class T>
hid_t memory_type();
template <>
inline hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t memory_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// A file being written, whole or absent. Throws RunError naming the file whenever HDF5 or the disk refuses.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path);

  void group(const std::string& name);
  /// Row-major data of columns values a row; columns 0 writes a one-dimensional array.
  template <class T>
  void dataset(const std::string& name, std::span<const T> data, std::size_t columns = 0) {
    write(name, data.data(), data.size(), columns, memory_type<T>());
  }
  template <class T>
  void dataset(const std::string& name, const std::vector<T>& data, std::size_t columns = 0) {
    dataset(name, std::span<const T>(data), columns);
  }
  void text(const std::string& name, const std::string& value);
  void texts(const std::string& name, const std::vector<std::string>& values);
  /// Attributes of a group or dataset.
  void text_attribute(const std::string& object, const std::string& name, const std::string& value);
  void attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
  /// Closes the file, writes checksums behind it and puts it in place.
  void finish(Lasting lasting = Lasting::no);

 private:
  void write(const std::string& name, const void* data, std::size_t count, std::size_t columns, hid_t type);
  hid_t checked(hid_t result, const char* what) const;
  [[noreturn]] void fail(const char* what) const;

  PendingFile pending_;
  std::vector<ColumnSum> columns_;
  Handle file_;
};

/// A file being read. Throws InputError naming file and dataset when something is missing, damaged or of the wrong
/// shape. Where Writer's checksums are there, the structure is checked against them before HDF5 sees it, and a column
/// when all of it is read; another file's structure is tried in a process of its own.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path);

  bool has(const std::string& name) const;
  std::vector<std::string> children(const std::string& group) const;
  /// Rows and columns (1 for a one-dimensional array).
  std::pair<std::size_t, std::size_t> shape(const std::string& name) const;
  /// Rows [first, first + rows), all columns; rows of npos reads to the end.
  template <class T>
  std::vector<T> dataset(const std::string& name, std::size_t columns = 1, std::size_t first = 0,
                         std::size_t rows = npos) const {
    std::vector<T> data(extent(name, columns, first, rows) * columns);
    read(name, data.data(), first, data.size() / columns, memory_type<T>());
    return data;
  }
  /// The same of three columns.
  std::vector<Vec3> vectors(const std::string& name, std::size_t first = 0, std::size_t rows = npos) const;
  /// Where in the file a dataset of so many rows and columns begins, when its numbers lie there one after the other as
  /// they would in memory; nothing where they are compressed, in pieces, or of another type.
  template <class T>
  std::optional<std::size_t> place_of(const std::string& name, std::size_t columns, std::size_t rows) const {
    return place(name, extent(name, columns, 0, rows) * columns * sizeof(T), memory_type<T>());
  }
  std::string text(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;

  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  [[noreturn]] void fail(const std::string& what) const;

 private:
  /// Number of rows to read; fails unless the dataset has these columns and rows.
  std::size_t extent(const std::string& name, std::size_t columns, std::size_t first, std::size_t rows) const;
  void read(const std::string& name, void* data, std::size_t first, std::size_t rows, hid_t type) const;
  std::optional<std::size_t> place(const std::string& name, std::size_t bytes, hid_t type) const;
  void check_sum(const std::string& name, hid_t set, const void* data, std::size_t bytes) const;
  Handle open(const std::string& name) const;

  std::filesystem::path path_;
  std::uintmax_t file_size_ = 0;
  std::optional<Checksums> sums_;
  Handle file_;
};

}  // namespace packstone::hdf5
