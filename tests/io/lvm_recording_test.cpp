// SPDX-License-Identifier: MIT

// LVM files by their description [NI, "Specification for the LabVIEW Measurement File"]: an entry
// of a header belongs to the channel that it stands at, x are printed with six decimals, headers
// end with a tab, values that are missing are blank.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::lvm_recording_test {
namespace {

using test::message_of;
using Lines = std::vector<std::string>;
using Values = std::vector<double>;

/// Lines as LabVIEW ends them.
std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\r\n";
  return text;
}

std::string file_header(const std::string& x_columns, const std::string& others = "") {
  return "LabVIEW "
         "Measurement\t\r\nWriter_Version\t2\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\n" +
         others + "X_Columns\t" + x_columns + "\r\n***End_of_Header***\t\r\n\t\r\n";
}

const std::string kSection = "***End_of_Header***\t\t\r\n";
const std::string kTwo = "X_Value\tForce\tAcc\tComment\r\n";
const std::string kUnits = "Channels\t2\t\t\r\nY_Unit_Label\tN\tg\t\r\n";
const std::string kSteps = "Delta_X\t0.001000\t0.001000\t\r\n";

class LvmFiles : public testing::Test {
 protected:
  Recordings read(const std::string& text) {
    test::put(path_, text);
    return read_recordings(path_, {});
  }
  Recording only(const std::string& text) {
    const Recordings read = this->read(text);
    EXPECT_EQ(read.recordings.size(), 1U);
    return read.recordings.at(0);
  }
  static bool has_warning(const Recordings& read, const std::string& code) {
    for (const Warning& warning : read.warnings) {
      if (warning.code == code) return true;
    }
    return false;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.lvm");
};

const Lines kRows{"0.000000\t1\t5", "0.001000\t2\t6", "0.002000\t3\t7", "0.003000\t4\t8"};

// A section of one value a second keeps its times; the other has none.
TEST_F(LvmFiles, TakeAStatedRateWhereTheyHaveNone) {
  test::put(path_, file_header("No") + "Channels\t2\t\r\nDelta_X\t1.000000\t\t\r\n" + kSection +
                       kTwo + "\t1\t5\r\n\t2\t6\r\n\t3\t7\r\n");
  const Recordings read = read_recordings(path_, {.rate = 1000.0});
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].axis.step, 1.0);
  EXPECT_EQ(read.recordings[1].axis.step, 1e-3);
  EXPECT_TRUE(read.warnings.empty());
}

TEST_F(LvmFiles, GiveAnEntryOfAHeaderToItsChannelAlone) {
  const Recording recording =
      only(file_header("One") + "Channels\t2\r\nY_Unit_Label\tN\r\nDelta_X\t0.001000\r\n" +
           kSection + kTwo + text_of(kRows));
  EXPECT_EQ(recording.channel("Force").dimension, kForce);
  EXPECT_FALSE(recording.channel("Acc").dimension);
  EXPECT_EQ(recording.axis.step, 1e-3);
}

// Entries stand above the values, so that every second cell is blank.
TEST_F(LvmFiles, HaveEntriesAboveTheirColumns) {
  for (const std::string units : {"N\t\tg", "N\tg"}) {
    const bool wide = units.size() > 3;
    const std::string gap = wide ? "\t\t" : "\t";
    const Recording recording =
        only(file_header("Multi") + "Samples\t2" + gap + "2\r\nY_Unit_Label\t" + units +
             "\r\nDelta_X\t" + "0.001000" + gap + "0.001000\r\n" + kSection +
             "X_Value\tForce\tX_Value\tAcc\tComment\r\n" +
             text_of({"0.000000\t1\t0.000000\t5", "0.001000\t2\t0.001000\t6"}));
    EXPECT_EQ(recording.channel("Force").dimension, kForce);
    EXPECT_EQ(recording.channel("Acc").dimension, kAcceleration);
    EXPECT_DOUBLE_EQ(recording.channel("Acc").values[1], 6 * 9.80665);
  }
}

