#include "core/hdf5_trial.hpp"

#include <vector>

#include "core/hdf5.hpp"
#include "core/trial.hpp"

namespace packstone::hdf5 {

namespace {

constexpr std::size_t memory_at_least = std::size_t{256} << 20;  ///< [bytes], of HDF5 itself and small files
constexpr std::size_t memory_over_file_size = 4;                 ///< texts and compressed columns, unpacked

constexpr int deepest_group = 8;  ///< damaged groups may hold themselves

bool is_numbers_in_a_row(hid_t set, hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Dget_offset(set) != HADDR_UNDEF;
}

void read_dataset(hid_t set) {
  const Handle stored(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  if (is_numbers_in_a_row(set, stored)) return;
  const Handle type(H5Tget_native_type(stored, H5T_DIR_DEFAULT), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (type < 0 || count <= 0) return;
  std::vector<char> data(static_cast<std::size_t>(count) * H5Tget_size(type));
  if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()) >= 0) {
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, data.data());
  }
}

herr_t read_attribute(hid_t object, const char* name, const H5A_info_t*, void*) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle type(attribute < 0 ? H5I_INVALID_HID : H5Aget_type(attribute), H5Tclose);
  if (type < 0) return 0;
  std::vector<char> data(H5Aget_storage_size(attribute) + H5Tget_size(type));
  if (H5Tget_class(type) != H5T_VLEN && H5Tis_variable_str(type) <= 0) H5Aread(attribute, type, data.data());
  return 0;
}

/// Goes on behind what cannot be opened: a reader that opens by name would get there, too.
herr_t read_object(hid_t group, const char* name, const H5L_info_t*, void* depth) {
  const Handle object(H5Oopen(group, name, H5P_DEFAULT), H5Oclose);
  if (object < 0) return 0;
  hsize_t first = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &first, read_attribute, nullptr);
  const H5I_type_t kind = H5Iget_type(object);
  int deeper = *static_cast<int*>(depth) + 1;
  if (kind == H5I_DATASET) read_dataset(object);
  if (kind == H5I_GROUP && deeper < deepest_group) {
    H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, read_object, &deeper);
  }
  return 0;
}

}  // namespace

std::string failure_in_hdf5_trial(const std::filesystem::path& path, std::uintmax_t file_size) {
  return failure_in_trial(memory_at_least + memory_over_file_size * file_size, [&] {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_without_locks()), H5Fclose);
    int depth = 0;
    if (file >= 0) H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, read_object, &depth);
  });
}

}  // namespace packstone::hdf5
