// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/recording_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "io/damage.hpp"
#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::recording_csv_test {
namespace {

using std::literals::operator""s;
using test::message_of;
using Numbers = std::vector<double>;

Recordings read_all(const std::string& text, const RecordingReadOptions& options = {}) {
  const test::TemporaryFolder folder;
  test::put(folder.file("r.csv"), text);
  return read_recordings_csv(folder.file("r.csv"), options);
}

Recording read(const std::string& text, const RecordingReadOptions& options = {}) {
  return read_all(text, options).recordings.front();
}

/// What is wrong with a text, without the folder of the file.
std::string fault(const std::string& text, const RecordingReadOptions& options = {}) {
  const std::string message = message_of<Error>([&] { return read_all(text, options); });
  const std::size_t name = message.find("r.csv");
  return name == std::string::npos ? message : message.substr(name);
}

std::string with_rows(const std::string& header) { return header + "\n0,1\n0.5,2\n1,4\n"; }

AssumedUnits assumed(const std::vector<std::string>& arguments) {
  return parse_assumed_units(arguments);
}

void expect_same(const Recording& found, const Recording& expected, const std::string& form = {}) {
  EXPECT_EQ(found.source, expected.source) << form;
  EXPECT_EQ(found.axis, expected.axis) << form;
  EXPECT_EQ(found.channels, expected.channels) << form;
  EXPECT_EQ(found.attributes, expected.attributes) << form;
}

// ---- What is read. ----

TEST(RecordingCsv, ReadsChannelsInSi) {
  const Recording r = read("time [ms],force [kN],acc1 [g]\n0,1,1\n0.5,-2,0\n1,0.25,-1\n");
  EXPECT_EQ(r.source, "r.csv");
  EXPECT_TRUE(r.axis.even());
  EXPECT_EQ(r.axis.dimension, kTime);
  EXPECT_EQ(r.axis.start, 0.0);
  EXPECT_EQ(r.axis.step, 1.0 / 2000.0);
  ASSERT_EQ(r.channels.size(), 2U);
  EXPECT_EQ(r.channels[0].name, "force");
  EXPECT_EQ(r.channels[0].dimension, kForce);
  EXPECT_EQ(r.channels[0].values, (Numbers{1000.0, -2000.0, 250.0}));
  EXPECT_EQ(r.channels[1].dimension, kAcceleration);
  EXPECT_EQ(r.channels[1].values, (Numbers{9.80665, 0.0, -9.80665}));
}

TEST(RecordingCsv, ReadsTheSameWhateverTheFormOfTheText) {
  const Recording expected = read("time [s],a [m/s^2],b [um]\n0,1.5,0.25\n0.5,-2,3\n1,2.5,4\n");
  const std::vector<std::pair<std::string, std::string>> forms{
      {"CRLF, BOM",
       "\xEF\xBB\xBFtime [s],a [m/s^2],b [um]\r\n0,1.5,0.25\r\n0.5,-2,3\r\n1,2.5,4\r\n"},
      {"semicolons", "time [s];a [m/s^2];b [um]\n0;1.5;0.25\n0.5;-2;3\n1;2.5;4\n"},
      {"tabs", "time [s]\ta [m/s^2]\tb [um]\n0\t1.5\t0.25\n0.5\t-2\t3\n1\t2.5\t4\n"},
      {"decimal commas", "time [s];a [m/s^2];b [um]\n0;1,5;0,25\n0,5;-2;3\n1;2,5;4\n"},
      {"decimal commas, tabs",
       "time [s]\ta [m/s^2]\tb [um]\n0\t1,5\t0,25\n0,5\t-2\t3\n1\t2,5\t4\n"},
      {"decimal commas that come late",
       "time [s];a [m/s^2];b [um]\n0;15e-1;25e-2\n5e-1;-2;3\n1;2,5;4,000\n"},
      {"parentheses", "time (s),a (m/s^2),b (um)\n0,1.5,0.25\n0.5,-2,3\n1,2.5,4\n"},
      {"units below", "time,a,b\ns,m/s^2,um\n0,1.5,0.25\n0.5,-2,3\n1,2.5,4\n"},
      {"units below in brackets", "time,a,b\n[s],[m/s²],[µm]\n0,1.5,0.25\n0.5,-2,3\n1,2.5,4\n"},
      {"CP1252", "time [s],a [m/s\xB2],b [\xB5m]\n0,1.5,0.25\n0.5,-2,3\n1,2.5,4\n"},
      {"quotes",
       "\"time [s]\",\"a [m/s^2]\",\"b [um]\"\n\"0\",1.5,0.25\n0.5,\"-2\",3\n1,2.5,\"4\"\n"},
      {"blanks, plus", " time  [ s ] , a [m/s^2],b [um]\n 0 , +1.5 ,0.25\n0.5,-2 , 3\n1,2.5,4 \n"},
      {"separators that end lines",
       "time [s],a [m/s^2],b [um],\n0,1.5,0.25,\n0.5,-2,3\n1,2.5,4,\n"},
      {"blank lines", "\n \t\ntime [s],a [m/s^2],b [um]\n\n0,1.5,0.25\n0.5,-2,3\r\n\n1,2.5,4\n\n"},
      {"exponents", "time [s],a [m/s^2],b [um]\n0e0,15E-1,.25\n5e-1,-2.,+3\n1e+0,0.25e1,4\n"},
  };
  for (const auto& [form, text] : forms) expect_same(read(text), expected, form);
}

TEST(RecordingCsv, KeepsCommentsAsAttributes) {
  const Recording r = read(
      "# lap joint, level 3\n% operator = A. B\xF6hm\n// start: 12:30:45\n#\n"
      "# force / serial number: 4711\ntime [s],force [N]\n0,1\n# bump here\n1,2\n");
  EXPECT_EQ(r.attributes, (Attributes{{"comment", "lap joint, level 3"},
                                      {"operator", "A. Böhm"},
                                      {"start", "12:30:45"},
                                      {"comment", "bump here"}}));
  EXPECT_EQ(r.channels[0].attributes, (Attributes{{"serial number", "4711"}}));
}

TEST(RecordingCsv, ColumnsWithoutUnitHaveNoDimension) {
  const Recording r = read("time [s],a,b [],c [-],Force_N\n0,1,2,3,4\n1,2,3,4,5\n");
  EXPECT_FALSE(r.channels[0].dimension.has_value());
  EXPECT_FALSE(r.channels[1].dimension.has_value());
  EXPECT_EQ(r.channels[2].dimension, kDimensionless);
  EXPECT_FALSE(r.channels[3].dimension.has_value()) << "only brackets hold units";
  EXPECT_EQ(r.channels[3].values, (Numbers{4.0, 5.0})) << "as in the file";
}

TEST(RecordingCsv, TheAxisIsTheFirstColumnOfTimeOrFrequency) {
  const Recording r = read("a [N],clock [s],delay [s]\n5,0,0.1\n6,1,0.1\n");
  EXPECT_EQ(r.axis.step, 1.0);
  EXPECT_EQ(r.channels[0].name, "a");
  EXPECT_EQ(r.channels[1].name, "delay");
  EXPECT_EQ(read("frequency [Hz],delay [s],H [m/N]\n1,0.1,2\n2,0.3,3\n").axis.dimension,
            kFrequency);
  EXPECT_EQ(read("delay [s],H [m/N]\n1,2\n2,3\n").axis.dimension, kTime);
  const Recording f = read("f [kHz],H [m/N]\n1,2\n2,3\n4,3\n");
  EXPECT_EQ(f.axis.dimension, kFrequency);
  EXPECT_EQ(f.axis.values, (Numbers{1000.0, 2000.0, 4000.0}));
}

TEST(RecordingCsv, TakesTheRateFromACommentWhereThereIsNoTime) {
  for (const char* comment :
       {"# fs = 8192 Hz", "% Sampling Rate: 8.192 kHz", "//sampling_rate=8192",
        "# sample rate: 8192", "# sampling frequency = 8.192e3 Hz", "# SampleRate: 8192 Hz",
        "# ActualRate = 8192"}) {
    const Recording r = read(comment + "\nforce [N],speed [Hz]\n1,50\n2,51\n"s);
    EXPECT_EQ(r.axis.start, 0.0) << comment;
    EXPECT_EQ(r.axis.step, 1.0 / 8192.0) << comment;
    EXPECT_EQ(r.channels.size(), 2U) << "a frequency is a channel then";
  }
}

TEST(RecordingCsv, WarnsWhereTheRateOfACommentIsAnother) {
  const Recordings same = read_all("# fs = 10 Hz\ntime [s],a\n0,1\n0.1,2\n");
  EXPECT_TRUE(same.warnings.empty());
  const Recordings other = read_all("# fs = 20 Hz\ntime [s],a\n0,1\n0.1,2\n");
  ASSERT_EQ(other.warnings.size(), 1U);
  EXPECT_EQ(other.warnings[0].code, "sampling_rates_differ");
  EXPECT_EQ(other.recordings[0].axis.step, 0.1);
}

TEST(RecordingCsv, TakesAUnitThatIsAssumedForTheAxis) {
  const std::string text = "T,force\n0,1\n500,2\n";
  EXPECT_EQ(fault(text),
            "r.csv:1:1: expected a unit of time for column 1, found 'T' without one. "
            "Write 'T [s]', or give `assume_units T=s`.");
  EXPECT_EQ(read(text, {.assumed_units = assumed({"T=ms"})}).axis.step, 0.5);
  const Recording si = read(text, {.assumed_units = assumed({"SI"})});
  EXPECT_EQ(si.axis.step, 500.0);
  EXPECT_FALSE(si.channels[0].dimension.has_value()) << "channels are not its business";
  EXPECT_NE(fault(text, {.assumed_units = assumed({"T=N"})}).find("must be one of time"),
            std::string::npos);
  EXPECT_NE(fault("T [s],a\n0,1\n1,2\n", {.assumed_units = assumed({"T=s"})})
                .find("must have no unit if one is assumed"),
            std::string::npos);
}

TEST(RecordingCsv, ReadsComplexChannels) {
  const Recording r = read(
      "frequency [Hz],H.real [m/N],H.imag [m/N],b.imag,c.real [N],c.imag [m]\n"
      "1,2,3,4,5,6\n2,7,8,9,10,11\n");
  ASSERT_EQ(r.channels.size(), 4U);
  EXPECT_EQ(r.channels[0].name, "H");
  EXPECT_EQ(r.channels[0].values, (Numbers{2.0, 7.0}));
  EXPECT_EQ(r.channels[0].imaginary, (Numbers{3.0, 8.0}));
  EXPECT_EQ(r.channels[1].name, "b.imag");
  EXPECT_EQ(r.channels[3].name, "c.imag") << "of another unit";
}

/// More than a piece of what is read at once, with comments, line lengths and decimals of all
/// sorts, against strtod.
TEST(RecordingCsv, ReadsLongFilesInPieces) {
  std::mt19937_64 random(1);
  std::string text = "time [s],a [N],b [N]\n";
  Numbers a;
  Numbers b;
  const auto append_random = [&](Numbers& values) {
    const double value = std::ldexp(static_cast<double>(random() >> 11U), -50) - 4.0;
    std::string cell = std::to_string(value);
    cell.resize(std::min<std::size_t>(cell.size(), 4 + random() % 8));
    text += "," + cell;
    values.push_back(std::strtod(cell.c_str(), nullptr));
  };
  for (int i = 0; text.size() < 5'000'000; ++i) {
    text += std::to_string(i);
    append_random(a);
    append_random(b);
    text += i % 7 == 0 ? "\r\n" : "\n";
    if (i % 1000 == 0) text += "# " + std::string(random() % 300, 'x') + "\n";
  }
  const Recording r = read(text);
  EXPECT_EQ(r.axis.step, 1.0);
  EXPECT_EQ(r.channels[0].values, a);
  EXPECT_EQ(r.channels[1].values, b);
  const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(fault(text + "x,1,2\n").find("r.csv:" + std::to_string(lines + 1) + ":1: "), 0U);
}

TEST(RecordingCsv, ReportsBytesAndCanBeStopped) {
  std::string text = "time [s],a [N]\n";
  for (int i = 0; text.size() < 3'000'000; ++i) text += std::to_string(i) + ",0.5\n";
  std::vector<std::size_t> reported;
  const auto listen = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, text.size());
    reported.push_back(done);
    return true;
  };
  (void)read(text, {.progress = listen});
  EXPECT_GE(reported.size(), 3U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), text.size());
  EXPECT_THROW((void)read(text, {.progress = [](std::size_t, std::size_t) { return false; }}),
               Cancelled);
}

