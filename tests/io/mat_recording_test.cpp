// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_recording.hpp"

#include <gtest/gtest.h>
#include <matio.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/damaged_binary.hpp"
#include "io/sample_recordings.hpp"
#include "io/support.hpp"
#include "microslip/io/mat/mat5_writer.hpp"

namespace microslip::mat_recording_test {
namespace {

using test::message_of;

std::string sample(const std::string& name) {
  return std::string(MICROSLIP_TEST_DATA) + "/mat/" + name;
}

class MatRecording : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mat");
};

TEST_F(MatRecording, SurvivesTheRoundTripBitForBit) {
  const std::vector<Recording> written = test::twelve_recordings();
  write_recordings_mat(path_, written);
  const Recordings read = read_recordings_mat(path_);
  test::expect_same(read.recordings, written);
  EXPECT_TRUE(read.warnings.empty());
}

// With the time in it, as MATLAB writes it, no two files of one recording would be the same.
TEST_F(MatRecording, HeadingHoldsNoTime) {
  write_recordings_mat(path_, test::twelve_recordings());
  const std::string heading = test::get(path_).substr(0, 116);
  const std::string text = "MATLAB 5.0 MAT-file, written by microslip";
  EXPECT_EQ(heading, text + std::string(116 - text.size(), ' '));
}

using MatioFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using MatioVariable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;

std::vector<double> doubles_of(const matvar_t* variable) {
  if (variable == nullptr) return {};
  const auto* values = static_cast<const double*>(variable->data);
  return {values, values + variable->nbytes / sizeof(double)};
}

std::string text_of(const matvar_t* variable) {
  if (variable == nullptr) return "missing";
  if (variable->data_type == MAT_T_UTF8) {  // Scilab keeps the first letter of any other
    return {static_cast<const char*>(variable->data), variable->nbytes};
  }
  const auto* units = static_cast<const std::uint16_t*>(variable->data);
  return {units, units + variable->nbytes / sizeof(std::uint16_t)};
}

// matio, as an independent reader, finds what the comment of mat_recording.hpp promises.
TEST_F(MatRecording, IsReadByMatio) {
  const std::vector<Recording> written{test::time_recording(), test::frequency_recording()};
  write_recordings_mat(path_, written);
  const MatioFile file(Mat_Open(path_.c_str(), MAT_ACC_RDONLY), Mat_Close);
  ASSERT_TRUE(file);
  for (const Recording& r : written) {
    const std::string name = &r == written.data() ? "recording_1" : "recording_2";
    const MatioVariable found(Mat_VarRead(file.get(), name.c_str()), Mat_VarFree);
    ASSERT_TRUE(found) << name;
    ASSERT_EQ(found->class_type, MAT_C_STRUCT);
    const auto field = [&](const char* key) {
      return Mat_VarGetStructFieldByName(found.get(), key, 0);
    };
    EXPECT_EQ(text_of(field("schema")), "microslip.recording/1");
    if (r.axis.even()) {
      EXPECT_EQ(doubles_of(field("start")), std::vector{r.axis.start});
      EXPECT_EQ(doubles_of(field("step")), std::vector{r.axis.step});
    } else {
      EXPECT_EQ(doubles_of(field("axis")), r.axis.values);
    }
    matvar_t* channels = field("channels");
    ASSERT_EQ(channels->dims[0] * channels->dims[1], r.channels.size());
    for (std::size_t i = 0; i < r.channels.size(); ++i) {
      const Channel& channel = r.channels[i];
      const auto part = [&](const char* key) {
        return Mat_VarGetStructFieldByName(channels, key, i);
      };
      EXPECT_EQ(text_of(part("name")), channel.name);
      const matvar_t* values = part("values");
      EXPECT_EQ(values->dims[0], channel.values.size());
      EXPECT_EQ(values->isComplex != 0, !channel.imaginary.empty());
      if (channel.imaginary.empty()) {
        EXPECT_EQ(doubles_of(values), channel.values);
      } else {
        const auto* parts = static_cast<const mat_complex_split_t*>(values->data);
        const auto* real = static_cast<const double*>(parts->Re);
        const auto* imaginary = static_cast<const double*>(parts->Im);
        EXPECT_TRUE(std::ranges::equal(channel.values, std::span(real, channel.values.size())));
        EXPECT_TRUE(
            std::ranges::equal(channel.imaginary, std::span(imaginary, channel.values.size())));
      }
      EXPECT_EQ(part("attributes")->class_type, MAT_C_CELL);
      EXPECT_EQ(part("attributes")->dims[0], channel.attributes.size());
    }
  }
}

// The format counts the bytes of a variable in 31 bits. That is seen before any value is looked at,
// so the values of this test are pages that are never there.
TEST_F(MatRecording, RefusesWhatTheFormatCannotHold) {
  const std::size_t bytes = std::size_t{1} << 31U;
  void* pages = mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(pages, MAP_FAILED);
  const std::span values(static_cast<const double*>(pages), bytes / sizeof(double));
  const std::vector<Mat5Variable> variables{{"x", Mat5Array::column(values, {})}};
  EXPECT_EQ(message_of<InputError>([&] { write_mat5(path_, variables); }),
            path_ +
                ":x = 2.1 GB; must be below 2 GiB in a MAT file of version 5. Write an HDF5 file "
                "(.h5), or parts of the recording.");
  EXPECT_FALSE(std::filesystem::exists(path_));
  munmap(pages, bytes);
}

TEST_F(MatRecording, ReadsOneOfSeveral) {
  const std::vector<Recording> written = test::twelve_recordings();
  write_recordings_mat(path_, written);
  const Recordings read = read_recordings_mat(path_, "recording_12");
  ASSERT_EQ(read.recordings.size(), 1U);
  test::expect_same(read.recordings, {written[11]});
}

TEST_F(MatRecording, TakesVectorsAtTheTopAndStructsBelow) {
  for (const char* name : {"plain5.mat", "compressed5.mat"}) {
    const Recordings read = read_recordings_mat(sample(name));
    ASSERT_EQ(read.recordings.size(), 3U) << name;
    const Recording& top = read.recordings[0];
    EXPECT_EQ(top.source, name);
    EXPECT_EQ(top.sampling_rate(), 512.0);
    EXPECT_EQ(top.channel("force").values, (std::vector{0.5, -1.25, 3e-300}));
    EXPECT_FALSE(top.channel("force").dimension);
    const Recording& nested = read.recordings[2];
    EXPECT_EQ(nested.sampling_rate(), 256.0);
    EXPECT_EQ(nested.channel("force").values[0], 4.4482216152605);
    EXPECT_EQ(nested.channel("force").dimension, kForce);
    EXPECT_EQ(nested.channel("response").imaginary, (std::vector{2e-3, 0.0, 0.5e-3}));
  }
}

TEST_F(MatRecording, TakesAVectorOfItsOwn) {
  const Recordings read = read_recordings_mat(sample("plain5.mat"), "force");
  ASSERT_EQ(read.recordings.size(), 1U);
  ASSERT_EQ(read.recordings[0].channels.size(), 1U);
  EXPECT_EQ(read.recordings[0].channels[0].name, "force");
  EXPECT_EQ(read.recordings[0].sampling_rate(), 512.0);
}

matvar_t* column_by_matio(const char* name, std::vector<double> values) {
  std::array<std::size_t, 2> sizes{values.size(), 1};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values.data(), 0);
}

