// SPDX-License-Identifier: MIT
#include "microslip/io/open/matrix_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::matrix_file_test {
namespace {

using test::message_of;

/// [2 -1 0; -1 3 0; 0 0 NaN or 5], column by column, with a last value of choice.
std::array<double, 9> full_values(double last) {
  return {2.0, -1.0, 0.0, -1.0, 3.0, 0.0, 0.0, 0.0, last};
}

void write_full(mat_t* file, const char* name, std::array<double, 9> values) {
  std::array<std::size_t, 2> sizes{3, 3};
  matvar_t* matrix =
      Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values.data(), 0);
  Mat_VarWrite(file, matrix, MAT_COMPRESSION_NONE);
  Mat_VarFree(matrix);
}

/// @param rows  of the numbers 2, -1, -1, 3, 5.
void write_sparse(mat_t* file, const char* name, std::array<mat_uint32_t, 5> rows) {
  std::array<mat_uint32_t, 4> starts{0, 2, 4, 5};
  std::array<double, 5> values{2.0, -1.0, -1.0, 3.0, 5.0};
  mat_sparse_t sparse{};
  sparse.nzmax = 5;
  sparse.nir = 5;
  sparse.ir = rows.data();
  sparse.njc = 4;
  sparse.jc = starts.data();
  sparse.ndata = 5;
  sparse.data = values.data();
  std::array<std::size_t, 2> sizes{3, 3};
  matvar_t* matrix = Mat_VarCreate(name, MAT_C_SPARSE, MAT_T_DOUBLE, 2, sizes.data(), &sparse,
                                   MAT_F_DONT_COPY_DATA);
  Mat_VarWrite(file, matrix, MAT_COMPRESSION_NONE);
  Mat_VarFree(matrix);
}

constexpr std::array<mat_uint32_t, 5> kRows{0, 1, 0, 1, 2};

void write_matlab(const std::string& path, mat_ft version, double last = 5.0,
                  std::array<mat_uint32_t, 5> rows = kRows) {
  mat_t* file = Mat_CreateVer(path.c_str(), nullptr, version);
  write_full(file, "F", full_values(last));
  write_sparse(file, "S", rows);
  Mat_Close(file);
}

void put_dataset(hid_t file, const char* name, const std::vector<hsize_t>& sizes,
                 const std::vector<double>& values) {
  const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
  const hid_t set =
      H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(set);
  H5Sclose(space);
}

/// A dense dataset, and a group as users of SciPy write one.
void write_hdf5(const std::string& path) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const std::array<double, 9> full = full_values(5.0);
  H5Gclose(H5Gcreate2(file, "/model", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Gclose(H5Gcreate2(file, "/model/S", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  put_dataset(file, "/model/F", {3, 3}, {full.begin(), full.end()});
  put_dataset(file, "/model/S/data", {5}, {2.0, -1.0, -1.0, 3.0, 5.0});
  put_dataset(file, "/model/S/indices", {5}, {0.0, 1.0, 0.0, 1.0, 2.0});
  put_dataset(file, "/model/S/indptr", {4}, {0.0, 2.0, 4.0, 5.0});
  put_dataset(file, "/model/S/shape", {2}, {3.0, 3.0});
  H5Fclose(file);
}

void expect_equal(const SymmetricEntries& found, const SymmetricEntries& expected) {
  EXPECT_EQ(found.size, expected.size);
  EXPECT_EQ(found.row, expected.row);
  EXPECT_EQ(found.column, expected.column);
  EXPECT_EQ(found.value, expected.value);
}

class MatrixFile : public ::testing::Test {
 protected:
  [[nodiscard]] SymmetricEntries of_matrix_market() const {
    test::put(folder_.file("k.mtx"),
              "%%MatrixMarket matrix coordinate real general\n3 3 5\n"
              "1 1 2\n2 1 -1\n1 2 -1\n2 2 3\n3 3 5\n");
    return read_matrix_file(folder_.file("k.mtx"));
  }
  [[nodiscard]] std::string fault(const std::string& name) const {
    const std::string text =
        message_of<Error>([&] { return read_matrix_file(folder_.file(name)); });
    return text.substr(std::min(text.rfind('/') + 1, text.size()));
  }

  test::TemporaryFolder folder_;
};

// Bit by bit: the numbers are stored as doubles, and taken over as they are.
TEST_F(MatrixFile, OfEachFormatHasTheSameEntries) {
  const SymmetricEntries expected = of_matrix_market();
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    write_matlab(folder_.file("k.mat"), version);
    expect_equal(read_matrix_file(folder_.file("k.mat:F")), expected);
    expect_equal(read_matrix_file(folder_.file("k.mat:S")), expected);
  }
  write_hdf5(folder_.file("k.h5"));
  expect_equal(read_matrix_file(folder_.file("k.h5:/model/F")), expected);
  expect_equal(read_matrix_file(folder_.file("k.h5:model/S")), expected);
}

TEST_F(MatrixFile, NamesWhatIsWrong) {
  write_matlab(folder_.file("k.mat"), MAT_FT_MAT5);
  EXPECT_EQ(fault("k.mat"),
            "k.mat = 2 matrices; must be one; there is 'F', 'S'. Name one after a colon, k.mat:F.");
  EXPECT_NE(fault("k.mat:G").find("must exist; the file has 'F', 'S'"), std::string::npos);
  write_matlab(folder_.file("nan.mat"), MAT_FT_MAT5, std::nan(""));
  EXPECT_EQ(fault("nan.mat:F"), "nan.mat:F: entry (3, 3) = nan; must be finite");
  write_matlab(folder_.file("bad.mat"), MAT_FT_MAT5, 5.0, {0, 2, 0, 1, 2});
  EXPECT_NE(
      fault("bad.mat:S")
          .find("as the matrix must be symmetric. If only one triangle is stored, store both."),
      std::string::npos);
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    write_matlab(folder_.file("far.mat"), version, 5.0, {0, 1, 0, 1, 7});
    EXPECT_NE(fault("far.mat:S").find("a row 8 of 3"), std::string::npos);
  }
  (void)of_matrix_market();
  EXPECT_NE(fault("k.mtx:K").find("must follow a file of MATLAB, HDF5, OP4 or DMIG entries"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::matrix_file_test