// ---- A file that was cut. ----

TEST(RecordingCsvCut, WithinARow) {
  const std::string text = "time [s],a [N]\n0,1\n1,2\n2";
  EXPECT_EQ(fault(text),
            "r.csv:4:1: expected 2 cells as in the header, found 1 and the end of the "
            "file. It was truncated; `allow_truncated` leaves out this row.");
  EXPECT_NE(fault(text + ",1e").find("`allow_truncated`"), std::string::npos);
  EXPECT_NE(fault(text + ",").find("`allow_truncated`"), std::string::npos);
  for (const std::string& rest : {""s, ","s, ",1e"s, ",3"s}) {
    const Recordings r = read_all(text + rest, {.allow_truncated = true});
    EXPECT_EQ(r.recordings[0].size(), 2U);
    ASSERT_EQ(r.warnings.size(), 1U);
    EXPECT_EQ(r.warnings[0].code, "last_row_dropped");
  }
}

TEST(RecordingCsvCut, WhereNobodyCanTell) {
  const Recordings r = read_all("time [s],a [N]\n0,1\n1,2");
  EXPECT_EQ(r.recordings[0].size(), 2U);
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_EQ(r.warnings[0].code, "last_row_open");
}

// ---- What is refused, and with which words. ----

TEST(RecordingCsvFault, Empty) {
  EXPECT_EQ(fault(""),
            "r.csv: expected a header such as 'time [s],force [N],acc1 [m/s^2]', found an "
            "empty file. Was it written to its end?");
  EXPECT_EQ(fault("\n# only this\n"),
            "r.csv: expected a header such as 'time "
            "[s],force [N],acc1 [m/s^2]', found nothing but blanks and "
            "comments. Was it written to its end?");
  EXPECT_EQ(fault("time [s],a\n"), "r.csv: expected two rows of values below the header, found 0");
  EXPECT_EQ(fault("time [s],a\n0,1\n"),
            "r.csv: expected two rows of values below the header, found 1");
}