// 2048 Hz: six decimals are off by 1e-3 of a step; 51.2 kHz: by 0.03 of one.
TEST_F(LvmFiles, TakeTheStepThatExplainsPrintedTimes) {
  for (const double rate : {2048.0, 51200.0}) {
    for (const double start : {0.0, 3850000000.0}) {
      if (start > 0.0 && rate > 2048.0) continue;  // beyond what doubles of such times resolve
      std::string rows;
      for (int i = 0; i < 64; ++i) {
        rows += fmt::format("{:.6f}\t{:.6f}\r\n", start + i / rate, std::sin(0.3 * i));
      }
      const Recording recording =
          only(file_header("One") + fmt::format("Channels\t1\r\nDelta_X\t{:.16E}\r\n", 1 / rate) +
               kSection + "X_Value\tForce\r\n" + rows);
      ASSERT_TRUE(recording.axis.even());
      EXPECT_EQ(recording.axis.step, 1 / rate);
      EXPECT_EQ(recording.axis.start, start);
    }
  }
}

TEST_F(LvmFiles, TellOfAStepThatTheirTimesContradict) {
  const Recordings read =
      this->read(file_header("One") + kUnits + "Delta_X\t0.001000\t0.002000\t\r\n" + kSection +
                 kTwo + text_of(kRows));
  EXPECT_EQ(read.recordings.at(0).axis.step, 1e-3);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "rate_contradicts");
  EXPECT_NE(read.warnings[0].text.find("'Acc'"), std::string::npos);
}

TEST_F(LvmFiles, TellOfUnevenTimesBesideAStep) {
  const Recordings read =
      this->read(file_header("One") + kUnits + kSteps + kSection + kTwo +
                 text_of({kRows[0], kRows[1], "0.004000\t3\t7", "0.005000\t4\t8"}));
  EXPECT_EQ(read.recordings.at(0).axis.values, (Values{0, 1e-3, 4e-3, 5e-3}));
  EXPECT_TRUE(has_warning(read, "rate_contradicts"));
}

// 10:00:00 and 4 ms later; read by a clock with 20 µs of error.
TEST_F(LvmFiles, BeginWhenTheirTimesSay) {
  const std::string at = "Date\t2026/11/29\t2026/11/29\t\r\nTime\t10:00:00.0000\t";
  const std::string rest = "\t\r\n" + kSteps + kSection + kTwo + text_of(kRows);
  const Recordings apart = this->read(file_header("One") + kUnits + at + "10:00:00.00402" + rest);
  ASSERT_EQ(apart.recordings.size(), 2U);
  EXPECT_EQ(apart.recordings[0].axis.start, 0.0);
  EXPECT_DOUBLE_EQ(apart.recordings[1].axis.start, 4e-3);
  EXPECT_TRUE(has_warning(apart, "starts_differ"));
  const Recordings together =
      this->read(file_header("One") + kUnits + at + "10:00:00.00002" + rest);
  EXPECT_EQ(together.recordings.size(), 1U);
  EXPECT_TRUE(together.warnings.empty());
  const Recordings absolute = this->read(file_header("One", "Time_Pref\tAbsolute\r\n") + kUnits +
                                         at + "10:00:00.00402" + rest);
  EXPECT_EQ(absolute.recordings.size(), 1U) << "x count from one moment for all";
}

TEST_F(LvmFiles, KeepTheRowsOfAColumnWithAGap) {
  const std::string head = file_header("One") + kUnits + kSteps + kSection + kTwo;
  const Recordings gap =
      this->read(head + text_of({kRows[0], "0.001000\t\t6", kRows[2], kRows[3]}));
  EXPECT_TRUE(has_warning(gap, "channel_left_out")) << "Force is incomplete";
  EXPECT_EQ(gap.recordings.at(0).channels.size(), 1U);
  EXPECT_DOUBLE_EQ(gap.recordings[0].channel("Acc").values.at(3), 8 * 9.80665);
  const Recordings end =
      this->read(head + text_of({kRows[0], kRows[1], kRows[2], "0.003000\t\t8"}));
  ASSERT_EQ(end.recordings.size(), 2U) << "a blank end is none";
  EXPECT_EQ(end.recordings[0].channel("Force").values, (Values{1, 2, 3}));
}

