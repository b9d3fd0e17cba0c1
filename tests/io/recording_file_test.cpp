// SPDX-License-Identifier: MIT
#include "microslip/io/open/recording_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "support/figures.hpp"

namespace microslip::recording_file_test {
namespace {

using std::literals::operator""s;
using test::message_of;

RecordingFormat format_of(const std::string& content) {
  const test::TemporaryFolder folder;
  test::put(folder.file("r"), content);
  return recording_format(folder.file("r"));
}

Recording sample() {
  Recording r;
  r.source = "sample";
  r.axis.step = 1.0 / 512.0;
  for (const char* name : {"force", "acc1"}) {
    Channel channel{.name = name,
                    .dimension = name[0] == 'f' ? kForce : kAcceleration,
                    .values = {},
                    .imaginary = {},
                    .attributes = {}};
    for (int i = 0; i < 100; ++i) channel.values.push_back(std::sin(0.1 * i + name[0]));
    r.channels.push_back(std::move(channel));
  }
  return r;
}

void write(const std::string& path, const std::vector<Recording>& recordings,
           RecordingFormat format) {
  OutputFiles files;
  write_recordings(files, path, recordings, format);
  files.commit();
}

// ---- Formats. ----

TEST(RecordingFormat, IsToldByTheContent) {
  EXPECT_EQ(format_of("time [s],a\n0,1\n"), RecordingFormat::kCsv);
  EXPECT_EQ(format_of(""), RecordingFormat::kCsv) << "its reader will complain";
  EXPECT_EQ(format_of("    -1\n    58\n"), RecordingFormat::kUff);
  EXPECT_EQ(format_of("    -1\r\n   151\r\n"), RecordingFormat::kUff);
  EXPECT_EQ(format_of("    -1\n   151\nx\n    -1\n    -1\n    58b     1     2\n"),
            RecordingFormat::kUffBinary);
  EXPECT_EQ(format_of("MATLAB 5.0 MAT-file, Platform: GLNXA64"), RecordingFormat::kMat);
  EXPECT_EQ(format_of("MATLAB 7.3 MAT-file, Platform: GLNXA64"), RecordingFormat::kMat)
      << "its reader will complain";
  std::string head = "MATLAB 7.3 MAT-file";
  head.resize(512, ' ');
  EXPECT_EQ(format_of(head + "\x89HDF\r\n\x1A\n"), RecordingFormat::kMat73);
  EXPECT_EQ(format_of("\x89HDF\r\n\x1A\n"), RecordingFormat::kHdf5);
  EXPECT_EQ(format_of(std::string(1024, '\0') + "\x89HDF\r\n\x1A\n"), RecordingFormat::kHdf5);
}

TEST(RecordingFormat, RefusesOtherSignatures) {
  EXPECT_NE(
      message_of<FormatError>([] { return format_of("\x89PNG\r\n\x1A\n"); })
          .find("expected a recording in CSV, a universal file, MATLAB, Octave, HDF5, TDMS, LVM "
                "or WAV, found a PNG"),
      std::string::npos);
  EXPECT_THROW(format_of("{\"a\": 1}"), FormatError);
}

/// Of little-endian order: type, rows, columns, no imaginary part, length of the name, name.
std::string mat4_head() {
  std::string head(20, '\0');
  head[4] = 100;
  head[8] = 1;
  head[16] = 5;
  return head + std::string("time\0", 5) + std::string(800, '\x3F');
}

TEST(RecordingFormat, KnowsFilesOfDataLoggersAndOfOctave) {
  EXPECT_EQ(format_of("TDSm\x0E\0\0\0"s), RecordingFormat::kTdms);
  EXPECT_EQ(format_of("LabVIEW Measurement\t\r\n"), RecordingFormat::kLvm);
  EXPECT_EQ(format_of("RIFF\x24\0\0\0WAVEfmt "s), RecordingFormat::kWav);
  EXPECT_EQ(format_of("# Created by Octave 7.3.0\n# name: x\n"), RecordingFormat::kMat);
  EXPECT_EQ(format_of(mat4_head()), RecordingFormat::kMat);
}

// They are read alone.
TEST(RecordingFormat, WritesNoFilesOfDataLoggers) {
  const test::TemporaryFolder folder;
  EXPECT_NE(message_of<InputError>([&] {
              write(folder.file("a.tdms"), {sample()}, RecordingFormat::kTdms);
            }).find("a TDMS file of LabVIEW"),
            std::string::npos);
}

// What laboratories bring and is not read is named, with the way out.
TEST(RecordingFormat, NamesFormatsOfLaboratories) {
  struct Case {
    std::string head;
    std::string name;
    std::string remedy;
  };
  const std::vector<Case> cases{
      {"MDF     4.10    ", "an MDF file (ASAM)", "asammdf"},
      {"BZh11AY&SY\x5C", "a bzip2 archive", "Unpack it first"},
      {"BZh91AY&SY\x5C", "a bzip2 archive", "Unpack it first"},
      {"\x93NUMPY\x01\0v\0{"s, "an NPY file of NumPy", "savemat"},
      {"CDF\x01\0\0\0\0"s, "a netCDF-3 file", "nccopy -k nc4"},
      {"\x0E\x03\x13\x01", "an HDF4 file", "h4toh5"},
      {"Octave-1-L\0"s, "a binary file of Octave", "save -v7"},
      {"PK\x03\x04", "a ZIP archive or a spreadsheet", "as CSV"},
      {"PAR1\x15", "a Parquet file", "to_csv"},
  };
  for (const Case& c : cases) {
    const std::string message = message_of<FormatError>([&] { return format_of(c.head); });
    EXPECT_NE(message.find("found " + c.name + ". "), std::string::npos) << message;
    EXPECT_NE(message.find(c.remedy), std::string::npos) << message;
  }
  for (const char* table : {"time [s],a\n0,1\n", "PAR1,PAR2\n", "MDF [N],t [s]\n", "BZh,t\n"}) {
    EXPECT_EQ(format_of(table), RecordingFormat::kCsv) << table;
  }
}

TEST(RecordingFormat, OfNamesOfOutputs) {
  EXPECT_EQ(recording_format_of_name("a/b.CSV"), RecordingFormat::kCsv);
  EXPECT_EQ(recording_format_of_name("-"), RecordingFormat::kCsv);
  EXPECT_EQ(recording_format_of_name("x.csv.uff"), RecordingFormat::kUffBinary);
  EXPECT_EQ(recording_format_of_name("x.unv"), RecordingFormat::kUffBinary);
  EXPECT_EQ(recording_format_of_name("x.uf"), RecordingFormat::kUffBinary);
  EXPECT_EQ(recording_format_of_name("x.mat"), RecordingFormat::kMat);
  EXPECT_EQ(recording_format_of_name("x.h5"), RecordingFormat::kHdf5);
  EXPECT_EQ(recording_format_of_name("x.hdf5"), RecordingFormat::kHdf5);
  EXPECT_NE(message_of<InputError>([] { return recording_format_of_name("x.txt"); }).find(".hdf5"),
            std::string::npos);
  EXPECT_EQ(find_recording_format("uff-ascii"), RecordingFormat::kUff);
  EXPECT_FALSE(find_recording_format("txt").has_value());
}

// ---- Reading. ----

TEST(RecordingFile, GivesAssumedUnits) {
  const test::TemporaryFolder folder;
  test::put(folder.file("r.csv"), "t,force,acc1\n0,1,1\n500,2,2\n");
  const std::vector<std::string> arguments{"t=ms", "force=kN", "SI"};
  const Recordings found =
      read_recordings(folder.file("r.csv"), {.assumed_units = parse_assumed_units(arguments)});
  const Recording& r = found.recordings.at(0);
  EXPECT_EQ(r.axis.step, 0.5);
  EXPECT_EQ(r.signal("force", kForce)[1], 2000.0);
  EXPECT_EQ(r.signal("acc1", kAcceleration)[1], 2.0);
}

TEST(RecordingFile, TakesAStatedRateWhereTheFileHasNone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.csv");
  test::put(path, "force [N],acc [g]\n1,2\n3,4\n5,6\n");
  const Recordings read = read_recordings(path, {.rate = 2048.0});
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].axis.step, 1.0 / 2048.0);
  EXPECT_EQ(read.recordings[0].channels.size(), 2U);
  EXPECT_TRUE(read.warnings.empty());
  test::put(path, "acc [g]\n2\n4\n6\n");
  EXPECT_EQ(read_recordings(path, {.rate = 2048.0}).recordings.at(0).size(), 3U);
  test::put(path, "time [s],force [N]\n0,2\n1,4\n2,6\n");
  EXPECT_EQ(message_of<InputError>([&] { (void)read_recordings(path, {.rate = 2048.0}); }),
            fmt::format("`rate` = 2048 Hz; must not be given for {}: it has times or a rate of its "
                        "own. Leave it out.",
                        path));
  EXPECT_NE(message_of<InputError>([&] {
              (void)read_recordings(path, {.rate = -1.0});
            }).find("`rate` = -1; must be above 0 Hz"),
            std::string::npos);
}