TEST(RecordingCsvFault, NoHeader) {
  EXPECT_NE(fault("0,1\n1,2\n").find("found a row of numbers. Add a first line"),
            std::string::npos);
  EXPECT_NE(fault("0,5;1,5\n1;2\n").find("found a row of numbers"), std::string::npos);
}

TEST(RecordingCsvFault, Binary) {
  EXPECT_NE(fault("\x89PNG\r\n\x1A\n\0\0"s).find("found a PNG picture"), std::string::npos);
  EXPECT_EQ(fault("\x01\x02"),
            "r.csv:1:1: expected text, found the byte 0x01. Is this a text table?");
  EXPECT_EQ(fault("time [s],a\n0,1\n1,\0\n"s),
            "r.csv:3:3: expected text, found the byte 0x00. Is this a text table?");
  EXPECT_NE(fault("time [s],a\r0,1\r1,2\r").find("Save the table with line breaks LF or CRLF"),
            std::string::npos);
  EXPECT_EQ(
      fault(std::string(20'000'000, 'x')),
      "r.csv:1:1: expected lines of text, found a line of more than 16 MiB. Is this a text table?");
}

TEST(RecordingCsvFault, NoAxis) {
  EXPECT_EQ(
      fault("force [N],acc\n0,1\n1,2\n"),
      "r.csv:1:1: expected a column of time such as 'time [s]', found the columns 'force, acc'. "
      "Name it with its unit, or give the rate by `rate` or in a comment line such as "
      "'# sampling_rate: 8192 Hz'.");
  EXPECT_EQ(
      fault("time [s]\n0\n1\n"),
      "r.csv:1:1: expected a column in addition to the axis, found column 1 'time [s]' alone");
}

