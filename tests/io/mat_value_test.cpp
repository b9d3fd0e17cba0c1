// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_value.hpp"

#include <gtest/gtest.h>
#include <matio.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/damaged_binary.hpp"
#include "io/support.hpp"
#include "microslip/io/mat/mat_file.hpp"

namespace microslip::mat_value_test {
namespace {

using test::message_of;

/// Files that SciPy made, see make.py there.
std::string sample(const std::string& name) {
  return std::string(MICROSLIP_TEST_DATA) + "/mat/" + name;
}

class MatValueOfVersion5 : public ::testing::TestWithParam<const char*> {
 protected:
  std::string path_ = sample(GetParam());
};

INSTANTIATE_TEST_SUITE_P(SciPy, MatValueOfVersion5,
                         ::testing::Values("plain5.mat", "compressed5.mat"),
                         [](const auto& test) { return std::string(test.param, 5); });

TEST_P(MatValueOfVersion5, HasTheNumbersOfItsWriter) {
  EXPECT_EQ(read_mat_numbers(path_, "fs"), (std::vector{512.0}));
  EXPECT_EQ(read_mat_numbers(path_, "force"), (std::vector{0.5, -1.25, 3e-300}));
  EXPECT_EQ(read_mat_numbers(path_, "counts"), (std::vector{-3.0, 200.0, 7.0}));
  EXPECT_EQ(read_mat_numbers(path_, "single"), (std::vector<double>{0.1F, 0.2F}));
  EXPECT_TRUE(read_mat_numbers(path_, "empty").empty());
  const MatArray complex = read_mat_array(path_, "nested.channels(2).values");
  EXPECT_EQ(complex.sizes, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(complex.real, (std::vector{1.0, -3.0, 0.0}));
  EXPECT_EQ(complex.imaginary, (std::vector{2.0, 0.0, 0.5}));
}

TEST_P(MatValueOfVersion5, HasTheTextsOfItsWriter) {
  EXPECT_EQ(read_mat_text(path_, "text"), "größe");
  EXPECT_EQ(read_mat_text(path_, "nested.channels(1).unit"), "lbf");
  EXPECT_EQ(read_mat_text(path_, "nested.cell{1}"), "x");
}

TEST_P(MatValueOfVersion5, CountsFromOneInRoundBracketsAndFromZeroInSquareOnes) {
  EXPECT_EQ(read_mat_text(path_, "nested.channels(2).name"), "response");
  EXPECT_EQ(read_mat_text(path_, "nested.channels[1].name"), "response");
  EXPECT_EQ(read_mat_numbers(path_, "nested.cell{2}"), read_mat_numbers(path_, "nested.cell[1]"));
}

TEST_P(MatValueOfVersion5, ListsWhatThereIs) {
  EXPECT_EQ(mat_fields(path_, ""), (std::vector<std::string>{"fs", "force", "counts", "text",
                                                             "rows", "nested", "empty", "single"}));
  EXPECT_EQ(mat_fields(path_, "nested.channels"),
            (std::vector<std::string>{"name", "unit", "values"}));
  EXPECT_EQ(mat_count(path_, "nested.channels"), 2U);
  EXPECT_EQ(mat_count(path_, "force"), 3U);
}

TEST_P(MatValueOfVersion5, NamesWhatExistsWhereAPathFails) {
  const auto message = [&](const char* variable) {
    const std::string text =
        message_of<InputError>([&] { return read_mat_numbers(path_, variable); });
    return text.substr(text.find("variable"));
  };
  EXPECT_EQ(message("nested.fz"),
            "variable = 'nested.fz'; must exist; 'nested' has 'fs', 'channels', 'cell'");
  EXPECT_EQ(message("force.x"),
            "variable = 'force.x'; must exist; 'force' is real numbers of 3 × 1");
  EXPECT_EQ(message("nested.channels.values"),
            "variable = 'nested.channels.values'; must specify an element of 'nested.channels': it "
            "has 2, (1) to (2)");
  EXPECT_EQ(message("nested.channels(3).values"),
            "variable = 'nested.channels(3).values'; must have an existing index; "
            "'nested.channels' is a struct of 1 × 2 with 'name', 'unit', 'values'");
  EXPECT_NE(message("nested.channels(0).values").find("an existing index"), std::string::npos);
  EXPECT_NE(message("nested.channels(x)").find("a whole number"), std::string::npos);
  EXPECT_NE(message("nested.channels(1").find("close its brackets"), std::string::npos);
  EXPECT_NE(message("nested..fs").find("as in MATLAB"), std::string::npos);
  EXPECT_NE(message("gone").find("the file has 'fs', 'force'"), std::string::npos);
}

/// matio writes a struct array with a cell in it, in a version of choice.
void write_by_matio(const std::string& path, mat_ft version, matio_compression compression) {
  mat_t* file = Mat_CreateVer(path.c_str(), nullptr, version);
  std::array<std::size_t, 2> sizes{1, 2};
  std::array<const char*, 2> names{"x", "c"};
  matvar_t* array = Mat_VarCreateStruct("s", 2, sizes.data(), names.data(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    std::array<std::size_t, 2> two_by_three{2, 3};
    std::array<std::int32_t, 6> values{1, 2, 3, 4, 5, static_cast<std::int32_t>(i)};
    matvar_t* numbers =
        Mat_VarCreate(nullptr, MAT_C_INT32, MAT_T_INT32, 2, two_by_three.data(), values.data(), 0);
    std::array<std::size_t, 2> one{1, 1};
    matvar_t* cell = Mat_VarCreate(nullptr, MAT_C_CELL, MAT_T_CELL, 2, one.data(), nullptr, 0);
    std::array<std::size_t, 2> four{1, 4};
    std::array<std::uint16_t, 4> text{'g', 'r', 0xF6, 0xDF};
    Mat_VarSetCell(
        cell, 0, Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT16, 2, four.data(), text.data(), 0));
    Mat_VarSetStructFieldByName(array, "x", i, numbers);
    Mat_VarSetStructFieldByName(array, "c", i, cell);
  }
  Mat_VarWrite(file, array, compression);
  Mat_VarFree(array);
  Mat_Close(file);
}

TEST(MatValue, ReadsWhatMatioWritesInEachVersion) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("m.mat");
  for (const auto& [version, compression] :
       {std::pair{MAT_FT_MAT5, MAT_COMPRESSION_NONE}, std::pair{MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
        std::pair{MAT_FT_MAT73, MAT_COMPRESSION_NONE},
        std::pair{MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}}) {
    write_by_matio(path, version, compression);
    SCOPED_TRACE(static_cast<int>(version) + static_cast<int>(compression));
    EXPECT_EQ(mat_count(path, "s"), 2U);
    const MatArray x = read_mat_array(path, "s(2).x");
    EXPECT_EQ(x.sizes, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(x.real, (std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 1.0}));
    EXPECT_EQ(read_mat_text(path, "s(1).c{1}"), "grö\xC3\x9F");
  }
}

TEST(MatValue, RefusesWhatIsNoMatFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.mat");
  test::put(path, "time [s],force [N]\n1,2\n");
  EXPECT_EQ(message_of<FormatError>([&] { return read_mat_numbers(path, "x"); }),
            path +
                ": expected a MAT file of MATLAB, version 4, 5 or 7.3, found a file that starts "
                "'time [s],force [N]\\x0A1…' (23 bytes). In MATLAB: save('name.mat', ..., '-v7').");
  EXPECT_NE(message_of<FileError>([&] {
              return mat_fields(folder.file("b.mat"), "");
            }).find("No such file"),
            std::string::npos);
}

class DamagedMatFile : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(SciPy, DamagedMatFile, ::testing::Values("plain5.mat", "compressed5.mat"),
                         [](const auto& test) { return std::string(test.param, 6); });

TEST_P(DamagedMatFile, IsReadOrRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("damaged.mat");
  test::put(path, test::get(sample(GetParam())));
  const auto read = [&] {
    for (const MatValue& value : read_mat_tree(path).root.children) (void)describe(value);
  };
  test::read_cut(path, 1, read);
  test::read_changed(path, 2, read);
}

// The checksum of compressed variables: what is read of a changed file is what was written. Only
// the bits that fill up the last byte of each of the 8 variables, before its checksum, mean
// nothing.
TEST(MatValue, FindsEveryChangeOfCompressedNumbers) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("changed.mat");
  const std::string whole = test::get(sample("compressed5.mat"));
  int unnoticed = 0;
  for (std::size_t at = 128; at < whole.size(); ++at) {
    std::string content = whole;
    content[at] = static_cast<char>(content[at] ^ 0x10);
    unnoticed +=
        test::survives(
            path, content,
            [&] {
              EXPECT_EQ(read_mat_numbers(path, "force"), (std::vector{0.5, -1.25, 3e-300})) << at;
            })
            ? 1
            : 0;
  }
  EXPECT_LE(unnoticed, 8);
}

void append_uint32(std::string& text, std::initializer_list<std::uint32_t> numbers) {
  for (const std::uint32_t number : numbers) {
    for (int byte = 0; byte < 4; ++byte) text += static_cast<char>(number >> (8 * byte) & 0xFFU);
  }
}

// The variable "x" of one double claims 64 bytes and has a million more behind them: it is refused
// when they begin, though it is not the one that is read.
TEST(MatValue, InflatesNoMoreThanAVariableClaims) {
  std::string variable;
  append_uint32(variable, {14, 56, 6, 8, 6, 0, 5, 8, 1, 1, 0x00010001U, 'x', 9, 8, 0, 0});
  for (const std::size_t more : {0U, 1000000U}) {
    const std::string inflated = variable + std::string(more, '\0');
    uLongf size = compressBound(inflated.size());
    std::string packed(size, '\0');
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                       reinterpret_cast<const Bytef*>(inflated.data()), inflated.size()),
              Z_OK);
    packed.resize(size);
    const std::string whole = test::get(sample("compressed5.mat"));
    std::string content = whole.substr(0, 128);
    append_uint32(content, {15, static_cast<std::uint32_t>(packed.size())});
    const test::TemporaryFolder folder;
    const std::string path = folder.file("a.mat");
    test::put(path, content + packed + whole.substr(128));
    if (more == 0) {
      EXPECT_EQ(read_mat_numbers(path, "force"), (std::vector{0.5, -1.25, 3e-300}));
      EXPECT_EQ(read_mat_numbers(path, "x"), std::vector{0.0});
    } else {
      EXPECT_NE(message_of<FormatError>([&] {
                  return read_mat_numbers(path, "force");
                }).find("expected the end of the variable, found more bytes"),
                std::string::npos);
    }
  }
}

