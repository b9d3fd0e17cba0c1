// SPDX-License-Identifier: MIT

// MAT files as other programs and data loggers write them: single precision, lengths that are not
// exact, objects of classes, no time.

#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::mat_other_test {
namespace {

using test::message_of;

/// Written by libmatio, as Scilab does too.
class OtherMat {
 public:
  explicit OtherMat(const std::string& path, matio_compression compression = MAT_COMPRESSION_NONE)
      : file_(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5)), compression_(compression) {}
  OtherMat(const OtherMat&) = delete;
  OtherMat& operator=(const OtherMat&) = delete;
  ~OtherMat() { Mat_Close(file_); }

  void add(const char* name, std::vector<double> values, std::size_t rows) {
    put(name, MAT_C_DOUBLE, MAT_T_DOUBLE, rows, values.size() / rows, values.data());
  }
  void add_int64(const char* name, std::vector<std::int64_t> values) {
    put(name, MAT_C_INT64, MAT_T_INT64, values.size(), 1, values.data());
  }
  void add_single(const char* name, std::vector<float> values) {
    put(name, MAT_C_SINGLE, MAT_T_SINGLE, values.size(), 1, values.data());
  }
  /// A struct of one element, of column vectors.
  void add_struct(const char* name,
                  std::vector<std::pair<const char*, std::vector<double>>> fields) {
    std::vector<const char*> names;
    for (const auto& field : fields) names.push_back(field.first);
    std::array<std::size_t, 2> one{1, 1};
    matvar_t* variable =
        Mat_VarCreateStruct(name, 2, one.data(), names.data(), static_cast<unsigned>(names.size()));
    for (auto& [field, values] : fields) {
      std::array<std::size_t, 2> sizes{values.size(), 1};
      Mat_VarSetStructFieldByName(
          variable, field, 0,
          Mat_VarCreate(field, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), values.data(), 0));
    }
    Mat_VarWrite(file_, variable, compression_);
    Mat_VarFree(variable);
  }
  using Cell = std::variant<double, std::vector<double>, std::string>;
  /// An array of structs of a cell for each field.
  void add_rows(const char* name, std::vector<const char*> fields,
                std::vector<std::vector<Cell>> rows) {
    std::array<std::size_t, 2> sizes{rows.size(), 1};
    matvar_t* variable = Mat_VarCreateStruct(name, 2, sizes.data(), fields.data(),
                                             static_cast<unsigned>(fields.size()));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t i = 0; i < fields.size(); ++i) {
        Mat_VarSetStructFieldByName(variable, fields[i], row, variable_of(fields[i], rows[row][i]));
      }
    }
    Mat_VarWrite(file_, variable, compression_);
    Mat_VarFree(variable);
  }
  void add(const char* name, std::string text) {
    put(name, MAT_C_CHAR, MAT_T_UINT8, 1, text.size(), text.data());
  }

 private:
  static matvar_t* variable_of(const char* name, Cell& cell) {
    std::array<std::size_t, 2> sizes{1, 1};
    if (std::string* const text = std::get_if<std::string>(&cell)) {
      sizes[1] = text->size();
      return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, sizes.data(), text->data(), 0);
    }
    if (double* const number = std::get_if<double>(&cell)) {
      return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), number, 0);
    }
    std::vector<double>& numbers = std::get<std::vector<double>>(cell);
    sizes = {numbers.empty() ? 0U : 1U, numbers.size()};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), numbers.data(), 0);
  }

  void put(const char* name, matio_classes kind, matio_types type, std::size_t rows,
           std::size_t columns, void* data) {
    std::array<std::size_t, 2> sizes{rows, columns};
    matvar_t* variable = Mat_VarCreate(name, kind, type, 2, sizes.data(), data, 0);
    Mat_VarWrite(file_, variable, compression_);
    Mat_VarFree(variable);
  }

  mat_t* file_;
  matio_compression compression_;
};