TEST(RecordingCsvFault, Units) {
  EXPECT_EQ(read_all(with_rows("time [s],force [furlong]")).warnings.at(0).code, "unit_unknown");
  EXPECT_EQ(fault(with_rows("time (day),force (N)")),
            "r.csv:1:1: expected a unit for column 1 'time', found the unknown unit 'day'. Usual "
            "units: s, ms, us.");
  EXPECT_NE(read_all(with_rows("time,force\ns,furlong"))
                .warnings.at(0)
                .text.find("r.csv:2:3: column 2 'force' is in 'furlong', an unknown unit"),
            std::string::npos);
  EXPECT_NE(fault(with_rows("time [s],force [N")).find("r.csv:1:10: expected 'name [unit]'"),
            std::string::npos);
  EXPECT_NE(fault(with_rows("time,a\ns,N,m")).find("r.csv:2:1: expected 2 cells"),
            std::string::npos);
}

TEST(RecordingCsvFault, Cells) {
  EXPECT_EQ(
      fault("time [s],a [N]\n0,1\n1,nan\n"),
      "r.csv:3:3: expected a finite number in column 2 'a [N]', found 'nan'. Correct the cell or "
      "remove the row.");
  for (const char* cell : {"inf", "-inf", "NaN", "1e999", "abc", "1 2", "1.2.3", "0x10", "1e",
                           "--1", "+-1", "+", "-", ".", "1'000", "nan(1)", "\"\"", "１"}) {
    const std::string place = cell[0] == '"' ? "r.csv:3:4" : "r.csv:3:3";  // behind the quote
    EXPECT_EQ(fault("time [s],a [N]\n0,1\n1,"s + cell + "\n").find(place + ": expected a finite"),
              0U)
        << cell << ": " << fault("time [s],a [N]\n0,1\n1,"s + cell + "\n");
  }
  EXPECT_EQ(
      fault("time [s],a [N]\n0,1\n1,\n"),
      "r.csv:3:3: expected a finite number in column 2 'a [N]', found an empty cell. Correct the "
      "cell or remove the row.");
  EXPECT_NE(fault("time [s],a [GN]\n0,1\n1,1e308\n").find("found '1e308'"), std::string::npos);
  EXPECT_NE(fault("time [s];a [N]\n0;1,5\n1;1.5\n").find("has decimal commas elsewhere"),
            std::string::npos);
  EXPECT_NE(fault("time [s];a [N]\n0;1.5\n1;1,5\n").find("has decimal points elsewhere"),
            std::string::npos);
  EXPECT_NE(fault("time [s],a [N]\n0,1\n1,\"2\n").find("a closing quote"), std::string::npos);
}

