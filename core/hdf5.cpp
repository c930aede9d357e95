#include "core/hdf5.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/mapped_file.hpp"
#include "core/hdf5_trial.hpp"

namespace packstone::hdf5 {

namespace {

constexpr hsize_t aligned_from = 1024, alignment = 64;  // [bytes]

/// HDF5 prints its own error stack to stderr unless told not to. When the program ends it closes what could not be
/// closed on a full disk once more, and crashes.
void silence() {
  static const bool done = [] {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  (void)done;
}

Handle fixed_text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

Handle utf8_text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// What the system said to the call that failed, out of HDF5's error stack; empty where it said nothing.
std::string system_message() {
  std::string message;
  const auto search = [](unsigned, const H5E_error2_t* error, void* found) -> herr_t {
    constexpr std::string_view before = "error message = '";
    const std::string_view words = error->desc ? error->desc : "";
    const std::size_t at = words.find(before);
    if (at != std::string_view::npos) {
      const std::string_view rest = words.substr(at + before.size());
      *static_cast<std::string*>(found) = rest.substr(0, rest.find('\''));
    }
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, search, &message);
  return message;
}

}  // namespace

Handle access_without_locks() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access, false, true);
  return access;
}

void Writer::fail(const char* what) const {
  const std::string cause = system_message();
  throw RunError(fmt::format("{}: cannot {}: {}", pending_.target().string(), what,
                             cause.empty() ? "HDF5 gives no reason; is the disk full?" : cause));
}

hid_t Writer::checked(hid_t result, const char* what) const {
  if (result < 0) fail(what);
  return result;
}

Writer::Writer(const std::filesystem::path& path) : pending_(path) {
  silence();
  // No time stamps: the same content gives the same bytes.
  const Handle access = access_without_locks();
  H5Pset_alignment(access, aligned_from, alignment);  // columns can be looked at where they lie
  file_ =
      Handle(checked(H5Fcreate(pending_.name().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "create file"), H5Fclose);
}

void Writer::group(const std::string& name) {
  Handle made(checked(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group"),
              H5Gclose);
}

void Writer::write(const std::string& name, const void* data, std::size_t count, std::size_t columns, hid_t type) {
  const hsize_t extent[2] = {columns ? count / columns : count, columns};
  Handle space(H5Screate_simple(columns ? 2 : 1, extent, nullptr), H5Sclose);
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  Handle set(
      checked(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), "create dataset"),
      H5Dclose);
  if (count == 0) return;
  checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "write dataset");
  const std::size_t bytes = count * H5Tget_size(type);
  if (bytes >= aligned_from) columns_.push_back({H5Dget_offset(set), bytes});
}

void Writer::text(const std::string& name, const std::string& value) { texts(name, {value}); }

void Writer::texts(const std::string& name, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const auto& value : values) pointers.push_back(value.c_str());
  const hsize_t extent[1] = {values.size()};
  Handle space(H5Screate_simple(1, extent, nullptr), H5Sclose);
  Handle type = utf8_text_type();
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  Handle set(
      checked(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), "create dataset"),
      H5Dclose);
  if (!values.empty()) checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), "write dataset");
}

void Writer::text_attribute(const std::string& object, const std::string& name, const std::string& value) {
  Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  Handle type = fixed_text_type(value.size());
  Handle attribute(checked(H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT,
                                             H5P_DEFAULT),
                           "create attribute"),
                   H5Aclose);
  checked(H5Awrite(attribute, type, value.empty() ? "" : value.data()), "write attribute");
}

void Writer::attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t extent[1] = {values.size()};
  Handle space(H5Screate_simple(1, extent, nullptr), H5Sclose);
  Handle attribute(checked(H5Acreate_by_name(file_, object.c_str(), name.c_str(), H5T_NATIVE_INT64, space, H5P_DEFAULT,
                                             H5P_DEFAULT, H5P_DEFAULT),
                           "create attribute"),
                   H5Aclose);
  checked(H5Awrite(attribute, H5T_NATIVE_INT64, values.data()), "write attribute");
}

void Writer::finish(Lasting lasting) {
  checked(H5Fflush(file_, H5F_SCOPE_LOCAL), "flush file");
  if (!file_.close()) fail("close file");
  std::sort(columns_.begin(), columns_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  try {
    const formats::MappedFile written(pending_.name());
    append_to_file(pending_.name(), Checksums(written.text(), std::move(columns_)).text());
  } catch (const std::exception& error) {
    throw RunError(fmt::format("{}: cannot be written: {}", pending_.target().string(), error.what()));
  }
  pending_.commit(lasting);
}

Reader::Reader(const std::filesystem::path& path) : path_(path) {
  silence();
  {
    const formats::MappedFile file(path);
    file_size_ = file.text().size();
    sums_ = Checksums::behind(file.text());
    if (sums_ && !sums_->fit_structure_of(file.text())) fail("damaged: its structure is not what was written");
  }
  if (!sums_) {
    const std::string failure = failure_in_hdf5_trial(path, file_size_);
    if (!failure.empty()) fail("damaged: " + failure);
  }
  file_ = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_without_locks()), H5Fclose);
  if (file_ < 0) fail("not a readable HDF5 file (damaged or cut short?)");
}

void Reader::fail(const std::string& what) const { throw InputError(path_.string() + ": " + what); }