class MatOther : public testing::Test {
 protected:
  std::string message() {
    return message_of<Error>([&] { return read_recordings_mat(path_); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.mat");
};

// The times are what was measured; the rate may be of another file.
TEST_F(MatOther, WarnsOfARateThatItsTimesContradict) {
  for (const double rate : {100.0, 99.5, 50.0}) {
    {
      OtherMat file(path_);
      file.add("time", {0.0, 0.01, 0.02, 0.03}, 4);
      file.add("fs", {rate}, 1);
      file.add("acc", {1.0, 2.0, 3.0, 4.0}, 4);
    }
    const Recordings read = read_recordings_mat(path_);
    if (rate == 50.0) {
      EXPECT_NEAR(read.recordings.at(0).axis.step, 0.01, 1e-15);
      ASSERT_EQ(read.warnings.size(), 1U);
      EXPECT_EQ(read.warnings[0].code, "rate_contradicts");
      EXPECT_NE(read.warnings[0].text.find("100 Hz, and the file states 50 Hz"), std::string::npos)
          << read.warnings[0].text;
    } else {
      EXPECT_TRUE(read.warnings.empty()) << rate;
    }
  }
}

// Each time is off by half a unit in the last place of a float, up to 2.4e-7 s beyond 4 s: even
// steps of 1 ms explain them.
TEST_F(MatOther, TakesTimesInSinglePrecision) {
  std::vector<float> times;
  for (int i = 0; i < 5000; ++i) times.push_back(static_cast<float>(i) * 1e-3F);
  {
    OtherMat file(path_);
    file.add_single("time", times);
    file.add_single("acc", times);
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_TRUE(read.recordings[0].axis.even());
  EXPECT_EQ(read.recordings[0].sampling_rate(), 1000.0);
}

TEST_F(MatOther, LetsTheTimeTellChannelsFromSamples) {
  {
    OtherMat file(path_);
    file.add("time", {0, 0.5}, 2);
    file.add("acc", {1, 10, 2, 20, 3, 30}, 2);
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.at(0).channels.size(), 3U);
  EXPECT_EQ(read.recordings[0].channel("acc_3").values, (std::vector{3.0, 30.0}));
}

TEST_F(MatOther, TellsTimesOfAnotherLength) {
  {
    OtherMat file(path_);
    file.add("time", {0, 0.5}, 2);
    file.add("acc", {1, 2, 3}, 3);
  }
  EXPECT_NE(message().find("'acc': expected a sampling rate, found 'time' of 2 values for its 3"),
            std::string::npos)
      << message();
}

TEST_F(MatOther, LeavesOutChannelsThatAreNotWhole) {
  {
    OtherMat file(path_);
    file.add("fs", {100.0}, 1);
    file.add("force", {1, 2, 3}, 3);
    file.add("gap", {1, std::nan(""), 3}, 3);
  }
  const Recordings read = read_recordings_mat(path_);
  EXPECT_EQ(read.recordings.at(0).channels.size(), 1U);
  EXPECT_EQ(read.warnings.at(0).text,
            path_ +
                ": channel 'gap' is left out: 1 of its 3 values are missing or not finite, the "
                "first at point 2");
}

TEST_F(MatOther, NumbersPointsWhereThatIsAllowed) {
  {
    OtherMat file(path_);
    file.add("U", {1, 2, 4}, 3);
    file.add("F", {1, 2, 3}, 3);
  }
  EXPECT_NE(message().find("expected a sampling rate, found none"), std::string::npos);
  const Recordings read = read_recordings_mat(path_, {}, {.allow_untimed = true});
  EXPECT_EQ(read.recordings.at(0).axis.step, 1.0);
  EXPECT_EQ(read.recordings.at(0).channels.size(), 2U);
  EXPECT_EQ(read.warnings.at(0).code, "points_untimed");
}

// Of a file that has times for some of its structs.
TEST_F(MatOther, TakesAStatedRateForWhatNothingPlaces) {
  {
    OtherMat file(path_);
    file.add_struct("timed", {{"fs", {100.0}}, {"force", {1, 2, 3}}});
    file.add_struct("untimed", {{"acc", {1, 2, 4, 8}}});
    file.add_struct("other", {{"time", {0, 1}}, {"gap", {1, 2, 4}}});
  }
  const Recordings read = read_recordings(path_, {.rate = 512.0});
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].axis.step, 0.01);
  EXPECT_EQ(read.recordings[1].axis.step, 1.0 / 512.0);
  EXPECT_EQ(read.recordings[1].channel("acc").values.size(), 4U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_NE(read.warnings[0].text.find("'time' of 2 values for its 3"), std::string::npos);
}

TEST_F(MatOther, LeavesOutAStructWithoutAnyWholeChannel) {
  const double nan = std::nan("");
  {
    OtherMat file(path_);
    file.add("fs", {100.0}, 1);
    file.add("force", {1, 2, 3}, 3);
    file.add("spare", {nan, nan, nan, nan}, 4);
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].channels.size(), 1U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "recording_left_out");
  EXPECT_EQ(
      read.warnings[0].text,
      path_ +
          ": the recording 'a.mat #2' of 'spare' is left out: each of its channels has values "
          "that are missing or not finite. Cut it where it is whole");
  {
    OtherMat file(path_);
    file.add("fs", {100.0}, 1);
    file.add("spare", {nan, nan, nan, nan}, 4);
  }
  EXPECT_NE(message().find("channel 'spare', point 1 = nan; must be finite"), std::string::npos);
}

// SciPy 1.10 writes a record array as an array of structs.
TEST_F(MatOther, TakesATableThatIsStoredRowByRow) {
  {
    OtherMat file(path_);
    file.add_rows("data", {"time", "force"}, {{0.0, 1.0}, {0.5, 3.0}, {1.0, -2.0}});
    file.add_rows("modes", {"frequency", "damping"}, {{10.0, 0.1}, {20.0, 0.2}});
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U) << "modes are no recording";
  EXPECT_EQ(read.recordings[0].axis.step, 0.5);
  EXPECT_EQ(read.recordings[0].channel("force").values, (std::vector{1.0, 3.0, -2.0}));
}

TEST_F(MatOther, LeavesOutTextOfATableOfRows) {
  {
    OtherMat file(path_);
    file.add_rows("data", {"time", "note", "force"},
                  {{0.0, "start", 1.0}, {0.5, "ok", 3.0}, {1.0, 7.0, -2.0}});
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  ASSERT_EQ(read.recordings[0].channels.size(), 1U);
  EXPECT_EQ(read.recordings[0].channel("force").values, (std::vector{1.0, 3.0, -2.0}));
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "channel_left_out");
  EXPECT_EQ(read.warnings[0].text,
            path_ + ":data: 'note': left out, its values are no real numbers");
}

// Events beside a measurement, which is no list of recordings for it.
TEST_F(MatOther, ReadsNoTableOfRowsBesideARecording) {
  const auto put_events = [&](bool has_time) {
    OtherMat file(path_);
    file.add_rows("events", {"time", "gain"}, {{0.0, 1.0}, {1.0, 2.0}, {2.0, 3.0}});
    file.add("force", {1.0, -2.0, 0.5, 4.0}, 4);
    if (has_time) file.add("time", {0.0, 0.5, 1.0, 1.5}, 4);
  };
  put_events(true);
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].channels.size(), 1U);
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read_recordings_mat(path_, "events").recordings.at(0).channels.at(0).name, "gain");
  put_events(false);
  EXPECT_NE(message().find("'force': expected a sampling rate"), std::string::npos) << message();
}