TEST(RecordingCsvFault, Ragged) {
  EXPECT_EQ(
      fault("time [s],a [N],b [N]\n0,1,2\n\n1,2\n2,3,4\n"),
      "r.csv:4:1: expected 3 cells as in the header, found 2. Decimal commas need ';' or tabs "
      "between the columns.");
  EXPECT_NE(fault("time [s],a [N]\n0,1\n1,2,3\n").find("found 3"), std::string::npos);
  EXPECT_NE(fault("time [s],a [N]\n0,1\n1,2,,\n").find("found 4"), std::string::npos);
  EXPECT_NE(fault("time [s];a [N]\n0;1\n1\n").find("The separator of this table is ';'"),
            std::string::npos);
}

TEST(RecordingCsvFault, TimesThatDoNotRise) {
  EXPECT_EQ(
      fault("time [s],a [N]\n0,1\n1,2\n1.0,3\n"),
      "r.csv:4:1: expected a value above that of the row before in column 1 'time [s]', found "
      "'1.0'. Write it with more digits, or remove the row.");
  EXPECT_NE(fault("time [s],a [N]\n0,1\n1,2\n0.5,3\n").find("Sort the rows, or split the file"),
            std::string::npos);
}

// Found by scripts/fuzz: places were counted from the start of the line for each name, for minutes
// here.
TEST(RecordingCsv, NamesOfManyColumns) {
  std::string text = "time [s]";
  for (int i = 0; i < 300000; ++i) {
    text += ",x" + std::to_string(i);
  }
  const std::string expected = "r.csv:2:1: expected 300002 cells";
  EXPECT_EQ(fault(text + ",x7\n0\n").substr(0, expected.size()), expected);
}