TEST(RecordingFile, AColonIsPartOfANameThatIsThere) {
  const test::TemporaryFolder folder;
  test::put(folder.file("a:b.csv"), "time [s],x\n0,1\n1,2\n");
  test::put(folder.file("a"), "time [s],x\n0,1\n1,2\n");
  EXPECT_EQ(read_recordings(folder.file("a:b.csv"), {}).recordings.at(0).source, "a:b.csv");
  EXPECT_NE(message_of<InputError>([&] {
              return read_recordings(folder.file("a:x.y[1]"), {});
            }).find("':x.y[1]'; must follow a MATLAB file"),
            std::string::npos);
  EXPECT_NE(message_of<FileError>([&] {
              return read_recordings(folder.file("no:b"), {});
            }).find("no:b: cannot be read"),
            std::string::npos);
}

// ---- Writing. ----

// Its reader would open it again, and wait for ever.
TEST(RecordingFile, RefusesAPipeThatIsNoCsv) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& head :
       {"TDSm"s + std::string(24, '\0'), "\x89HDF\r\n\x1A\n"s,
        "MATLAB 5.0 MAT-file"s + std::string(200, ' '), "    -1\n    58\n"s, "RIFF    WAVEfmt "s}) {
    const auto through = [&](const auto& read) {
      std::thread writer([&] { test::put(pipe, head); });
      const std::string message = message_of<Error>(read);
      writer.join();
      return message;
    };
    const std::string expected = pipe +
                                 ": is a pipe or a device, which supports recordings in CSV only. "
                                 "Save them in a file and name that.";
    EXPECT_EQ(through([&] { return read_recordings(pipe, {}); }), expected) << head;
    EXPECT_EQ(through([&] { return recording_format(pipe); }), expected) << head;
  }
}