TEST_F(MatOther, NamesTheCellThatKeepsRowsFromBeingATable) {
  using Row = std::vector<OtherMat::Cell>;
  const auto found = [&](std::vector<const char*> fields, std::vector<Row> rows) {
    {
      OtherMat file(path_);
      file.add("fs", {1000.0}, 1);
      file.add_rows("data", std::move(fields), std::move(rows));
    }
    std::string text = message();
    text.erase(0, text.find("found "));
    return text.substr(0, text.find(". "));
  };
  const std::vector<double> two{1.0, 2.0};
  const std::vector<double> none;
  EXPECT_EQ(found({"time", "acc"}, {{0.0, two}, {0.1, two}, {0.2, two}}),
            "found real numbers of 1 × 2 in 'acc' of row 1");
  EXPECT_EQ(found({"time", "acc"}, {{0.0, 1.0}, {0.1, none}, {0.2, 1.0}}),
            "found no number in 'acc' of row 2");
  EXPECT_EQ(found({"time", "acc"}, {{0.0, 1.0}, {0.1, 1.0}, {0.1, 1.0}}),
            "found 0.1 in 'time' of row 3 after 0.1");
  EXPECT_EQ(found({"elapsed", "acc"}, {{0.0, 1.0}, {0.1, 1.0}}),
            "found the fields 'elapsed', 'acc'");
}