TEST_F(MatRecording, TakesOneLetterAsTheAxisOnlyWhereItRises) {
  const auto read_with_f = [&](std::vector<double> f) {
    mat_t* file = Mat_CreateVer(path_.c_str(), nullptr, MAT_FT_MAT5);
    const auto add = [&](const char* name, std::vector<double> values) {
      matvar_t* variable = column_by_matio(name, std::move(values));
      Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
      Mat_VarFree(variable);
    };
    add("fs", {8.0});
    add("f", std::move(f));
    add("x", {1.0, 2.0, 3.0});
    Mat_Close(file);
    return read_recordings_mat(path_).recordings.at(0);
  };
  const Recording history = read_with_f({1.0, 3.0, 2.0});
  EXPECT_EQ(history.sampling_rate(), 8.0);
  EXPECT_EQ(history.channel("f").values, (std::vector{1.0, 3.0, 2.0}));
  EXPECT_EQ(history.channels.size(), 2U);
  const Recording sweep = read_with_f({1.0, 2.0, 4.0});
  EXPECT_EQ(sweep.axis.dimension, kFrequency);
  EXPECT_EQ(sweep.channels.size(), 1U);
}

// Whatever program it was: nothing says which of the two holds, and values are taken by name.
TEST_F(MatRecording, RefusesAVariableThatIsThereTwice) {
  write_recordings_mat(path_, std::vector{test::time_recording()});
  const std::string once = test::get(path_);
  test::put(path_, once + once.substr(128));
  EXPECT_NE(message_of<FormatError>([&] {
              return read_recordings_mat(path_);
            }).find("expected each variable once, found 'recording_1' twice"),
            std::string::npos);
}

