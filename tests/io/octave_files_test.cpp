// SPDX-License-Identifier: MIT

// Files that Octave 7.3 wrote (tests/data/octave/make.m): text, HDF5 and MAT files of version 4;
// values are those of make.m. MAT files of version 4 also as libmatio writes them, and by the bytes
// of their description [MathWorks, MAT-File Format, R2019b, chapter 2].

#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/mat_text.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"
#include "microslip/io/open/matrix_file.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::octave_files_test {
namespace {

using test::message_of;

std::string data(const char* name) { return std::string(MICROSLIP_TEST_DATA) + "/octave/" + name; }

const std::vector<double> kForceValues{0, 1, 2, 3, 2, 1, 0, -1};

class OctaveFiles : public testing::TestWithParam<const char*> {};

TEST_P(OctaveFiles, HaveRecordsOverARange) {
  const Recordings read = read_recordings(data(GetParam()), {});
  const Recording& recording = read.recordings.at(0);
  EXPECT_DOUBLE_EQ(recording.axis.step, 1e-3);
  EXPECT_EQ(recording.axis.start, 0.0);
  EXPECT_EQ(recording.channel("force").values, kForceValues);
  EXPECT_EQ(recording.channel("force").dimension, kForce);
}

TEST_P(OctaveFiles, HaveSparseMatrices) {
  const SymmetricEntries entries = read_matrix_file(data(GetParam()) + ":K");
  EXPECT_EQ(entries.size, 3);
}

INSTANTIATE_TEST_SUITE_P(All, OctaveFiles,
                         testing::Values("record.txt", "record.h5", "record.mat"));

class OctaveForms : public testing::TestWithParam<const char*> {};

TEST_P(OctaveForms, HaveStructsAndComplexNumbers) {
  const std::string path = data(GetParam());
  EXPECT_EQ(read_mat_array(path, "st.acc").sizes, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(read_mat_numbers(path, "st.acc"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read_mat_text(path, "st.units"), "m/s^2");
  EXPECT_EQ(read_mat_array(path, "z").real, (std::vector<double>{1, 3}));
  EXPECT_EQ(read_mat_array(path, "z").imaginary, (std::vector<double>{2, -4}));
}

INSTANTIATE_TEST_SUITE_P(All, OctaveForms, testing::Values("record.txt", "record.h5"));

TEST(OctaveText, HasCellsArraysOfStructsAndEmptyValues) {
  const std::string path = data("record.txt");
  EXPECT_EQ(read_mat_numbers(path, "many(2).x"), (std::vector<double>{4, 5}));
  EXPECT_EQ(read_mat_numbers(path, "many(1).dt"), (std::vector<double>{0.5}));
  EXPECT_EQ(read_mat_numbers(path, "c{3}"), (std::vector<double>{7, 8}));
  EXPECT_EQ(read_mat_text(path, "c{1}"), "a");
  EXPECT_EQ(mat_count(path, "nothing"), 0U);
  EXPECT_EQ(mat_fields(path, "many"), (std::vector<std::string>{"dt", "x"}));
  EXPECT_EQ(read_matrix_file(path + ":D").size, 3);
}

// As Octave 7.3 saves f = @(q) fs * q, i = find (x > 1) and a struct with both.
TEST(OctaveText, KeepsWhatValuesHoldWithinThem) {
  const std::string handle =
      "# type: function handle\n@<anonymous>\n@(q) fs * q\n# length: 1\n# name: fs\n"
      "# type: scalar\n100\n\n\n\n\n";
  const std::string found =
      "# type: lazy_index\n# name: index_value\n# type: matrix\n# rows: 1\n# columns: 2\n"
      " 3 4\n\n\n\n\n";
  const std::string x = "# name: x\n# type: matrix\n# rows: 1\n# columns: 3\n 1 2 3\n\n\n";
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  test::put(path, "# Created by Octave 7.3.0\n" + x + "# name: f\n" + handle + "# name: i\n" +
                      found + "# name: i2\n" + found + "# name: h\n# type: function handle\nsin\n" +
                      "\n\n# name: o\n# type: object\n# classname: c\n# length: 1\n" + x +
                      "\n\n# name: s\n# type: scalar struct\n# ndims: 2\n 1 1\n# length: 3\n" +
                      "# name: f\n" + handle + "# name: i\n" + found + x + "\n\n");
  EXPECT_EQ(mat_fields(path, ""), (std::vector<std::string>{"x", "f", "i", "i2", "h", "o", "s"}));
  EXPECT_EQ(mat_fields(path, "s"), (std::vector<std::string>{"f", "i", "x"}));
  EXPECT_EQ(read_mat_numbers(path, "i2"), (std::vector<double>{3, 4}));
  EXPECT_EQ(read_mat_numbers(path, "s.i"), (std::vector<double>{3, 4}));
  EXPECT_EQ(read_mat_numbers(path, "s.x"), (std::vector<double>{1, 2, 3}));
  EXPECT_NE(message_of<Error>([&] { (void)read_recordings(path, {}); }).find("a sampling rate"),
            std::string::npos)
      << "100 is not its rate";
}

class OctaveTextForms : public testing::Test {
 protected:
  std::string message(const std::string& text) {
    test::put(path_, "# Created by Octave 7.3.0\n" + text);
    return message_of<Error>([&] { (void)read_mat_numbers(path_, "x"); });
  }
  std::vector<double> numbers(const std::string& text) {
    test::put(path_, "# Created by Octave 7.3.0\n" + text);
    return read_mat_numbers(path_, "x");
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.txt");
};

// As Octave writes an array of three dimensions, integers and a range that misses its limit.
TEST_F(OctaveTextForms, AreReadColumnByColumn) {
  EXPECT_EQ(numbers("# name: x\n# type: matrix\n# ndims: 3\n 2 1 2\n 1\n 2\n 3\n 4\n"),
            (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(numbers("# name: x\n# type: int16 matrix\n# ndims: 2\n 1 2\n  -7\n  9\n"),
            (std::vector<double>{-7, 9}));
  EXPECT_EQ(
      numbers("# name: x\r\n# type: global range\r\n# base, limit, increment\r\n1 2.4 0.5\r\n"),
      (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(numbers("# name: x\n# type: bool\n1\n"), (std::vector<double>{1}));
}

TEST_F(OctaveTextForms, HaveDiagonalsOfAnyNumber) {
  const std::string sizes = "# rows: 2\n# columns: 2\n";
  const auto read = [&](const std::string& text) {
    test::put(path_, "# Created by Octave 7.3.0\n" + text);
    return read_matrix_file(path_ + ":x").size;
  };
  EXPECT_EQ(read("# name: x\n# type: float diagonal matrix\n" + sizes + "1\n2\n"), 2);
  test::put(path_, "# Created by Octave 7.3.0\n# name: z\n# type: complex diagonal matrix\n" +
                       sizes + "(1,2)\n(2,0)\n\n\n# name: x\n# type: scalar\n7\n");
  EXPECT_EQ(read_mat_numbers(path_, "x"), (std::vector<double>{7}));
}

// A range takes three numbers whatever its length.
TEST_F(OctaveTextForms, MayHoldALongRangeBesides) {
  EXPECT_EQ(numbers("# name: r\n# type: range\n# base, limit, increment\n0 1e9 1\n\n\n"
                    "# name: x\n# type: scalar\n7\n"),
            (std::vector<double>{7}));
}

TEST_F(OctaveTextForms, NameTheLineOfAFault) {
  EXPECT_NE(message("# name: x\n# type: matrix\n# rows: 1\n# columns: 2\n 1 here\n").find(":6"),
            std::string::npos);
  EXPECT_NE(
      message("# name: x\n# type: matrix\n# rows: 9\n# columns: 9\n 1 2\n").find("It is truncated"),
      std::string::npos);
  EXPECT_NE(message("# name: x\n# type: range\n# base, limit, increment\n0 1e9 1\n").find("range"),
            std::string::npos)
      << "no file of this size has so many";
  EXPECT_NE(message("# name: x\n# type: scalar\n1\n# name: x\n# type: scalar\n1\n").find("twice"),
            std::string::npos);
  EXPECT_NE(message("# name: x\n# type: inline function\n").find("inline function"),
            std::string::npos);
}

TEST_F(OctaveTextForms, MayEndEarly) {
  test::put(
      path_,
      "# Created by Octave 7.3.0\n# name: fs\n# type: scalar\n10\n# name: a\n# type: matrix\n"
      "# rows: 2\n# columns: 1\n 1\n 2\n# name: b\n# type: matrix\n# rows: 2\n# columns: 1\n");
  EXPECT_NE(message_of<Error>([&] { (void)read_recordings(path_, {}); }).find("allow_truncated"),
            std::string::npos);
  const Recordings read = read_recordings(path_, {.allow_truncated = true});
  EXPECT_EQ(read.recordings.at(0).channels.size(), 1U);
  EXPECT_EQ(read.warnings.at(0).code, "file_truncated");
}

/// A matrix of version 4. @param type  its digits.
template <class T>
std::string matrix4(std::uint32_t type, std::uint32_t rows, std::uint32_t columns,
                    const std::string& name, const std::vector<T>& values, bool big = false) {
  std::string bytes;
  const auto add = [&](auto value) {
    std::array<char, sizeof value> raw;
    std::memcpy(raw.data(), &value, sizeof value);
    if (big) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
  };
  for (const std::uint32_t field : {type, rows, columns, 0U}) add(field);
  add(static_cast<std::uint32_t>(name.size() + 1));
  bytes += name + '\0';
  for (const T value : values) add(value);
  return bytes;
}

// The rows of a matrix of characters are stored column by column, in bytes: a letter of two bytes,
// \303\251 in UTF-8, is in one row, and of Latin-1 one byte is a letter.
TEST(TextRowsOfBytes, AreDecodedRowByRow) {
  const std::vector<std::string> expected{"é", "ab"};
  EXPECT_EQ(text_rows_of_bytes("\303a\251b", 2), expected);
  EXPECT_EQ(text_rows_of_bytes("\351a b", 2), expected);
  EXPECT_EQ(text_rows_of_bytes("é ", 1), std::vector<std::string>{"é "});
}

class Mat4 : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mat");
};

TEST_F(Mat4, ReadsWhatLibmatioWrites) {
  std::vector<double> time{0, 0.1, 0.2};
  std::vector<double> acc{1, -1, 2};
  mat_t* file = Mat_CreateVer(path_.c_str(), nullptr, MAT_FT_MAT4);
  std::array<std::size_t, 2> sizes{3, 1};
  for (const auto& [name, values] : {std::pair{"time", &time}, std::pair{"acc", &acc}}) {
    matvar_t* variable =
        Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values->data(), 0);
    Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }
  Mat_Close(file);
  const Recordings read = read_recordings(path_, {});
  EXPECT_EQ(read.recordings.at(0).channel("acc").values, acc);
  EXPECT_NEAR(read.recordings.at(0).axis.step, 0.1, 1e-15);
}

TEST_F(Mat4, ReadsEveryKindOfNumberInEitherByteOrder) {
  for (const bool big : {false, true}) {
    const std::uint32_t order = big ? 1000 : 0;
    test::put(path_, matrix4<double>(order, 1, 1, "fs", {50}, big) +
                         matrix4<float>(order + 10, 2, 1, "f", {1.5F, -2}, big) +
                         matrix4<std::int32_t>(order + 20, 2, 1, "i", {-70000, 1}, big) +
                         matrix4<std::int16_t>(order + 30, 2, 1, "s", {-3, 4}, big) +
                         matrix4<std::uint16_t>(order + 40, 2, 1, "u", {65535, 0}, big) +
                         matrix4<std::uint8_t>(order + 50, 2, 1, "b", {255, 7}, big) +
                         matrix4<std::uint8_t>(order + 51, 1, 1, "f_unit", {'N'}, big));
    const Recording recording = read_recordings(path_, {}).recordings.at(0);
    EXPECT_EQ(recording.sampling_rate(), 50.0);
    EXPECT_EQ(recording.channel("f").values, (std::vector<double>{1.5, -2}));
    EXPECT_EQ(recording.channel("f").dimension, kForce);
    EXPECT_EQ(recording.channel("i").values, (std::vector<double>{-70000, 1}));
    EXPECT_EQ(recording.channel("s").values, (std::vector<double>{-3, 4}));
    EXPECT_EQ(recording.channel("u").values, (std::vector<double>{65535, 0}));
    EXPECT_EQ(recording.channel("b").values, (std::vector<double>{255, 7}));
  }
}

TEST_F(Mat4, MayBeginWithAnEmptyVariable) {
  for (const bool big : {false, true}) {
    const std::uint32_t order = big ? 1000 : 0;
    test::put(path_, matrix4<double>(order, 0, 0, "nothing", {}, big) +
                         matrix4<double>(order, 0, 3, "none", {}, big) +
                         matrix4<double>(order, 1, 1, "fs", {50}, big) +
                         matrix4<double>(order, 2, 1, "acc", {1, 2}, big));
    EXPECT_EQ(read_recordings(path_, {}).recordings.at(0).channel("acc").values,
              (std::vector<double>{1, 2}));
  }
  test::put(path_,
            std::string(16, '\0') + std::string("\2\0\0\0a\0rubbish", 13) + std::string(40, 'x'));
  EXPECT_NE(message_of<Error>([&] {
              (void)read_recordings_mat(path_);
            }).find("expected a MAT file of MATLAB"),
            std::string::npos);
}

TEST_F(Mat4, NamesWhatIsDamaged) {
  const std::string good = matrix4<double>(0, 2, 1, "a", {1, 2});
  const auto message = [&](const std::string& bytes) {
    test::put(path_, bytes);
    return message_of<Error>([&] { (void)read_recordings_mat(path_); });
  };
  EXPECT_NE(message(good + good).find("twice"), std::string::npos);
  const std::string other = matrix4<double>(0, 2, 1, "b", {1, 2});
  EXPECT_NE(message(good + other.substr(0, 30)).find("the end of the file"), std::string::npos);
  EXPECT_NE(message(good + matrix4<double>(2, 1, 3, "s", {-1, 0, 0})).find("sparse"),
            std::string::npos);
  EXPECT_NE(message(good + matrix4<double>(300, 1, 1, "v", {1})).find("type 300"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::octave_files_test
