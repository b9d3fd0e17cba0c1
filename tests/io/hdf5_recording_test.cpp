// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_recording.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/damaged_binary.hpp"
#include "io/other_hdf5.hpp"
#include "io/sample_recordings.hpp"
#include "io/support.hpp"

namespace microslip::hdf5_recording_test {
namespace {

using test::message_of;
using test::OtherFile;

class Hdf5Recording : public testing::Test {
 protected:
  std::string message() {
    return message_of<Error>([&] { return read_recordings_hdf5(path_); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.h5");
};

TEST_F(Hdf5Recording, SurvivesTheRoundTripBitForBit) {
  const std::vector<Recording> written = test::twelve_recordings();
  write_recordings_hdf5(path_, written);
  const Recordings read = read_recordings_hdf5(path_);
  test::expect_same(read.recordings, written);
  EXPECT_TRUE(read.warnings.empty());
  // == takes −0 for 0.
  const double zero = read.recordings.back().channels[0].values[2];
  EXPECT_EQ(std::bit_cast<std::uint64_t>(zero), std::bit_cast<std::uint64_t>(-0.0));
}

TEST_F(Hdf5Recording, SurvivesWithManyValues) {
  std::vector<Recording> written{test::time_recording(300'001)};
  written[0].channels[1].imaginary = written[0].channels[0].values;
  write_recordings_hdf5(path_, written);
  test::expect_same(read_recordings_hdf5(path_).recordings, written);
}

// The layout of HDF5 1.8 without chunks, whose index is of version 4 else, which jsfive 0.4 does
// not read: the superblock of version 2 [HDF5 File Format Specification 2.0, section II.A].
TEST_F(Hdf5Recording, IsOfALayoutThatOlderProgramsRead) {
  write_recordings_hdf5(path_, std::vector{test::frequency_recording()});
  constexpr std::size_t kPlaceOfVersion = 8;
  EXPECT_EQ(test::get(path_).at(kPlaceOfVersion), '\2');
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, "recording_1/channel_1", H5P_DEFAULT);
  const hid_t properties = H5Dget_create_plist(dataset);
  EXPECT_EQ(H5Pget_layout(properties), H5D_CONTIGUOUS);
  EXPECT_EQ(H5Pget_nfilters(properties), 0);
  H5Pclose(properties);
  H5Dclose(dataset);
  H5Fclose(file);
}

// As files were written that keep checksums in their chunks.
TEST_F(Hdf5Recording, ReadsOwnFilesWithoutAChecksumBesideTheValues) {
  write_recordings_hdf5(path_, std::vector{test::time_recording(100)});
  const auto change = [&](const auto& what) {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "recording_1/channel_1", H5P_DEFAULT);
    what(dataset);
    H5Dclose(dataset);
    H5Fclose(file);
  };
  change([](hid_t dataset) {
    const std::vector<double> others(100, 1.0);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, others.data());
  });
  EXPECT_EQ(message(), path_ +
                           ":/recording_1/channel_1: expected values of the checksum beside "
                           "them, found others. The file is damaged, or another program "
                           "changed it.");
  change([](hid_t dataset) { H5Adelete(dataset, "microslip_checksum"); });
  EXPECT_EQ(read_recordings_hdf5(path_).recordings.at(0).channels[0].values.at(99), 1.0);
}

// The same recording makes the same file, whenever it is written: no object keeps its times.
TEST_F(Hdf5Recording, HoldsNoTimes) {
  write_recordings_hdf5(path_, std::vector<Recording>{test::time_recording(100)});
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const auto keeps_times = [](hid_t properties) {
    hbool_t tracked = true;
    H5Pget_obj_track_times(properties, &tracked);
    H5Pclose(properties);
    return tracked;
  };
  for (const char* name : {"/", "/recording_1"}) {
    const hid_t group = H5Gopen2(file, name, H5P_DEFAULT);
    EXPECT_FALSE(keeps_times(H5Gget_create_plist(group))) << name;
    H5Gclose(group);
  }
  const hid_t dataset = H5Dopen2(file, "/recording_1/channel_1", H5P_DEFAULT);
  EXPECT_FALSE(keeps_times(H5Dget_create_plist(dataset)));
  H5Dclose(dataset);
  H5Fclose(file);
}

TEST_F(Hdf5Recording, TakesDatasetsWithTheUsualAttributes) {
  {
    OtherFile file(path_);
    file.dataset<float>("acc", H5T_NATIVE_FLOAT, {3}, {1.0F, 2.0F, 0.5F});
    file.number("acc", "fs", 256.0);
    file.text("acc", "unit_str", "mm/s^2");
    file.text("acc", "channel_name", "tip");
    file.text("acc", "serial_number", "17");
    file.dataset<short>("raw", H5T_NATIVE_SHORT, {3}, {-1, 2, 300});
    file.number("raw", "dt", 1.0 / 256.0);
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.source, "a.h5");
  EXPECT_EQ(recording.sampling_rate(), 256.0);
  EXPECT_EQ(recording.channel("tip").values, (std::vector{1e-3, 2e-3, 0.5e-3}));
  EXPECT_EQ(recording.channel("tip").dimension, kAcceleration);
  EXPECT_EQ(recording.channel("tip").attributes, (Attributes{{"serial_number", "17"}}));
  EXPECT_EQ(recording.channel("raw").values, (std::vector{-1.0, 2.0, 300.0}));
  EXPECT_FALSE(recording.channel("raw").dimension);
}

TEST_F(Hdf5Recording, TakesTimesAndMatricesOfEitherShape) {
  {
    OtherFile file(path_);
    file.group("run");
    file.dataset<double>("run/time", H5T_NATIVE_DOUBLE, {3}, {1.0, 3.0, 4.0});
    file.text("run/time", "units", "ms");
    file.dataset<double>("run/tall", H5T_NATIVE_DOUBLE, {3, 2}, {1, 10, 2, 20, 3, 30});
    file.dataset<double>("run/wide", H5T_NATIVE_DOUBLE, {2, 3}, {1, 2, 3, 10, 20, 30});
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.source, "a.h5:/run");
  EXPECT_EQ(recording.axis.values, (std::vector{1e-3, 3e-3, 4e-3}));
  for (const char* name : {"tall_2", "wide_2"}) {
    EXPECT_EQ(recording.channel(name).values, (std::vector{10.0, 20.0, 30.0})) << name;
  }
}

TEST_F(Hdf5Recording, TakesTheRateOfTheGroupAround) {
  {
    OtherFile file(path_);
    file.number("/", "sampling_rate", 8.0);
    file.group("a");
    file.dataset<double>("a/x", H5T_NATIVE_DOUBLE, {2}, {1, 2});
    file.dataset<double>("a/longer", H5T_NATIVE_DOUBLE, {3}, {1, 2, 3});
    file.group("b");
    file.dataset<double>("b/fs", H5T_NATIVE_DOUBLE, {1}, {4.0});
    file.dataset<double>("b/x", H5T_NATIVE_DOUBLE, {2}, {1, 2});
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.recordings.size(), 3U);
  EXPECT_EQ(read.recordings[0].sampling_rate(), 8.0);
  EXPECT_EQ(read.recordings[1].source, "a.h5:/a #2");
  EXPECT_EQ(read.recordings[2].sampling_rate(), 4.0);
}

TEST_F(Hdf5Recording, TakesOneLetterAsTheAxisOnlyWhereItRises) {
  {
    OtherFile file(path_);
    file.number("/", "fs", 8.0);
    file.dataset<double>("f", H5T_NATIVE_DOUBLE, {3}, {1.0, 3.0, 2.0});
    file.dataset<double>("t", H5T_NATIVE_DOUBLE, {3}, {5.0, 5.0, 5.0});
    file.dataset<double>("x", H5T_NATIVE_DOUBLE, {3}, {1, 2, 3});
    file.group("sweep");
    file.dataset<double>("sweep/f", H5T_NATIVE_DOUBLE, {3}, {1.0, 2.0, 4.0});
    file.dataset<double>("sweep/x", H5T_NATIVE_DOUBLE, {3}, {1, 2, 3});
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].sampling_rate(), 8.0);
  EXPECT_EQ(read.recordings[0].channels.size(), 3U);
  EXPECT_EQ(read.recordings[0].channel("f").values, (std::vector{1.0, 3.0, 2.0}));
  EXPECT_EQ(read.recordings[1].axis.dimension, kFrequency);
  EXPECT_EQ(read.recordings[1].channels.size(), 1U);
}

TEST_F(Hdf5Recording, SaysWhatToAddWithoutSamplingRate) {
  {
    OtherFile file(path_);
    file.dataset<double>("x", H5T_NATIVE_DOUBLE, {2}, {1, 2});
  }
  EXPECT_EQ(
      message(),
      path_ +
          ":/x: expected a sampling rate, found none. Add the attribute fs [Hz] to the dataset, to "
          "a group that contains it or to the file, or a dataset 'time' [s] next to it. Or give "
          "`rate`.");
}

TEST_F(Hdf5Recording, WarnsOfAnUnknownUnit) {
  {
    OtherFile file(path_);
    file.dataset<double>("x", H5T_NATIVE_DOUBLE, {2}, {1, 2});
    file.number("x", "fs", 1.0);
    file.text("x", "unit", "furlong");
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "unit_unknown");
  EXPECT_FALSE(read.recordings[0].channels[0].dimension);
  EXPECT_EQ(read.recordings[0].channels[0].attributes, (Attributes{{"unit", "furlong"}}));
}

// Some analysers store m/s^2 and write how to show g: only the user knows.
TEST_F(Hdf5Recording, AsksWhatIsLabelledGBesideItsFactor) {
  {
    OtherFile file(path_);
    for (const char* name : {"acc1", "acc2"}) {
      file.dataset<double>(name, H5T_NATIVE_DOUBLE, {2}, {3, -20});
      file.number(name, "fs", 1.0);
      file.text(name, "unit", "g");
    }
    file.number("acc1", "scale", 0.1019716);
    file.number("acc2", "scale", 0.11);
  }
  const Recordings read = read_recordings_hdf5(path_);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "unit_doubtful");
  EXPECT_NE(read.warnings[0].text.find("The largest is 20 m/s^2 if so, 196.1 m/s^2 if in g"),
            std::string::npos)
      << read.warnings[0].text;
  EXPECT_NE(read.warnings[0].text.find("`assume_units acc1=m/s^2` or acc1=g"), std::string::npos);
  EXPECT_FALSE(read.recordings[0].channel("acc1").dimension);
  EXPECT_EQ(read.recordings[0].channel("acc1").values[0], 3.0);
  EXPECT_EQ(read.recordings[0].channel("acc2").values[0], 3 * 9.80665);
}

// Such a dataset would be read as zeros.
TEST_F(Hdf5Recording, RefusesADatasetThatWasNeverWritten) {
  {
    OtherFile file(path_);
    file.dataset<double>("x", H5T_NATIVE_DOUBLE, {5}, {});
    file.number("x", "fs", 1.0);
  }
  EXPECT_NE(message().find(":/x: expected 5 values, found fewer in the file"), std::string::npos)
      << message();
}

TEST_F(Hdf5Recording, RefusesWhatIsNoHdf5File) {
  EXPECT_NE(message().find("No such file"), std::string::npos) << message();
  test::put(path_, "time [s],force [N]\n");
  EXPECT_NE(message().find(path_ + ": expected a whole HDF5 file, found"), std::string::npos)
      << message();
}

TEST_F(Hdf5Recording, ReportsADiskThatIsFull) {
  EXPECT_NE(message_of<FileError>([&] {
              write_recordings_hdf5("/dev/full", std::vector{test::time_recording()});
            }).find("/dev/full"),
            std::string::npos);
}

TEST_F(Hdf5Recording, RefusesFilesCutShort) {
  write_recordings_hdf5(path_, std::vector{test::frequency_recording()});
  test::read_cut(
      path_, 1, [&] { (void)read_recordings_hdf5(path_); }, test::damaged_files(1000));
}

// Each byte of our files that matters is covered by a checksum: a change is found or does no harm.
TEST_F(Hdf5Recording, FindsEveryChange) {
  const std::vector<Recording> written{test::frequency_recording()};
  write_recordings_hdf5(path_, written);
  test::read_changed(
      path_, 2, [&] { test::expect_same(read_recordings_hdf5(path_).recordings, written); },
      test::damaged_files(500));
}

// Here no checksums guard what the library follows, and it crashes on some of the files.
TEST_F(Hdf5Recording, ReadsOrRefusesDamagedFilesOfOthers) {
  {
    OtherFile file(path_);
    file.group("run");
    for (const char* name : {"run/force", "run/acceleration", "run/velocity"}) {
      file.dataset<double>(name, H5T_NATIVE_DOUBLE, {6}, {1, 2, 3, 4, 5, 6});
      file.number(name, "fs", 1000.0);
      file.text(name, "unit_str", "N");
      file.text(name, "serial_number", "0042");
    }
  }
  const auto read = [&] {
    for (const Recording& r : read_recordings_hdf5(path_).recordings) check_recording(r);
  };
  test::read_changed(path_, 3, read, test::damaged_files(500));
}

// A text of any length lies in a heap, which has no checksum in any version of the format: even a
// file that says to be ours, and has checksums else, can crash the library or keep it busy for
// ever.
TEST_F(Hdf5Recording, SurvivesADamagedHeapInAFileOfItsOwnSchema) {
  {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    OtherFile file(path_, access);
    H5Pclose(access);
    file.text("/", "schema", "microslip.recording/1");
    file.group("recording_1");
    file.text("recording_1", "source", "a");
    file.text("recording_1", "axis_unit", "s");
    file.number("recording_1", "start", 0.0);
    file.number("recording_1", "step", 1.0);
    file.dataset<double>("recording_1/channel_1", H5T_NATIVE_DOUBLE, {3}, {1, 2, 3});
    file.text("recording_1/channel_1", "channel_name", "force");
  }
  ASSERT_EQ(read_recordings_hdf5(path_).recordings.size(), 1U);
  const std::string whole = test::get(path_);
  const std::size_t heap = whole.find("GCOL");
  ASSERT_NE(heap, std::string::npos);
  // Of the size of the first text: one value leads out of the heap, the other round in it.
  for (const auto& [at, value] : {std::pair{27, 0xFF}, std::pair{25, 0x01}}) {
    std::string content = whole;
    content[heap + static_cast<std::size_t>(at)] = static_cast<char>(value);
    test::put(path_, content);
    EXPECT_NE(message().find("expected a whole HDF5 file, found one on which the HDF5 library"),
              std::string::npos)
        << at << ": " << message();
  }
}

}  // namespace
}  // namespace microslip::hdf5_recording_test