TEST_F(MatRecording, RefusesAFieldThatIsThereTwice) {
  write_recordings_mat(path_, std::vector{test::time_recording()});
  std::string content = test::get(path_);
  const std::size_t at = content.find("start");
  ASSERT_NE(at, std::string::npos);
  content.replace(at, 6, std::string("step\0\0", 6));
  test::put(path_, content);
  EXPECT_NE(message_of<FormatError>([&] {
              return read_recordings_mat(path_);
            }).find("expected each field of a struct once, found 'step' twice"),
            std::string::npos);
}

/// A struct of vectors of three numbers, and texts.
class StructFile {
 public:
  void add(const char* name, const char* text) {
    std::array<std::size_t, 2> sizes{1, std::string_view(text).size()};
    fields_.push_back(name);
    values_.push_back(Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, sizes.data(),
                                    const_cast<char*>(text), 0));
  }
  void add(const char* name, std::array<double, 3> values) {
    std::array<std::size_t, 2> sizes{3, 1};
    fields_.push_back(name);
    values_.push_back(
        Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values.data(), 0));
  }
  Recordings read(const std::string& path) {
    std::array<std::size_t, 2> one{1, 1};
    matvar_t* data = Mat_VarCreateStruct("data", 2, one.data(), fields_.data(),
                                         static_cast<unsigned>(fields_.size()));
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      Mat_VarSetStructFieldByName(data, fields_[i], 0, values_[i]);
    }
    mat_t* file = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
    Mat_VarWrite(file, data, MAT_COMPRESSION_NONE);
    Mat_VarFree(data);
    Mat_Close(file);
    return read_recordings_mat(path);
  }

 private:
  std::vector<const char*> fields_;
  std::vector<matvar_t*> values_;
};

TEST_F(MatRecording, TakesTheUnitsOfAList) {
  struct Case {
    const char* units;
    double step;
    std::optional<Dimension> force, acc;
    double first;  ///< of acc1
  };
  const std::vector<Case> cases{
      {"ms, N, g, g", 1e-3, kForce, kAcceleration, 9.80665},    // for each array
      {"N, g, g", 1.0, kForce, kAcceleration, 9.80665},         // for each channel
      {"g, N", 1.0, kForce, kAcceleration, 9.80665},            // by what the names tell
      {"s, g, N, V, Pa", 1.0, kForce, kAcceleration, 9.80665},  // the same
      {"ms, N, g", 1e-3, kForce, kAcceleration, 9.80665},  // as many as channels, yet with a time
      {"N, kN", 1.0, std::nullopt, std::nullopt, 1.0},     // which?
      {"ms, g", 1.0, std::nullopt, std::nullopt, 1.0},     // not for a force
      {"g", 1.0, std::nullopt, std::nullopt, 1.0},         // likewise
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.units);
    StructFile file;
    file.add("time", {0.0, 1.0, 2.0});
    file.add("force", {1.0, 2.0, 3.0});
    file.add("acc1", {1.0, 2.0, 3.0});
    file.add("acc2", {1.0, 2.0, 3.0});
    file.add("units", c.units);
    const Recordings read = file.read(path_);
    ASSERT_EQ(read.recordings.size(), 1U);
    const Recording& recording = read.recordings[0];
    EXPECT_DOUBLE_EQ(recording.axis.step, c.step);
    EXPECT_EQ(recording.channel("force").dimension, c.force);
    EXPECT_EQ(recording.channel("acc2").dimension, c.acc);
    EXPECT_EQ(recording.channel("acc1").values[0], c.first);
    ASSERT_EQ(read.warnings.size(), c.acc ? 0U : 1U);
    for (const Warning& warning : read.warnings) EXPECT_EQ(warning.code, "units_not_assigned");
  }
}

TEST_F(MatRecording, TakesTheUnitsOfAListWhateverTheNumberOfChannels) {
  const std::vector<const char*> names{"acc1", "acc2", "acc3", "acc4"};
  for (std::size_t channels = 1; channels <= names.size(); ++channels) {
    for (const char* units : {"ms, g", "ms; g", "g"}) {
      SCOPED_TRACE(std::string(units) + " for " + std::to_string(channels));
      StructFile file;
      file.add("units", units);
      file.add("time", {0.0, 1.0, 2.0});
      for (std::size_t i = 0; i < channels; ++i) file.add(names[i], {1.0, 2.0, 3.0});
      const Recordings read = file.read(path_);
      const Recording& recording = read.recordings.at(0);
      EXPECT_TRUE(read.warnings.empty());
      EXPECT_DOUBLE_EQ(recording.axis.step, *units == 'm' ? 1e-3 : 1.0);
      for (const Channel& channel : recording.channels) {
        EXPECT_EQ(channel.dimension, kAcceleration) << channel.name;
        EXPECT_EQ(channel.values[0], 9.80665) << channel.name;
      }
    }
  }
}