bool Reader::has(const std::string& name) const {
  // H5Lexists wants every group on the way to exist.
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    if (H5Lexists(file_, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

Handle Reader::open(const std::string& name) const {
  Handle set(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID, H5Dclose);
  if (set < 0) fail("dataset " + name + " is missing");
  return set;
}

std::vector<std::string> Reader::children(const std::string& group) const {
  std::vector<std::string> names;
  if (!has(group)) return names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->push_back(name);
    return 0;
  };
  Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (opened < 0 || H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0) {
    fail(group + " is not a readable group");
  }
  return names;
}

std::pair<std::size_t, std::size_t> Reader::shape(const std::string& name) const {
  Handle set = open(name);
  Handle space(H5Dget_space(set), H5Sclose);
  hsize_t extent[2] = {0, 1};
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > 2) fail(fmt::format("dataset {} has {} dimensions; 1 or 2 expected", name, rank));
  H5Sget_simple_extent_dims(space, extent, nullptr);
  // A damaged header may claim any size; believe no more than a compressed file of this size could hold.
  constexpr std::uintmax_t best_compression = 1024;
  if (extent[1] != 0 && extent[0] / best_compression > file_size_ / extent[1]) {
    fail(fmt::format("dataset {} claims {} rows, more than the file can hold", name, extent[0]));
  }
  return {extent[0], extent[1]};
}

std::size_t Reader::extent(const std::string& name, std::size_t columns, std::size_t first, std::size_t rows) const {
  const auto [there, across] = shape(name);
  if (across != columns) fail(fmt::format("dataset {} has {} columns; {} expected", name, across, columns));
  if (rows == npos) rows = there - std::min(first, there);
  if (first > there || rows > there - first) {
    fail(fmt::format("dataset {} has {} rows; row {} expected", name, there, first + rows));
  }
  return rows;
}

std::vector<Vec3> Reader::vectors(const std::string& name, std::size_t first, std::size_t rows) const {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  std::vector<Vec3> data(extent(name, 3, first, rows));
  if (!data.empty()) read(name, data.front().data(), first, data.size(), memory_type<double>());
  return data;
}

void Reader::read(const std::string& name, void* data, std::size_t first, std::size_t rows, hid_t type) const {
  if (rows == 0) return;
  Handle set = open(name);
  Handle space(H5Dget_space(set), H5Sclose);
  hsize_t extent[2] = {0, 1};
  const int rank = H5Sget_simple_extent_ndims(space);
  H5Sget_simple_extent_dims(space, extent, nullptr);
  const hsize_t start[2] = {first, 0};
  const hsize_t count[2] = {rows, extent[1]};
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
  Handle memory(H5Screate_simple(rank, count, nullptr), H5Sclose);
  if (H5Dread(set, type, memory, space, H5P_DEFAULT, data) < 0) {
    fail("dataset " + name + " cannot be read (damaged or cut short?)");
  }
  if (rows == extent[0]) check_sum(name, set, data, rows * extent[1] * H5Tget_size(type));
}

/// Of a whole dataset as it was read. Where it was not stored in the type it was read in, the bytes differ in number.
void Reader::check_sum(const std::string& name, hid_t set, const void* data, std::size_t bytes) const {
  const haddr_t place = sums_ ? H5Dget_offset(set) : HADDR_UNDEF;
  const auto column = place == HADDR_UNDEF ? std::nullopt : sums_->column_at(place);
  if (column && column->bytes == bytes && checksum_of(data, bytes) != column->sum) {
    fail("damaged: the numbers of dataset " + name + " are not what was written");
  }
}

std::optional<std::size_t> Reader::place(const std::string& name, std::size_t bytes, hid_t type) const {
  const Handle set = open(name);
  const Handle stored(H5Dget_type(set), H5Tclose);
  const haddr_t place = H5Dget_offset(set);  // undefined where there is no single one
  if (place == HADDR_UNDEF || H5Tequal(stored, type) <= 0) return std::nullopt;
  if (place > file_size_ || bytes > file_size_ - place) {
    fail("dataset " + name + " reaches beyond the end of the file (damaged or cut short?)");
  }
  return static_cast<std::size_t>(place);
}

std::vector<std::string> Reader::texts(const std::string& name) const {
  Handle set = open(name);
  Handle type(H5Dget_type(set), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) <= 0) fail("dataset " + name + " is not text");
  const std::size_t count = extent(name, 1, 0, npos);
  std::vector<char*> pointers(count, nullptr);
  Handle memory = utf8_text_type();
  if (count > 0 && H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) < 0) {
    fail("dataset " + name + " cannot be read (damaged or cut short?)");
  }
  std::vector<std::string> values;
  for (char* pointer : pointers) values.emplace_back(pointer ? pointer : "");
  Handle space(H5Dget_space(set), H5Sclose);
  if (count > 0) H5Dvlen_reclaim(memory, space, H5P_DEFAULT, pointers.data());
  return values;
}

std::string Reader::text(const std::string& name) const {
  const auto values = texts(name);
  if (values.size() != 1) fail("dataset " + name + " should hold one text");
  return values.front();
}

std::string Reader::text_attribute(const std::string& object, const std::string& name) const {
  Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (attribute < 0) fail(fmt::format("{} has no attribute {}", object, name));
  Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
    fail(fmt::format("attribute {} of {} is not fixed-length text", name, object));
  }
  if (H5Tget_size(type) > file_size_) fail(fmt::format("attribute {} of {} is longer than the file", name, object));
  std::string value(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, value.data()) < 0) fail(fmt::format("attribute {} cannot be read", name));
  return value.substr(0, value.find('\0'));
}

}  // namespace packstone::hdf5