// Chen et al., Jin et al., MSSP 166 (2022) 108401, 108402; the figures are those that SciPy 1.10.1
// reads from the authors' file.
TEST(MatValue, ReadsTheBrakeReussBeam) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const std::string path = std::string(folder) + "/brake_reuss_beam/ForcedFrequencyResponses.mat";
  EXPECT_EQ(mat_count(path, "FRdata.ResponseControl"), 8U);
  EXPECT_EQ(mat_count(path, "FRdata.ForceControl"), 4U);
  EXPECT_EQ(mat_fields(path, "FRdata.ResponseControl(3)"),
            (std::vector<std::string>{"frequency", "force", "amplitude", "phase", "units"}));
  EXPECT_EQ(read_mat_text(path, "FRdata.ResponseControl(3).units"), "Hz, N, m/s^2, rad");
  const std::vector<double> force = read_mat_numbers(path, "FRdata.ResponseControl[2].force");
  ASSERT_EQ(force.size(), 41U);
  EXPECT_EQ(force.front(), 1.494955800401406);
  EXPECT_EQ(force.back(), 1.3552123605060875);
  const std::vector<double> phase = read_mat_numbers(path, "FRdata.ResponseControl(3).phase");
  EXPECT_EQ(phase.front(), -0.24681515269022938);
  EXPECT_EQ(phase.back(), -2.980297260406708);
}

}  // namespace
}  // namespace microslip::mat_value_test