TEST_F(MatRecording, NamesTheFileOfABadValueOnce) {
  StructFile file;
  file.add("time", {0.0, 1.0, 2.0});
  file.add("acc1", {1.0, std::nan(""), 3.0});
  file.add("units", "s, m/s^2");
  EXPECT_EQ(
      message_of<InputError>([&] { return file.read(path_); }),
      path_ + ": channel 'acc1', point 2 = nan; must be finite. Cut the record where it is whole.");
}

TEST_F(MatRecording, TakesTheUnitBesideAnArray) {
  StructFile file;
  file.add("time", {0.0, 1.0, 2.0});
  file.add("force", {1.0, 2.0, 3.0});
  file.add("force_unit", "kN");
  file.add("acc1", {1.0, 2.0, 3.0});
  file.add("units", "m/s^2");
  const Recording recording = file.read(path_).recordings.at(0);
  EXPECT_EQ(recording.channel("force").values[0], 1000.0);
  EXPECT_EQ(recording.channel("acc1").dimension, kAcceleration);
}

// 200 bytes that say they hold 2⁴⁰ structs, none of which has a field.
TEST_F(MatRecording, RefusesMoreStructsThanAFileCanHold) {
  const auto number = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const auto tag = [&](std::uint32_t type, std::uint32_t bytes) {
    return number(type) + number(bytes);
  };
  const std::string content =
      tag(mat5::kUint32, 8) + number(mat5::kStructClass) + number(0) +      // flags
      tag(mat5::kInt32, 8) + number(1U << 20U) + number(1U << 20U) +        // sizes
      tag(mat5::kInt8, 1) + std::string("s\0\0\0\0\0\0\0", 8) +             // name
      number(mat5::kInt32 | 4U << 16U) + number(32) + tag(mat5::kInt8, 0);  // fields
  std::string header(124, ' ');
  header.replace(0, 10, "MATLAB 5.0");
  const std::string file = header + std::string("\0\1IM", 4) +
                           tag(mat5::kMatrix, static_cast<std::uint32_t>(content.size())) + content;
  test::put(path_, file);
  EXPECT_NE(message_of<FormatError>([&] {
              return read_recordings_mat(path_);
            }).find("expected at most 1000000 arrays"),
            std::string::npos);
}

// Byte for byte as [MathWorks, MAT-File Format] has it: the length of the names of fields is a
// small element, which matio and Octave rely on.
TEST_F(MatRecording, WritesTheLengthOfNamesInItsTag) {
  write_recordings_mat(path_, std::vector{test::time_recording()});
  const std::string file = test::get(path_);
  const std::string length("\x05\0\x04\0\x20\0\0\0\x01\0\0\0", 12);
  EXPECT_NE(file.find(length), std::string::npos);
  EXPECT_EQ(file.find(std::string("\x05\0\0\0\x04\0\0\0", 8)), std::string::npos);
}

TEST_F(MatRecording, ReadsTheHammerBlowWithItsUnits) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const Recordings read =
      read_recordings_mat(std::string(folder) + "/brake_reuss_beam/HammerImpact.mat");
  ASSERT_EQ(read.recordings.size(), 1U);
  ASSERT_EQ(read.recordings[0].channels.size(), 3U);
  for (const Channel& channel : read.recordings[0].channels) {
    EXPECT_EQ(channel.dimension, kAcceleration) << channel.name;
  }
  EXPECT_TRUE(read.warnings.empty());
}

TEST_F(MatRecording, RefusesTextsThatAreNotUtf8) {
  Recording recording = test::time_recording();
  recording.channels[0].name = "gr\xF6\xDF";
  EXPECT_NE(message_of<InputError>([&] {
              write_recordings_mat(path_, std::vector{recording});
            }).find("must be UTF-8"),
            std::string::npos);
}

TEST_F(MatRecording, ReportsADiskThatIsFull) {
  EXPECT_NE(message_of<FileError>([] {
              write_recordings_mat("/dev/full", std::vector{test::time_recording()});
            }).find("/dev/full"),
            std::string::npos);
}

// What no checksum guards, numbers above all, may be read changed, but keeps the rules.
TEST_F(MatRecording, ReadsOrRefusesDamagedFiles) {
  write_recordings_mat(path_, std::vector{test::time_recording(), test::frequency_recording()});
  const auto read = [&] {
    for (const Recording& r : read_recordings_mat(path_).recordings) check_recording(r);
  };
  test::read_cut(path_, 5, read);
  test::read_changed(path_, 6, read);
}