// One heading for all, in files with `Multi_Headings No`.
TEST_F(LvmFiles, HaveSectionsWithoutHeader) {
  const Recording recording =
      only(file_header("One", "Multi_Headings\tNo\r\n") + kUnits + kSteps + kSection + kTwo +
           text_of({kRows[0], kRows[1], "", kRows[2], kRows[3], ""}));
  EXPECT_EQ(recording.channel("Force").values, (Values{1, 2, 3, 4}));
}

TEST_F(LvmFiles, JoinSectionsOfAnySize) {
  for (const char* x_columns : {"One", "No"}) {
    const bool has_x = std::string(x_columns) == "One";
    const auto section = [&](std::size_t first, std::size_t end) {
      const std::string start =
          has_x ? "0.0" : fmt::format("{:.4E}", 1e-3 * static_cast<double>(first));
      std::string text =
          kUnits + "X0\t" + start + "\t" + start + "\t\r\n" + kSteps + kSection + kTwo;
      for (; first < end; ++first) {
        text += (has_x ? kRows[first] : kRows[first].substr(8)) + "\r\n";
      }
      return text + "\r\n";
    };
    const std::string head = file_header(x_columns);
    for (const std::string& text :
         {head + section(0, 2) + section(2, 4), head + section(0, 3) + section(3, 4),
          head + section(0, 1) + section(1, 2) + section(2, 3) + section(3, 4)}) {
      const Recording recording = only(text);
      EXPECT_EQ(recording.channel("Force").values, (Values{1, 2, 3, 4}));
      EXPECT_EQ(recording.axis.step, 1e-3);
    }
    const Recordings apart = this->read(head + section(0, 2) + section(3, 4));
    EXPECT_EQ(apart.recordings.at(0).size(), 2U);
    EXPECT_TRUE(has_warning(apart, "sampling_rate_missing")) << "its one value is given";
  }
}

// As of a program that writes a segment with a header of its own for each piece of a measurement:
// X0 is 0 in all of them, and Time goes on. Times are printed to microseconds.
TEST_F(LvmFiles, JoinSectionsThatGoOnByTheirTime) {
  for (const char* x_columns : {"One", "No"}) {
    const bool has_x = std::string(x_columns) == "One";
    const auto section = [&](const std::string& time, std::size_t first) {
      std::string text = "Channels\t2\t\t\r\nDate\t2026/11/29\t2026/11/29\t\r\nTime\t" + time +
                         "\t" + time + "\t\r\nX0\t0.0\t0.0\t\r\n" + kSteps + kSection + kTwo;
      for (std::size_t i = 0; i < 2; ++i) {
        text +=
            (has_x ? kRows[i].substr(0, 8) : std::string()) + kRows[first + i].substr(8) + "\r\n";
      }
      return text + "\r\n";
    };
    const std::string head = file_header(x_columns);
    const Recording recording =
        only(head + section("10:00:00.250000", 0) + section("10:00:00.252000", 2));
    EXPECT_EQ(recording.channel("Force").values, (Values{1, 2, 3, 4}));
    EXPECT_EQ(recording.axis.step, 1e-3);
    for (const char* time : {"10:00:00.250000", "10:00:00.251000", "10:00:00.253000"}) {
      EXPECT_EQ(read(head + section("10:00:00.250000", 0) + section(time, 2)).recordings.size(), 2U)
          << time;
    }
  }
}