// When each began, and more values than there are recordings.
TEST_F(MatOther, ReadsRecordingsThatSayWhenTheyBegan) {
  const std::vector<double> three{1.0, 2.0, 4.0};
  {
    OtherMat file(path_);
    file.add("fs", {4.0}, 1);
    file.add_rows("runs", {"time", "force"}, {{0.0, three}, {60.0, three}});
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[1].axis.step, 0.25);
  EXPECT_EQ(read.recordings[1].channel("force").values, three);
}

TEST_F(MatOther, LeavesOutAStructWhoseTimesAreNotWhole) {
  const double nan = std::nan("");
  const auto put_struct = [&](bool beside_others) {
    OtherMat file(path_);
    if (beside_others) file.add_struct("good", {{"time", {0, 1, 2}}, {"force", {1, 2, 3}}});
    file.add_struct("bad", {{"time", {0, nan, 2, 3}}, {"acc", {1, 2, 3, 4}}});
  };
  put_struct(true);
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].channel("force").values.size(), 3U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "recording_left_out");
  EXPECT_EQ(read.warnings[0].text,
            path_ +
                ": the recording 'a.mat:bad' of 'acc' is left out: channel 'axis', point 2 = "
                "nan; must be finite. Cut the record where it is whole.");
  put_struct(false);
  EXPECT_NE(message().find("channel 'axis', point 2 = nan"), std::string::npos) << message();
}

// libmatio 1.5.23 counts two bytes for each letter of a compressed text and writes one: its
// variable claims more than the compressed data hold. Scilab writes so by default.
TEST_F(MatOther, ReadsTextsOfScilab) {
  {
    OtherMat file(path_, MAT_COMPRESSION_ZLIB);
    file.add("fs", {100.0}, 1);
    file.add("units", std::string("m/s^2"));
    file.add("acc", {1, 2, 3}, 3);
  }
  const Recordings read = read_recordings_mat(path_);
  EXPECT_EQ(read.recordings.at(0).channel("acc").dimension, kAcceleration);
  EXPECT_EQ(read_mat_text(path_, "units"), "m/s^2");
  EXPECT_EQ(read_mat_numbers(path_, "acc").size(), 3U) << "behind a variable that is not read";
}

// libsndfile 1.2.0 counts the tag of its last variable twice.
TEST_F(MatOther, ReadsALastVariableThatClaimsATagMore) {
  {
    OtherMat file(path_);
    file.add("fs", {100.0}, 1);
    file.add("acc", {1, 2, 3}, 3);
  }
  std::string content = test::get(path_);
  const std::size_t size = content.find("acc") - 40;  // the size in the tag of its variable
  content[size] = static_cast<char>(content[size] + 8);
  test::put(path_, content);
  EXPECT_EQ(read_recordings_mat(path_).recordings.at(0).channel("acc").values,
            (std::vector{1.0, 2.0, 3.0}));
  test::put(path_, content.substr(0, content.size() - 8));
  EXPECT_NE(message().find("found the end of the file"), std::string::npos) << message();
}