/// A rate, a column and a struct with a text, as MATLAB writes them with -v7.3.
void write_73_by_matio(const std::string& path) {
  const MatioFile file(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT73), Mat_Close);
  const auto write = [&](matvar_t* variable) {
    Mat_VarWrite(file.get(), variable, MAT_COMPRESSION_ZLIB);
    Mat_VarFree(variable);
  };
  write(column_by_matio("fs", {512.0}));
  write(column_by_matio("force", std::vector<double>(300, 1.5)));
  std::array<std::size_t, 2> one{1, 1};
  std::array<const char*, 3> names{"fs", "acc1", "unit"};
  matvar_t* nested = Mat_VarCreateStruct("nested", 2, one.data(), names.data(), 3);
  Mat_VarSetStructFieldByName(nested, "fs", 0, column_by_matio(nullptr, {256.0}));
  Mat_VarSetStructFieldByName(nested, "acc1", 0, column_by_matio(nullptr, {1.0, 2.0, -4.0}));
  std::array<std::size_t, 2> five{1, 5};
  std::array<std::uint16_t, 5> text{'m', '/', 's', '^', '2'};
  Mat_VarSetStructFieldByName(
      nested, "unit", 0,
      Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT16, 2, five.data(), text.data(), 0));
  write(nested);
}

TEST_F(MatRecording, ReadsVersion73) {
  write_73_by_matio(path_);
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].sampling_rate(), 512.0);
  EXPECT_EQ(read.recordings[0].channel("force").values, std::vector<double>(300, 1.5));
  EXPECT_EQ(read.recordings[1].sampling_rate(), 256.0);
  EXPECT_EQ(read.recordings[1].channel("acc1").values, (std::vector{1.0, 2.0, -4.0}));
  EXPECT_EQ(read.recordings[1].channel("acc1").dimension, kAcceleration);
}

// Version 7.3 is HDF5 without checksums, and changed bytes can crash the HDF5 library itself.
TEST_F(MatRecording, ReadsOrRefusesDamagedFilesOfVersion73) {
  write_73_by_matio(path_);
  const auto read = [&] {
    for (const Recording& r : read_recordings_mat(path_).recordings) check_recording(r);
  };
  test::read_cut(path_, 7, read, test::damaged_files(1000));
  test::read_changed(path_, 8, read, test::damaged_files(500));
}

TEST_F(MatRecording, TakesTheWholeVariablesOfACutFile) {
  write_recordings_mat(path_, test::twelve_recordings());
  const std::string whole = test::get(path_);
  test::put(path_, whole.substr(0, whole.size() - 9));
  EXPECT_NE(message_of<FormatError>([&] {
              return read_recordings_mat(path_);
            }).find("found the end of the file"),
            std::string::npos);
  const Recordings read = read_recordings_mat(path_, {}, {.allow_truncated = true});
  EXPECT_EQ(read.recordings.size(), 11U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "file_truncated");
}

// Chen et al., Jin et al., MSSP 166 (2022) 108401, 108402; the figures are those that SciPy 1.10.1
// reads from the authors' file.
TEST_F(MatRecording, ReadsTheBrakeReussBeam) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const std::string path = std::string(folder) + "/brake_reuss_beam/ForcedFrequencyResponses.mat";
  EXPECT_EQ(read_recordings_mat(path).recordings.size(), 12U);
  const Recordings read = read_recordings_mat(path, "FRdata.ResponseControl");
  ASSERT_EQ(read.recordings.size(), 8U);
  const Recording& first = read.recordings[0];
  EXPECT_EQ(first.source, "ForcedFrequencyResponses.mat:FRdata.ResponseControl(1)");
  EXPECT_EQ(first.axis.dimension, kFrequency);
  EXPECT_EQ(first.axis.start, 79.0);
  EXPECT_NEAR(first.axis.step, 0.05, 1e-12);  // 2 Hz in 40 steps, rounded
  EXPECT_EQ(first.size(), 41U);
  EXPECT_EQ(first.channel("force").dimension, kForce);
  EXPECT_EQ(first.channel("phase").dimension, kAngle);
  EXPECT_NEAR(first.channel("force").values[0], 0.36465208, 5e-9);  // digits printed
  EXPECT_NEAR(first.channel("amplitude").values[40], 4.98435053, 5e-9);
}

}  // namespace
}  // namespace microslip::mat_recording_test
