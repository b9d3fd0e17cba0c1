// SPDX-License-Identifier: MIT

// Lists of units in files of HDF5, which gives fields by name and not in the order of the program
// that wrote them: MATLAB's v7.3 states that order in the attribute MATLAB_fields of a struct, as
// libmatio writes it too; variables at the top and files of Octave (order.h5, order_top.h5 of
// tests/data/octave/make.m) have none.

#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::units_order_test {
namespace {

std::string data(const char* name) { return std::string(MICROSLIP_TEST_DATA) + "/octave/" + name; }

class UnitsOrder : public testing::Test {
 protected:
  /// A struct q with time, z, a and units, in this order.
  void write_73(std::string units) {
    mat_t* file = Mat_CreateVer(path_.c_str(), nullptr, MAT_FT_MAT73);
    std::array<std::size_t, 2> one{1, 1};
    std::array<const char*, 4> names{"time", "z", "a", "units"};
    matvar_t* q = Mat_VarCreateStruct("q", 2, one.data(), names.data(), names.size());
    set(q, "time", {0.0, 0.5, 1.0});
    set(q, "z", {1.0, 2.0, 3.0});
    set(q, "a", {4.0, 5.0, 6.0});
    std::vector<std::uint16_t> letters(units.begin(), units.end());
    std::array<std::size_t, 2> sizes{1, letters.size()};
    Mat_VarSetStructFieldByName(
        q, "units", 0,
        Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT16, 2, sizes.data(), letters.data(), 0));
    Mat_VarWrite(file, q, MAT_COMPRESSION_NONE);
    Mat_VarFree(q);
    Mat_Close(file);
  }

  /// Takes MATLAB_fields away; puts one of another type of text there, unless it is negative.
  void replace_fields(hid_t type, const void* names) const {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Adelete_by_name(file, "q", "MATLAB_fields", H5P_DEFAULT);
    if (type >= 0) {
      const hsize_t four = 4;
      const hid_t space = H5Screate_simple(1, &four, nullptr);
      const hid_t at = H5Acreate_by_name(file, "q", "MATLAB_fields", type, space, H5P_DEFAULT,
                                         H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(at, type, names);
      H5Aclose(at);
      H5Sclose(space);
    }
    H5Fclose(file);
  }

  void expect_in_order() {
    const Recordings read = read_recordings(path_, {});
    EXPECT_EQ(read.recordings.at(0).channel("z").dimension, kForce);
    EXPECT_EQ(read.recordings[0].channel("a").dimension, kLength);
    EXPECT_DOUBLE_EQ(read.recordings[0].channel("a").values.at(2), 6e-3);
    EXPECT_TRUE(read.warnings.empty());
  }

  static void expect_none(const Recordings& read) {
    for (const Channel& channel : read.recordings.at(0).channels) {
      EXPECT_FALSE(channel.dimension) << channel.name;
    }
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_EQ(read.warnings[0].code, "units_not_assigned");
    EXPECT_NE(read.warnings[0].text.find("does not keep the order"), std::string::npos);
    EXPECT_NE(read.warnings[0].text.find("_unit"), std::string::npos);
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mat");

 private:
  static void set(matvar_t* to, const char* name, std::vector<double> values) {
    std::array<std::size_t, 2> sizes{values.size(), 1};
    Mat_VarSetStructFieldByName(
        to, name, 0,
        Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values.data(), 0));
  }
};

TEST_F(UnitsOrder, IsThatOfTheStructOfMatlab) {
  for (const char* units : {"s, N, mm", "N, mm"}) {
    write_73(units);
    expect_in_order();
  }
  EXPECT_EQ(mat_fields(path_, "q"), (std::vector<std::string>{"time", "z", "a", "units"}));
}

TEST_F(UnitsOrder, MayBeStatedByTextsOfAnyKind) {
  write_73("N, mm");
  const hid_t fixed = H5Tcopy(H5T_C_S1);
  H5Tset_size(fixed, 5);
  replace_fields(fixed, "time\0z\0\0\0\0a\0\0\0\0units");
  H5Tclose(fixed);
  expect_in_order();
  const hid_t variable = H5Tcopy(H5T_C_S1);
  H5Tset_size(variable, H5T_VARIABLE);
  const std::array<const char*, 4> names{"time", "z", "a", "units"};
  replace_fields(variable, names.data());
  H5Tclose(variable);
  expect_in_order();
}

TEST_F(UnitsOrder, IsNotGuessedWhereNoneIsStated) {
  write_73("N, mm");
  replace_fields(-1, nullptr);
  expect_none(read_recordings(path_, {}));
}

TEST_F(UnitsOrder, IsNotGuessedInFilesOfOctave) {
  expect_none(read_recordings(data("order_top.h5"), {}));
  const Recordings read = read_recordings(data("order.h5"), {});
  ASSERT_EQ(read.warnings.size(), 1U) << "the units of w are the same for all";
  for (const Recording& recording : read.recordings) {
    const auto expected = recording.source == "order.h5:w" ? std::optional(kForce) : std::nullopt;
    if (recording.source.find("many") != std::string::npos) continue;
    EXPECT_EQ(recording.channel("z").dimension, expected) << recording.source;
    EXPECT_EQ(recording.channel("a").dimension, expected) << recording.source;
  }
}

// As in its text: many(2) is over 0.25 s.
TEST_F(UnitsOrder, LeavesArraysOfStructsOfOctaveAsTheyAre) {
  const Recordings read = read_recordings(data("order.h5"), {});
  const Recording& second = read.recordings.at(1);
  EXPECT_EQ(second.source, "order.h5:many(2)");
  EXPECT_EQ(second.axis.step, 0.25);
  EXPECT_EQ(second.channel("x").values, (std::vector<double>{4, 5}));
  EXPECT_EQ(mat_count(data("order.h5"), "empty"), 0U);
  EXPECT_EQ(mat_count(data("order.h5"), "none"), 0U);
}

}  // namespace
}  // namespace microslip::units_order_test