// x go on, and the clock says that 9 s are missing, or that the section is of the day before.
TEST_F(LvmFiles, TellOfAClockThatJumps) {
  const auto section = [&](const std::string& date, const std::string& time, std::size_t first) {
    return "Channels\t2\t\t\r\n" +
           fmt::format("Date\t{0}\t{0}\t\r\nTime\t{1}\t{1}\t\r\n", date, time) + kSteps + kSection +
           kTwo + text_of({kRows[first], kRows[first + 1]}) + "\r\n";
  };
  const auto jumps = [&](const std::string& date, const std::string& time) {
    const Recordings read = this->read(
        file_header("One") + section("2026/11/29", "10:00:00.25", 0) + section(date, time, 2));
    EXPECT_EQ(read.recordings.at(0).channel("Force").values, (Values{1, 2, 3, 4}));
    return has_warning(read, "time_jumps");
  };
  EXPECT_TRUE(jumps("2026/11/29", "10:00:09.25"));
  EXPECT_TRUE(jumps("2026/11/28", "10:00:00.25"));
  EXPECT_FALSE(jumps("2026/11/29", "10:00:00.25")) << "when the measurement began";
  EXPECT_FALSE(jumps("2026/11/29", "10:00:00.252"));
  EXPECT_FALSE(jumps("2026/11/29", "10:00:00.7")) << "when the section was written";
}

// Ten sections of 2 ms; from the given one on the clock is a minute late.
TEST_F(LvmFiles, TellOfAJumpOnceWhereverItIs) {
  for (const std::size_t jump : {1, 9}) {
    std::string text = file_header("One");
    for (std::size_t i = 0; i < 10; ++i) {
      const double x = 2e-3 * static_cast<double>(i);
      text += "Channels\t2\t\t\r\n" +
              fmt::format("Date\t{0}\t{0}\t\r\nTime\t{1}\t{1}\t\r\n", "2026/11/29",
                          fmt::format("10:0{}:00.{:03}", i < jump ? 0 : 1, 2 * i)) +
              kSteps + kSection + kTwo +
              text_of({fmt::format("{:.6f}\t1\t5", x), fmt::format("{:.6f}\t2\t6", x + 1e-3)}) +
              "\r\n";
    }
    const Recordings read = this->read(text);
    EXPECT_EQ(read.recordings.at(0).size(), 20U);
    ASSERT_EQ(read.warnings.size(), 1U) << jump;
    EXPECT_EQ(read.warnings[0].code, "time_jumps");
    EXPECT_NE(read.warnings[0].text.find("begins 60.002 s after the one before"), std::string::npos)
        << read.warnings[0].text;
  }
}

// The clock is 6 s late at 60 s, when 12 sections of 5 s are joined: less than all of them took.
TEST_F(LvmFiles, TellOfAJumpShorterThanWhatIsJoined) {
  std::string text = file_header("One");
  for (int i = 0; i < 13; ++i) {
    const int second = 5 * i + (i < 12 ? 0 : 6);
    text += "Channels\t2\t\t\r\n" +
            fmt::format("Date\t{0}\t{0}\t\r\nTime\t{1}\t{1}\t\r\n", "2026/11/29",
                        fmt::format("10:0{}:{:02}", second / 60, second % 60)) +
            "Delta_X\t2.500000\t2.500000\t\r\n" + kSection + kTwo +
            text_of({fmt::format("{:.6f}\t1\t5", 5.0 * i),
                     fmt::format("{:.6f}\t2\t6", 5.0 * i + 2.5)}) +
            "\r\n";
  }
  const Recordings read = this->read(text);
  EXPECT_EQ(read.recordings.at(0).size(), 26U);
  EXPECT_TRUE(has_warning(read, "time_jumps"));
}

// Each section begins its x anew, so that Date and Time alone say that it goes on.
TEST_F(LvmFiles, TakeTimesOfSectionsThatBeginAnewForNoJump) {
  std::string text = file_header("One");
  for (int i = 0; i < 3; ++i) {
    text += "Channels\t2\t\t\r\n" +
            fmt::format("Date\t{0}\t{0}\t\r\nTime\t{1}\t{1}\t\r\n", "2026/11/29",
                        fmt::format("10:00:{:02}", 6 * i)) +
            "Delta_X\t3.000000\t3.000000\t\r\n" + kSection + kTwo +
            text_of({"0.000000\t1\t5", "3.000000\t2\t6"}) + "\r\n";
  }
  const Recordings read = this->read(text);
  EXPECT_EQ(read.recordings.at(0).axis, (Axis{kTime, 0.0, 3.0, {}}));
  EXPECT_TRUE(read.warnings.empty());
}