TEST(RecordingFile, CsvHoldsOneRecording) {
  const test::TemporaryFolder folder;
  const auto fault = message_of<InputError>([&] {
    write(folder.file("r.csv"), {sample(), sample()}, RecordingFormat::kCsv);
    return 0;
  });
  EXPECT_NE(fault.find("2 recordings; must be one in a CSV file"), std::string::npos) << fault;
  EXPECT_TRUE(folder.names().empty());
}

/// The number of samples and times of two recordings that differ in a bit.
int differences(const Recording& a, const Recording& b) {
  int count = a.size() == b.size() && a.channels.size() == b.channels.size() ? 0 : 1;
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  for (std::size_t i = 0; i < a.size() && count == 0; ++i) {
    count += same(a.axis.at(i), b.axis.at(i)) ? 0 : 1;
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
      count += same(a.channels[c].values[i], b.channels[c].values[i]) ? 0 : 1;
    }
  }
  return count;
}

// What one format holds the next holds too. Text has 13 digits: what counts is what is read of it.
TEST(RecordingFile, SurvivesEachFormatInTurn) {
  const test::TemporaryFolder folder;
  RandomStream random(5, 0);
  Recording recording = sample();
  recording.axis.step = 1.0 / 8192.0;
  for (Channel& channel : recording.channels) {
    channel.values.resize(2000);
    for (double& value : channel.values) value = std::exp(40.0 * random.normal()) * random.normal();
  }
  write(folder.file("r.uff"), {recording}, RecordingFormat::kUff);
  const Recording first = read_recordings(folder.file("r.uff"), {}).recordings.at(0);
  Recording last = first;
  for (const auto& [name, format] :
       {std::pair{"r.58b", RecordingFormat::kUffBinary}, std::pair{"r.h5", RecordingFormat::kHdf5},
        std::pair{"r.mat", RecordingFormat::kMat},
        std::pair{"again.58b", RecordingFormat::kUffBinary}}) {
    write(folder.file(name), {last}, format);
    last = read_recordings(folder.file(name), {}).recordings.at(0);
    EXPECT_EQ(differences(last, first), 0) << name;
    for (std::size_t c = 0; c < first.channels.size(); ++c) {
      EXPECT_EQ(last.channels.at(c).name, first.channels[c].name) << name;
      EXPECT_EQ(last.channels.at(c).dimension, first.channels[c].dimension) << name;
    }
  }
  test::record_largest("changed [1]", differences(last, first));
}