TEST(RecordingCsvFault, Files) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)read_recordings_csv(folder.file("none.csv"), {}), FileError);
  EXPECT_THROW((void)read_recordings_csv(folder.file("."), {}), FileError);
}

const std::string kWhole =
    "# fs = 4 Hz\n"
    "time [s],\"force [N]\",acc (m/s\xB2),x\n"
    "0.00,1.5,-2e-3,7\n"
    "0.25,+2.5,3,\"8\"\n"
    "\n"
    "% a pause\r\n"
    "0.50,3.5,1.25,9\r\n"
    "0.75,4.5,0,10,\n";

const std::string kCommas =
    "\xEF\xBB\xBFtime;force;ldv\n[ms];[N];[µm]\n0;1,5;2\n0,5;2;-1,25\n1;4,125;5\n1,5;1;1\n";

void read_damaged(const std::string& path, const std::string& text) {
  test::put(path, text);
  for (const bool allow : {true, false}) {
    const Recordings found = read_recordings_csv(path, {.allow_truncated = allow});
    ASSERT_EQ(found.recordings.size(), 1U);
    EXPECT_NO_THROW(check_recording(found.recordings[0])) << text;
  }
}

TEST(RecordingCsvDamage, ByPoints) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("r.csv");
  test::damage(kWhole, 11, path, [&](const std::string& text) { read_damaged(path, text); });
}

TEST(RecordingCsvDamage, ByCommas) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("r.csv");
  test::damage(kCommas, 12, path, [&](const std::string& text) { read_damaged(path, text); });
}

TEST(RecordingCsvDamage, CutAtEachByte) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("r.csv");
  for (const std::string& whole : {kWhole, kCommas}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      try {
        read_damaged(path, whole.substr(0, size));
      } catch (const FormatError& error) {
        test::expect_clear(error.what(), path);
      }
    }
  }
}

// ---- What is written. ----

