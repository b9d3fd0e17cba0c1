// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

namespace microslip::test {

/// A file as another program would write it, straight by the library.
class OtherFile {
 public:
  explicit OtherFile(const std::string& path, hid_t access = H5P_DEFAULT)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)) {}
  OtherFile(const OtherFile&) = delete;
  OtherFile& operator=(const OtherFile&) = delete;
  ~OtherFile() { H5Fclose(file_); }

  void group(const char* name) {
    H5Gclose(H5Gcreate2(file_, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  template <class T>
  void dataset(const char* name, hid_t type, const std::vector<hsize_t>& sizes,
               const std::vector<T>& values, hid_t creation = H5P_DEFAULT) {
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t set = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (!values.empty()) H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }

  void number(const char* object, const char* name, double value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    attribute(object, name, H5T_NATIVE_DOUBLE, space, &value);
    H5Sclose(space);
  }

  /// Numbers in one dimension, as netCDF writes its attributes.
  void numbers(const char* object, const char* name, const std::vector<double>& values) {
    const hsize_t size = values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    attribute(object, name, H5T_NATIVE_DOUBLE, space, values.data());
    H5Sclose(space);
  }

  /// Makes a dataset the scale of a dimension.
  void scale(const char* object, const char* name) {
    text(object, "CLASS", "DIMENSION_SCALE");
    text(object, "NAME", name);
  }

  /// Names a scale for each dimension of a dataset, empty: none.
  void scales(const char* object, const std::vector<std::string>& names) {
    std::vector<hobj_ref_t> references(names.size());
    std::vector<hvl_t> lists(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].empty()) continue;
      H5Rcreate(&references[i], file_, names[i].c_str(), H5R_OBJECT, -1);
      lists[i] = {1, &references[i]};
    }
    const hsize_t size = names.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t type = H5Tvlen_create(H5T_STD_REF_OBJ);
    attribute(object, "DIMENSION_LIST", type, space, lists.data());
    H5Tclose(type);
    H5Sclose(space);
  }

  /// Of variable length, as h5py writes texts.
  void text(const char* object, const char* name, const char* value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    attribute(object, name, type, space, &value);
    H5Tclose(type);
    H5Sclose(space);
  }

  /// A list of texts, as h5py writes one.
  void texts(const char* object, const char* name, const std::vector<const char*>& values) {
    const hsize_t size = values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    attribute(object, name, type, space, values.data());
    H5Tclose(type);
    H5Sclose(space);
  }

 private:
  void attribute(const char* object, const char* name, hid_t type, hid_t space, const void* value) {
    const hid_t at =
        H5Acreate_by_name(file_, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(at, type, value);
    H5Aclose(at);
  }

  hid_t file_;
};

}  // namespace microslip::test