// As libsndfile, the acquisition of MATLAB and test systems call it.
TEST_F(MatOther, KnowsOtherNamesOfTheRate) {
  for (const char* name :
       {"samplerate", "SampleRate", "Sample_rate", "ActualRate", "Time_Sample_Rate"}) {
    {
      OtherMat file(path_);
      file.add(name, {48000.0}, 1);
      file.add("wavedata", {1, 2, 3, 4, 5, 6}, 2);
    }
    const Recordings read = read_recordings_mat(path_);
    ASSERT_EQ(read.recordings.size(), 1U) << name;
    EXPECT_EQ(read.recordings[0].sampling_rate(), 48000.0) << name;
    EXPECT_EQ(read.recordings[0].channels.size(), 2U) << name;
  }
}

std::string number_of_4(std::uint32_t value) {
  std::string bytes(4, '\0');
  for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string element(std::uint32_t type, const std::string& content) {
  const std::size_t padding = (8 - content.size() % 8) % 8;
  return number_of_4(type) + number_of_4(static_cast<std::uint32_t>(content.size())) + content +
         std::string(padding, '\0');
}

// MATLAB's MAT-files of 2012 on: an object has its name, the system and the name of its class.
TEST_F(MatOther, NamesObjectsOfMatlab) {
  std::string header = "MATLAB 5.0 MAT-file, Platform: GLNXA64";
  header.resize(124, ' ');
  header += std::string("\0\x01IM", 4);
  const std::string flags = element(6, number_of_4(17) + number_of_4(0));
  const std::string object =
      flags + element(1, "run1") + element(1, "MCOS") + element(1, "timetable");
  test::put(path_, header + element(14, object));
  EXPECT_NE(message().find(":run1: expected vectors of numbers, found an object of the class "
                           "'timetable'. Only MATLAB reads it"),
            std::string::npos)
      << message();
}

// numpy.datetime64 as int64: doubles are 256 ns apart there, at 51.2 kHz 1.3 % of a step.
TEST_F(MatOther, KeepsTheDigitsOfTimesSince1970) {
  constexpr std::int64_t kStart = 1704067200000000123;
  for (const bool stated : {false, true}) {
    {
      OtherMat file(path_);
      file.add_int64("time", {kStart, kStart + 19531, kStart + 2 * 19531});
      file.add("force", {1.0, 2.0, 3.0}, 3);
      if (stated) file.add("time_unit", "ns");
    }
    const Recordings read = read_recordings_mat(path_);
    EXPECT_EQ(read.recordings.at(0).axis.start, 0.0);
    EXPECT_NEAR(read.recordings[0].axis.step, 19531e-9, 1e-12 * 19531e-9) << "but for rounding";
    EXPECT_EQ(read.warnings.size(), stated ? 0U : 1U);
  }
}

TEST_F(MatOther, SaysThatAFrequencyIsTheAxisBesideARate) {
  {
    OtherMat file(path_);
    file.add("frequency", {1.0, 2.0, 3.0}, 3);
    file.add("fs", {1000.0}, 1);
    file.add("H", {1.0, 2.0, 3.0}, 3);
  }
  const Recordings read = read_recordings_mat(path_);
  EXPECT_EQ(read.recordings.at(0).axis.dimension, kFrequency);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "axis_chosen");
}