// Three x of four; the steps of x are those of a full column, the others follow.
TEST_F(LvmFiles, CompareTheirFewerPointsWithTheStep) {
  const auto read_with = [&](const std::string& step, const std::string& third) {
    return this->read(file_header("One") + kUnits + "Delta_X\t" + step + "\t" + step + "\t\r\n" +
                      kSection + kTwo + text_of({kRows[0], kRows[1], third + "\t3\t7", "\t4\t8"}));
  };
  const Recordings contradicted = read_with("0.002000", "0.002000");
  EXPECT_EQ(contradicted.recordings.at(0).axis, (Axis{kTime, 0.0, 1e-3, {}}));
  EXPECT_TRUE(has_warning(contradicted, "rate_contradicts"));
  EXPECT_TRUE(has_warning(contradicted, "points_missing"));
  const Recordings uneven = read_with("0.001000", "0.500000");
  EXPECT_EQ(uneven.recordings.at(0).axis.values, (Values{0, 1e-3, 0.5, 0.501}));
  EXPECT_TRUE(has_warning(uneven, "rate_contradicts"));
  EXPECT_NE(message_of<Error>([&] {
              read_with("0.001000", "0.000000");
            }).find("x that do not rise: 0 after 0.001"),
            std::string::npos);
}

TEST_F(LvmFiles, MayHaveLessPointsThanValues) {
  const Lines rows{kRows[0], kRows[1], "\t3\t7", "\t4\t8"};
  const Recordings read =
      this->read(file_header("One") + kUnits + kSteps + kSection + kTwo + text_of(rows));
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].axis, (Axis{kTime, 0.0, 1e-3, {}}));
  EXPECT_EQ(read.recordings[0].channel("Force").values, (Values{1, 2, 3, 4}));
  EXPECT_TRUE(has_warning(read, "points_missing"));
  const Lines one{kRows[1], "\t3\t7", "\t4\t8"};
  for (const std::string dimension : {"Time", "Frequency"}) {
    const Recording begun = only(file_header("One") + kUnits + "X_Dimension\t" + dimension + "\t" +
                                 dimension + "\t\r\n" + kSteps + kSection + kTwo + text_of(one));
    EXPECT_EQ(begun.axis, (Axis{dimension == "Time" ? kTime : kFrequency, 1e-3, 1e-3, {}}));
  }
  test::put(path_, file_header("One") + kUnits + kSection + kTwo + text_of(rows));
  const std::string message = message_of<Error>([&] { return read_recordings(path_, {}); });
  EXPECT_NE(message.find("found 2 x for its 4 values"), std::string::npos) << message;
}

TEST_F(LvmFiles, NameThePlaceWherePointsFall) {
  test::put(path_, file_header("One") + kUnits + kSteps + kSection + kTwo +
                       text_of({kRows[0], kRows[1], kRows[3], kRows[2]}));
  EXPECT_EQ(message_of<Error>([&] { return read_recordings(path_, {}); }),
            path_ +
                ": expected x that rise, found x that do not rise: 0.002 after 0.003, value 4 "
                "below line 12. Split the file there, or take out rows that were recorded "
                "twice.");
}

// Each value in a section of its own: the step is that which is stated.
TEST_F(LvmFiles, JoinSingleValuesThatGoOnByTheirTime) {
  std::string text = file_header("One");
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    text += fmt::format("Channels\t2\t\t\r\nDate\t2026/11/29\t2026/11/29\t\r\nTime\t{0}\t{0}\t\r\n",
                        fmt::format("10:00:00.25{}000", i)) +
            kSteps + kSection + kTwo + kRows[0].substr(0, 8) + kRows[i].substr(8) + "\r\n\r\n";
  }
  const Recording recording = only(text);
  EXPECT_EQ(recording.channel("Force").values, (Values{1, 2, 3, 4}));
  EXPECT_EQ(recording.axis.step, 1e-3);
}