Recording sample() {
  Recording r;
  r.source = "r.csv";
  r.axis.step = 1.0 / 4096.0;
  r.attributes = {{"comment", "a test"}, {"operator", "A. Böhm"}};
  r.channels.resize(3);
  r.channels[0] = {.name = "force",
                   .dimension = kForce,
                   .values = {},
                   .imaginary = {},
                   .attributes = {{"serial number", "4711"}}};
  r.channels[1] = {.name = "acc, \"left\" (x)",
                   .dimension = {},
                   .values = {},
                   .imaginary = {},
                   .attributes = {}};
  r.channels[2] = {
      .name = "flow", .dimension = kMass / kTime, .values = {}, .imaginary = {}, .attributes = {}};
  std::mt19937_64 random(3);
  for (Channel& channel : r.channels) {
    for (int i = 0; i < 1000; ++i) {
      channel.values.push_back(std::ldexp(static_cast<double>(random() >> 11U), -60 + i % 50));
    }
  }
  r.channels[0].values[5] = -0.0;
  r.channels[0].values[6] = std::numeric_limits<double>::denorm_min();
  r.channels[0].values[7] = -std::numeric_limits<double>::max();
  return r;
}

Recording written_and_read(const Recording& recording) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("r.csv");
  write_recording_csv(path, recording);
  EXPECT_EQ(test::get(path), format_recording_csv(recording));
  const Recordings back = read_recordings_csv(path, {});
  EXPECT_TRUE(back.warnings.empty());
  return back.recordings.front();
}

TEST(RecordingCsvWriter, ReadsBackAsItWas) {
  Recording r = sample();
  expect_same(written_and_read(r), r);
  r.axis.start = -0.125;
  expect_same(written_and_read(r), r, "another start");
  r.axis = {.dimension = kFrequency, .start = 0.0, .step = 0.0, .values = {}};
  for (std::size_t i = 0; i < 1000; ++i) r.axis.values.push_back(std::pow(1.01, i));
  r.channels[2].imaginary = r.channels[1].values;
  expect_same(written_and_read(r), r, "uneven, complex");
}

// As of a frequency response in a universal file, whose points name it.
TEST(RecordingCsvWriter, KeepsAttributesOfChannelsWithMarksInTheirNames) {
  Recording r = sample();
  r.channels[0].name = "point 5 +Z / point 2 +Z";
  r.channels[0].attributes = {{"response node", "5"}, {"a / b", "c"}};
  r.channels[1].name = "point 5 +Z";
  r.channels[1].attributes = {{"response node", "6"}};
  r.attributes = {{"no channel / operator", "A. Böhm"}};
  expect_same(written_and_read(r), r);
}

TEST(RecordingCsvWriter, StepsThatAreNoWholeRateComeBackToRounding) {
  Recording r = sample();
  r.axis.start = 0.1;
  r.axis.step = std::sqrt(2.0) * 1e-4;
  const Axis axis = written_and_read(r).axis;
  ASSERT_TRUE(axis.even());
  // Both ends of the record, near 0.24 s, are rounded to half an ulp, 1.4e-17 s.
  EXPECT_NEAR(axis.step, r.axis.step, 1e-16 / 999.0 + 1e-19);
  EXPECT_EQ(axis.start, r.axis.start);
}

TEST(RecordingCsvWriter, RefusesWhatWouldNotReadBack) {
  const auto refused = [](Recording r) {
    const test::TemporaryFolder folder;
    return message_of<InputError>([&] {
      write_recording_csv(folder.file("r.csv"), r);
      return 0;
    });
  };
  Recording r = sample();
  r.channels[0].values[3] = std::nan("");
  EXPECT_NE(refused(r).find("must be finite"), std::string::npos);
  r = sample();
  r.channels[1].name = "a [left]";
  EXPECT_NE(refused(r).find("no ["), std::string::npos);
  r = sample();
  r.channels[1].name = "time";
  EXPECT_NE(refused(r).find("that of the axis"), std::string::npos);
  r = sample();
  r.axis.dimension = kLength;
  EXPECT_NE(refused(r).find("must be time or frequency"), std::string::npos);
}

TEST(RecordingCsvWriter, SaysWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_recording_csv(folder.file("none/r.csv"), sample()), FileError);
  if (std::ifstream("/dev/full")) {
    EXPECT_NE(message_of<FileError>([] {
                write_recording_csv("/dev/full", sample());
                return 0;
              }).find("No space left"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace microslip::recording_csv_test