// Simcenter Testlab states the axis of each function and its unit in structs of their own.
TEST_F(MatOther, TakesFunctionsOfTestlab) {
  const Recordings read =
      read_recordings_mat(std::string(MICROSLIP_TEST_DATA) + "/mat/testlab.mat");
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings.front();
  EXPECT_DOUBLE_EQ(recording.axis.step, 0.01);
  EXPECT_DOUBLE_EQ(recording.axis.start, 2.0);
  EXPECT_EQ(recording.channel("Force").values, (std::vector<double>{1e3, 2e3, 3e3, 4e3}));
  EXPECT_DOUBLE_EQ(recording.channel("Tip").values.back(), 9.80665);
}

// The increment of a load, or of anything else.
TEST_F(MatOther, TakesNoIncrementForAStep) {
  {
    OtherMat file(path_);
    file.add("increment", {0.5}, 1);
    file.add("start_value", {2.0}, 1);
    file.add("force", {1.0, 2.0, 3.0}, 3);
  }
  EXPECT_NE(message().find("expected a sampling rate"), std::string::npos) << message();
}

// A sweep up and down has frequencies that are no axis; the rate is.
TEST_F(MatOther, TakesTheRateBesideAFrequencyThatFalls) {
  {
    OtherMat file(path_);
    file.add("frequency", {1.0, 3.0, 2.0}, 3);
    file.add("fs", {1000.0}, 1);
    file.add("H", {1.0, 2.0, 3.0}, 3);
  }
  const Recordings read = read_recordings_mat(path_);
  EXPECT_EQ(read.recordings.at(0).sampling_rate(), 1000.0);
  EXPECT_EQ(read.recordings.at(0).channels.size(), 2U);
}

// Whole milliseconds of a clock at 1.6 kHz, of which some are equal.
TEST_F(MatOther, TakesTimesOfAClockThatRoundsForEven) {
  constexpr std::size_t kCount = 400;
  {
    OtherMat file(path_);
    std::vector<std::int64_t> times;
    std::vector<double> force;
    for (std::size_t i = 0; i < kCount; ++i) {
      times.push_back(std::llround(static_cast<double>(i) * 0.625));
      force.push_back(static_cast<double>(i % 7));
    }
    file.add_int64("time", times);
    file.add("time_unit", "ms");
    file.add("force", force, kCount);
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_TRUE(read.recordings.at(0).axis.even());
  // The line through times that are uniformly wrong by 1 ms/√12: of its slope √12/(√n n) of that.
  EXPECT_NEAR(read.recordings.at(0).axis.step, 0.625e-3, 1e-3 / (20.0 * kCount));
  EXPECT_EQ(read.warnings.at(0).code, "times_rounded");
  const Recordings at_rate = read_recordings_mat(path_, {}, {.rate = 1600.0});
  EXPECT_EQ(at_rate.recordings.at(0).axis.step, 1.0 / 1600.0);
  EXPECT_TRUE(at_rate.rate_used);
  EXPECT_TRUE(at_rate.warnings.empty());
}

// A capture of dSPACE: run.X is the time, run.Y(i) a channel, each with Name, Data and Unit.
TEST_F(MatOther, TakesStructsInCapitalsForChannels) {
  {
    OtherMat file(path_);
    using Cell = OtherMat::Cell;
    const auto data = [](std::vector<double> values) { return Cell(std::move(values)); };
    file.add_rows("X", {"Name", "Data", "Unit"},
                  {{std::string("Time"), data({0.0, 0.5, 1.0}), std::string("s")}});
    file.add_rows("Y", {"Name", "Data", "Unit"},
                  {{std::string("force"), data({1.0, 2.0, 3.0}), std::string("kN")},
                   {std::string("gap"), data({4.0, 5.0, 6.0}), std::string("mm")}});
  }
  const Recordings read = read_recordings_mat(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].axis.step, 0.5);
  EXPECT_EQ(read.recordings[0].channel("force").values, (std::vector{1e3, 2e3, 3e3}));
  EXPECT_EQ(read.recordings[0].channel("gap").dimension, kLength);
}

}  // namespace
}  // namespace microslip::mat_other_test