// As other programs write it; a column more than names.
TEST_F(LvmFiles, MayLackTheColumnOfXAndNames) {
  const Recording recording = only(file_header("No") + kUnits + kSteps + kSection +
                                   "Force\tAcc\tComment\r\n1\t5\tfirst\r\n2\t6\r\n");
  EXPECT_EQ(recording.channel("Force").dimension, kForce);
  EXPECT_EQ(recording.channel("Acc").dimension, kAcceleration);
  const Recording more =
      only(file_header("One") + kUnits + kSteps + kSection + "X_Value\tForce\r\n" + text_of(kRows));
  EXPECT_EQ(more.channel("channel_2").dimension, kAcceleration);
}

TEST_F(LvmFiles, AreOverTimeOrFrequencyAlone) {
  const std::string rest = kSteps + kSection + kTwo + text_of(kRows);
  for (const char* x_columns : {"One", "No"}) {
    const std::string message = message_of<Error>([&] {
      (void)read(file_header(x_columns) + kUnits + "X_Dimension\tDisplacement\tDisplacement\r\n" +
                 rest);
    });
    EXPECT_NE(message.find("X_Dimension 'Displacement'"), std::string::npos) << message;
  }
  const Recordings one =
      read(file_header("One") + kUnits + "X_Dimension\tTime\tDisplacement\r\n" + rest);
  EXPECT_EQ(one.recordings.at(0).channels.size(), 1U);
  EXPECT_TRUE(has_warning(one, "sampling_rate_missing"));
  EXPECT_EQ(only(file_header("One") + kUnits + "X_Dimension\tFrequency\tFrequency\r\n" + rest)
                .axis.dimension,
            kFrequency);
}

TEST_F(LvmFiles, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(
      only("\xEF\xBB\xBF" + file_header("One") + kUnits + kSteps + kSection + kTwo + text_of(kRows))
          .size(),
      4U);
}

// Sections of 2 ms whose clock takes 5 % longer than x: no section lags by much, all of them do.
TEST_F(LvmFiles, TellOnceOfAClockThatLags) {
  const auto read_lagging = [&](double share, const std::string& others = "") {
    std::string text = file_header("One", others);
    for (int i = 0; i < 10; ++i) {
      const double x = 2e-3 * i;
      text += "Channels\t2\t\t\r\n" +
              fmt::format("Date\t2026/11/29\t2026/11/29\t\r\nTime\t{0}\t{0}\t\r\n",
                          fmt::format("10:00:{:09.6f}", x * (1.0 + share))) +
              kSteps + kSection + kTwo +
              text_of({fmt::format("{:.6f}\t1\t5", x), fmt::format("{:.6f}\t2\t6", x + 1e-3)}) +
              "\r\n";
    }
    return this->read(text);
  };
  const Recordings read = read_lagging(0.05);
  EXPECT_EQ(read.recordings.at(0).size(), 20U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "time_jumps");
  EXPECT_NE(read.warnings[0].text.find("take 0.018 s by x and 0.0189 s by Date and Time"),
            std::string::npos)
      << read.warnings[0].text;
  EXPECT_TRUE(read_lagging(0.005).warnings.empty());
  EXPECT_EQ(read_lagging(0.05, "Time_Pref\tAbsolute\r\n").warnings.size(), 1U)
      << "whatever x count from";
}

TEST_F(LvmFiles, TakeTheStepWhereAnXIsMissing) {
  const Recordings read =
      this->read(file_header("One") + "Channels\t2\t\t\r\n" + kSteps + kSection + kTwo +
                 text_of({kRows[0], kRows[1], "\t3\t7", kRows[3]}));
  EXPECT_EQ(read.recordings.at(0).axis.step, 1e-3);
  EXPECT_EQ(read.recordings[0].channel("Force").values, (Values{1, 2, 3, 4}));
  EXPECT_TRUE(has_warning(read, "points_missing"));
  const std::string message = message_of<Error>([&] {
    (void)this->read(file_header("One") + "Channels\t2\t\t\r\n" + kSection + kTwo +
                     text_of({kRows[0], kRows[1], "\t3\t7", kRows[3]}));
  });
  EXPECT_NE(message.find("no x for value 3"), std::string::npos) << message;
}

}  // namespace
}  // namespace microslip::lvm_recording_test