TEST(RecordingFile, ReplacesItsOwnKindAlone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("r.csv");
  write(path, {sample()}, RecordingFormat::kCsv);
  write(path, {sample()}, RecordingFormat::kCsv);
  Recording other = sample();
  other.channels.pop_back();
  const std::string before = test::get(path);
  EXPECT_THROW(write(path, {other}, RecordingFormat::kCsv), FileError) << "of other channels";
  test::put(folder.file("l.csv"), "amplitude [m],dissipation [J]\n1,1\n");
  EXPECT_THROW(write(folder.file("l.csv"), {sample()}, RecordingFormat::kCsv), FileError);
  EXPECT_EQ(test::get(path), before);
  EXPECT_EQ(folder.names().size(), 2U) << "no temporaries";
}

class EachFormat : public ::testing::TestWithParam<RecordingFormat> {};

TEST_P(EachFormat, ReadsBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("recording");
  write(path, {sample()}, GetParam());
  EXPECT_EQ(recording_format(path), GetParam());
  const Recordings found = read_recordings(path, {});
  ASSERT_EQ(found.recordings.size(), 1U);
  const Recording& back = found.recordings[0];
  ASSERT_EQ(back.size(), 100U);
  EXPECT_TRUE(back.axis.even());
  EXPECT_EQ(back.sampling_rate(), 512.0);
  const Recording written = sample();
  for (const Channel& channel : written.channels) {
    const auto values = back.signal(channel.name, *channel.dimension);
    for (std::size_t i = 0; i < values.size(); ++i) {
      // 13 significant digits in the text of a universal file; all of them elsewhere.
      const double tolerance = GetParam() == RecordingFormat::kUff ? 1e-12 : 0.0;
      EXPECT_NEAR(values[i], channel.values[i], tolerance) << channel.name << " " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RecordingFile, EachFormat,
                         ::testing::Values(RecordingFormat::kCsv, RecordingFormat::kUff,
                                           RecordingFormat::kUffBinary, RecordingFormat::kMat,
                                           RecordingFormat::kHdf5));

}  // namespace
}  // namespace microslip::recording_file_test
