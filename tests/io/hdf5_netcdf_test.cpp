// SPDX-License-Identifier: MIT

// Files of netCDF-4, which are of HDF5, and others that say more than names of datasets do: layouts
// as netCDF4-python 1.6.2 and xarray 2023.01 write them (NetCDF Users Guide; CF Conventions 1.10,
// sections 2.5.1, 4.4 and 8.1), and npTDMS 1.7.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/other_hdf5.hpp"
#include "io/support.hpp"
#include "microslip/io/bytes/byte_order.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::hdf5_netcdf_test {
namespace {

using test::message_of;
using test::OtherFile;

constexpr const char* kBare = "This is a netCDF dimension but not a netCDF variable.         3";
const std::vector<double> kValues{1.0, -2.0, 0.5};

class Hdf5NetCdf : public testing::Test {
 protected:
  Recordings read() { return read_recordings_hdf5(path_); }
  std::string message() {
    return message_of<Error>([&] { (void)read(); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.nc");
};

void add_scale(OtherFile& file, const char* name, const std::vector<double>& points,
               const char* unit) {
  file.dataset<double>(name, H5T_NATIVE_DOUBLE, {points.size()}, points);
  file.scale(name, name);
  if (unit != nullptr) file.text(name, "units", unit);
}

void add_over(OtherFile& file, const char* name, const std::string& scale) {
  file.dataset<double>(name, H5T_NATIVE_DOUBLE, {3}, kValues);
  file.scales(name, {scale});
}

// Two dimensions of the same length are two axes.
TEST_F(Hdf5NetCdf, TakesTheAxisThatTheFileNames) {
  {
    OtherFile file(path_);
    add_scale(file, "time", {0, 1e-3, 2e-3}, "s");
    add_scale(file, "time_force", {0, 0.5e-3, 1e-3}, "s");
    add_over(file, "acc", "time");
    add_over(file, "force", "time_force");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 2U);
  EXPECT_EQ(all.recordings[0].channels.size(), 1U);
  EXPECT_EQ(all.recordings[0].channel("acc").values, kValues);
  EXPECT_NEAR(all.recordings[0].sampling_rate(), 1000.0, 1e-9);  // rounding of the points
  EXPECT_EQ(all.recordings[1].channels.size(), 1U);
  EXPECT_NEAR(all.recordings[1].sampling_rate(), 2000.0, 1e-9);
  EXPECT_EQ(all.recordings[1].channel("force").values, kValues);
}

// Values over positions are not over time, though there are as many.
TEST_F(Hdf5NetCdf, LeavesOutWhatIsOverAnotherDimension) {
  {
    OtherFile file(path_);
    add_scale(file, "time", {0, 1e-3, 2e-3}, "s");
    add_scale(file, "position", {0, 0.1, 0.2}, "m");
    add_over(file, "acc", "time");
    add_over(file, "shape", "position");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].channels.size(), 1U);
  ASSERT_EQ(all.warnings.size(), 2U);
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(all.warnings[i].text, path_ + (i == 0 ? ":/shape" : ":/position") +
                                        ": left out, it has 'time', which is that of another "
                                        "dimension");
  }
}

// Groups share the dimensions of the one that they are in; a time may be one beside others.
TEST_F(Hdf5NetCdf, TakesDimensionsOfAGroupAbove) {
  {
    OtherFile file(path_);
    add_scale(file, "t_run", {0, 1, 2}, "milliseconds since 2024-03-12 09:14:00");
    file.group("run");
    file.dataset<double>("run/acc", H5T_NATIVE_DOUBLE, {3}, kValues);
    file.scales("run/acc", {"t_run"});
    file.dataset<double>("sample", H5T_NATIVE_DOUBLE, {3}, {});
    file.scale("sample", kBare);
    file.dataset<double>("time", H5T_NATIVE_DOUBLE, {3}, {0, 0.25, 0.5});
    file.scales("time", {"sample"});
    add_over(file, "force", "sample");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 2U);
  EXPECT_EQ(all.recordings[0].channel("force").values, kValues);
  EXPECT_EQ(all.recordings[0].sampling_rate(), 4.0);
  EXPECT_NEAR(all.recordings[1].sampling_rate(), 1000.0, 1e-9);
  EXPECT_EQ(all.recordings[1].channel("acc").values, kValues);
}

// A dimension without a variable is a dataset that was never written.
TEST_F(Hdf5NetCdf, PassesOverDimensionsWithoutValues) {
  {
    OtherFile file(path_);
    file.number("/", "sample_rate", 8.0);
    file.dataset<float>("samples", H5T_IEEE_F32BE, {3}, {});
    file.scale("samples", kBare);
    file.dataset<float>("one", H5T_IEEE_F32BE, {1}, {});
    file.scale("one", kBare);
    add_over(file, "acc", "samples");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_TRUE(all.warnings.empty());
  EXPECT_EQ(all.recordings[0].sampling_rate(), 8.0);
  EXPECT_EQ(all.recordings[0].channel("acc").values, kValues);
}

TEST_F(Hdf5NetCdf, KnowsTheSamplesOfMoreChannelsThanThose) {
  {
    OtherFile file(path_);
    file.number("/", "sample_rate", 8.0);
    add_scale(file, "time", {0, 1}, "s");
    for (const char* name : {"channels", "time_samples"}) {
      file.dataset<float>(name, H5T_IEEE_F32BE, {name[0] == 'c' ? 3U : 2U}, {});
      file.scale(name, kBare);
    }
    file.dataset<double>("over_time", H5T_NATIVE_DOUBLE, {2, 3}, {1, 2, 3, 10, 20, 30});
    file.scales("over_time", {"time", "channels"});
    file.dataset<double>("over_rate", H5T_NATIVE_DOUBLE, {3, 2}, {1, 10, 2, 20, 3, 30});
    file.scales("over_rate", {"channels", "time_samples"});
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 2U);
  for (const Recording& recording : all.recordings) {
    ASSERT_EQ(recording.channels.size(), 3U);
    EXPECT_EQ(recording.channels[1].values, (std::vector{2.0, 20.0}));
  }
}

// Values are stored as integers; -3 stands for none.
TEST_F(Hdf5NetCdf, UnpacksIntegers) {
  {
    OtherFile file(path_);
    file.dataset<int>("time", H5T_NATIVE_INT, {3}, {10, 11, 12});
    file.numbers("time", "scale_factor", {0.125});
    file.text("time", "units", "s");
    file.dataset<short>("acc", H5T_NATIVE_SHORT, {3}, {4, -8, 2});
    file.numbers("acc", "scale_factor", {0.25});
    file.numbers("acc", "add_offset", {-1.0});
    file.numbers("acc", "_FillValue", {-3});
    file.text("acc", "units", "mm/s^2");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].sampling_rate(), 8.0);
  EXPECT_EQ(all.recordings[0].axis.start, 1.25);
  EXPECT_EQ(all.recordings[0].channel("acc").values, (std::vector{0.0, -3e-3, -0.5e-3}));
  EXPECT_EQ(all.recordings[0].channel("acc").attributes,
            (Attributes{{"applied_scale_factor", "0.25"}, {"applied_add_offset", "-1"}}));
}

// NetCDF Users Guide, valid_range: where it is of the type of scale_factor and that is wider than
// the stored one, it is one of values. 200 is stored for 2, 90 for 0.9, below 1.
TEST_F(Hdf5NetCdf, TakesARangeOfFractionsForOneOfValues) {
  {
    OtherFile file(path_);
    file.number("/", "fs", 8.0);
    for (const char* name : {"inside", "below"}) {
      const short first = name[0] == 'i' ? 200 : 90;
      file.dataset<short>(name, H5T_NATIVE_SHORT, {3}, {first, 200, 300});
      file.numbers(name, "scale_factor", {0.01});
      file.numbers(name, "valid_range", {1.0, 3.0});
    }
  }
  const Recordings all = read();
  EXPECT_EQ(all.recordings.at(0).channel("inside").values, (std::vector{2.0, 2.0, 3.0}));
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_NE(all.warnings[0].text.find("0.9 is below 1, the least of valid_range"),
            std::string::npos)
      << all.warnings[0].text;
}

// Of a file of h5py, valid_max may be the range of a sensor, and scale_factor its sensitivity.
TEST_F(Hdf5NetCdf, DoesNotUnpackFractionsOfOtherFiles) {
  const auto write = [&](bool netcdf) {
    OtherFile file(path_);
    if (netcdf) file.text("/", "Conventions", "CF-1.10");
    file.number("/", "fs", 8.0);
    file.dataset<double>("acc", H5T_NATIVE_DOUBLE, {3}, {1, 2, 4});
    file.number("acc", "scale_factor", 0.5);
    file.number("acc", "valid_max", 3.0 + (netcdf ? 1.0 : 0.0));
  };
  write(false);
  const Recordings plain = read();
  const Channel& acc = plain.recordings.at(0).channel("acc");
  EXPECT_EQ(acc.values, (std::vector{1.0, 2.0, 4.0}));
  EXPECT_EQ(acc.attributes, (Attributes{{"scale_factor", "0.5"}, {"valid_max", "3"}}));
  ASSERT_EQ(plain.warnings.size(), 1U);
  EXPECT_EQ(plain.warnings[0].text,
            path_ +
                ":/acc: scale_factor, valid_max kept as attributes and not applied: the values "
                "are no integers and the file is not netCDF");
  write(true);
  const Recordings packed = read();
  EXPECT_EQ(packed.recordings.at(0).channel("acc").values, (std::vector{0.5, 1.0, 2.0}));
  EXPECT_TRUE(packed.warnings.empty());
}

// xarray stores force(displacement): the dimension is what was measured, not the time.
TEST_F(Hdf5NetCdf, KeepsADisplacementThatIsADimension) {
  {
    OtherFile file(path_);
    add_scale(file, "displacement", {0, 2, 1}, "mm");
    add_over(file, "force", "displacement");
    file.text("force", "units", "N");
  }
  const Recordings all = read_recordings_hdf5(path_, {.allow_untimed = true});
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].channel("force").values, kValues);
  EXPECT_EQ(all.recordings[0].channel("displacement").values, (std::vector{0.0, 2e-3, 1e-3}));
}

// A scale that is no axis is named: one that nothing is over, and positions over another dimension
// than the time. Positions of channels are attributes of these.
TEST_F(Hdf5NetCdf, DropsNoScaleWithoutAWord) {
  {
    OtherFile file(path_);
    add_scale(file, "time", {0, 1e-3, 2e-3}, "s");
    add_scale(file, "time_2", {0, 1e-3}, "s");
    add_scale(file, "position", {0.5, 1}, "m");
    file.dataset<double>("acc", H5T_NATIVE_DOUBLE, {3, 2}, {1, 10, 2, 20, 3, 30});
    file.scales("acc", {"time", "position"});
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  ASSERT_EQ(all.recordings[0].channels.size(), 2U);
  EXPECT_EQ(all.recordings[0].channels[0].attributes, (Attributes{{"position", "0.5 m"}}));
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_EQ(all.warnings[0].text, path_ + ":/time_2: left out, nothing is given over it");
}

// Over a speed and a time, values are over the time; so they are where hours stand first.
TEST_F(Hdf5NetCdf, TakesTheBestOfSeveralScales) {
  {
    OtherFile file(path_);
    add_scale(file, "speed", {100, 200, 300}, "rpm");
    add_scale(file, "seconds", {0, 1, 2}, "s");
    file.dataset<double>("acc", H5T_NATIVE_DOUBLE, {3, 3}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    file.scales("acc", {"speed", "seconds"});
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].axis.dimension, kTime);
  EXPECT_EQ(all.recordings[0].channels.at(0).values, (std::vector{1.0, 2.0, 3.0}));
}

// CF Conventions, section 4.4. Of months it is not known how long they are.
TEST_F(Hdf5NetCdf, LeavesOutWhatIsOverAnUnknownUnitAlone) {
  {
    OtherFile file(path_);
    add_scale(file, "time", {0, 1, 2}, "months since 2024-01-01");
    add_over(file, "slow", "time");
    file.group("run");
    add_scale(file, "run/time", {0, 0.5, 1}, "days since 2024-01-01");
    add_over(file, "run/acc", "run/time");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].axis.step, 43200.0);  // s, half a day
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_EQ(
      all.warnings[0].text,
      path_ + ":/slow: left out, it has 'time' in 'months since 2024-01-01', an unknown unit");
}

// A ramp of force called f is no frequency, a torque called t no time.
TEST_F(Hdf5NetCdf, TakesNoForceForAFrequency) {
  {
    OtherFile file(path_);
    file.number("/", "fs", 8.0);
    for (const char* name : {"f", "t"}) {
      file.dataset<double>(name, H5T_NATIVE_DOUBLE, {3}, {0, 1, 2});
      file.text(name, "units", name[0] == 'f' ? "N" : "N m");
    }
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].axis.dimension, kTime);
  EXPECT_EQ(all.recordings[0].channel("f").dimension, kForce);
  EXPECT_EQ(all.recordings[0].channels.size(), 2U);
}

// What was never written, or is masked, has a value that stands for none. The fill value of the
// dataset itself holds where no attribute names one; 0 does not, HDF5 has it by itself.
TEST_F(Hdf5NetCdf, LeavesOutChannelsWithMissingValues) {
  constexpr float kFill = 9.96921e36F;  // NC_FILL_FLOAT
  {
    OtherFile file(path_);
    file.number("/", "fs", 8.0);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_fill_value(creation, H5T_NATIVE_FLOAT, &kFill);
    file.dataset<float>("unwritten", H5T_NATIVE_FLOAT, {3}, {1, kFill, kFill}, creation);
    constexpr float kZero = 0.0F;
    H5Pset_fill_value(creation, H5T_NATIVE_FLOAT, &kZero);
    file.dataset<float>("zeros", H5T_NATIVE_FLOAT, {3}, {0, 1, 0}, creation);
    H5Pclose(creation);
    file.dataset<float>("masked", H5T_NATIVE_FLOAT, {3}, {1, 1e20F, 2});
    file.numbers("masked", "missing_value", {1e20, 1e300});  // as a double, and beyond single ones
    file.dataset<short>("out", H5T_NATIVE_SHORT, {3}, {1, 200, 2});
    file.numbers("out", "valid_range", {-100, 100});
    file.dataset<double>("nan", H5T_NATIVE_DOUBLE, {3}, {1, std::nan(""), 2});
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  const Recording& recording = all.recordings[0];
  ASSERT_EQ(recording.channels.size(), 1U);
  EXPECT_EQ(recording.channel("zeros").values, (std::vector{0.0, 1.0, 0.0}));
  ASSERT_EQ(all.warnings.size(), 4U);
  EXPECT_EQ(all.warnings[3].code, "channel_left_out");
  EXPECT_EQ(message_of<InputError>([&] { (void)recording.channel("unwritten"); }),
            "a.nc: channel 'unwritten' is left out; must have a value at each point; 2 of its 3 "
            "values are missing or not finite, the first at point 2: " +
                fmt::format("{}", double{kFill}) + " is the fill value of the dataset");
}

// netcdf.h 4.9: NC_FILL_DOUBLE, NC_FILL_FLOAT, NC_FILL_SHORT and so on; of bytes there is none. A
// file that was made with NC_NOFILL and copied has them without an attribute.
TEST_F(Hdf5NetCdf, KnowsTheFillValuesOfNetCdf) {
  for (const bool netcdf : {true, false}) {
    {
      OtherFile file(path_);
      if (netcdf) file.text("/", "_NCProperties", "version=2,netcdf=4.9.0");
      file.number("/", "fs", 8.0);
      file.dataset<double>("double", H5T_NATIVE_DOUBLE, {3}, {1, 9.9692099683868690e+36, 2});
      file.dataset<float>("float", H5T_NATIVE_FLOAT, {3}, {1, 9.96921e36F, 2});
      file.dataset<short>("short", H5T_NATIVE_SHORT, {3}, {1, -32767, 2});
      file.dataset<int>("int", H5T_NATIVE_INT, {3}, {1, -2147483647, 2});
      file.dataset<std::int64_t>("int64", H5T_NATIVE_INT64, {3}, {1, INT64_MIN + 2, 2});
      file.dataset<unsigned short>("ushort", H5T_NATIVE_USHORT, {3}, {1, 65535, 2});
      file.dataset<unsigned>("uint", H5T_NATIVE_UINT, {3}, {1, 4294967295U, 2});
      file.dataset<std::uint64_t>("uint64", H5T_NATIVE_UINT64, {3}, {1, UINT64_MAX - 1, 2});
      file.dataset<signed char>("byte", H5T_NATIVE_SCHAR, {3}, {1, -127, 2});
      file.dataset<short>("own", H5T_NATIVE_SHORT, {3}, {1, -32767, 2});
      file.number("own", "_FillValue", 5.0);
    }
    EXPECT_EQ(read().recordings.at(0).channels.size(), netcdf ? 2U : 10U);
  }
}

TEST_F(Hdf5NetCdf, RefusesValuesOfWhichNoneIsWhole) {
  {
    OtherFile file(path_);
    file.dataset<short>("x", H5T_NATIVE_SHORT, {3}, {1, -3, -3});
    file.number("x", "fs", 8.0);
    file.number("x", "_FillValue", -3);
  }
  EXPECT_NE(message().find("channel 'x', point 2 is without value: -3 is the _FillValue; must be "
                           "finite; 2 of 3 values are missing or not finite. If it is a value"),
            std::string::npos)
      << message();
}

// npTDMS' as_hdf() keeps the names of National Instruments.
TEST_F(Hdf5NetCdf, ReadsWhatNpTdmsExports) {
  {
    OtherFile file(path_);
    file.group("Group");
    file.dataset<float>("Group/Gap", H5T_NATIVE_FLOAT, {3}, {1, 2, 4});
    file.number("Group/Gap", "wf_increment", 0.5);
    file.number("Group/Gap", "wf_start_offset", 3.0);
    file.text("Group/Gap", "unit_string", "um");
    file.text("Group/Gap", "NI_UnitDescription", "um");
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_EQ(all.recordings[0].axis.step, 0.5);
  EXPECT_EQ(all.recordings[0].axis.start, 3.0);
  EXPECT_EQ(all.recordings[0].channel("Gap").values, (std::vector{1e-6, 2e-6, 4e-6}));
}

// Times that a logger keeps in single precision are off by half a unit in the last place.
TEST_F(Hdf5NetCdf, TakesTimesInSinglePrecision) {
  std::vector<float> times;
  for (int i = 0; i < 5000; ++i) times.push_back(static_cast<float>(100.0 + 1e-3 * i));
  {
    OtherFile file(path_);
    file.dataset<float>("time", H5T_NATIVE_FLOAT, {times.size()}, times);
    file.dataset<float>("acc", H5T_NATIVE_FLOAT, {times.size()}, times);
    times[7] += 4e-5F;  // five units in the last place
    file.group("uneven");
    file.dataset<float>("uneven/time", H5T_NATIVE_FLOAT, {times.size()}, times);
    file.dataset<float>("uneven/acc", H5T_NATIVE_FLOAT, {times.size()}, times);
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 2U);
  EXPECT_TRUE(all.recordings[0].axis.even());
  EXPECT_EQ(all.recordings[0].sampling_rate(), 1000.0);
  EXPECT_FALSE(all.recordings[1].axis.even());
}

TEST_F(Hdf5NetCdf, TellsTimesOfAnotherLength) {
  {
    OtherFile file(path_);
    file.dataset<double>("time", H5T_NATIVE_DOUBLE, {2}, {0, 1});
    file.dataset<double>("acc", H5T_NATIVE_DOUBLE, {3}, kValues);
  }
  EXPECT_NE(message().find("expected a sampling rate, found 'time' of 2 values for its 3"),
            std::string::npos)
      << message();
}

/// A row of a table, as h5py writes a structured array and PyTables its tables: a field of each
/// kind, times, forces with a unit in the name, lists of accelerations, and text.
struct TableRow {
  double time;
  float force;
  double accelerations[2];
  char note[4];
};

hid_t table_type(const char* time) {
  const hsize_t two = 2;
  const hid_t list = H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &two);
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 4);
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(TableRow));
  H5Tinsert(type, time, HOFFSET(TableRow, time), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "force [kN]", HOFFSET(TableRow, force), H5T_NATIVE_FLOAT);
  H5Tinsert(type, "acc", HOFFSET(TableRow, accelerations), list);
  H5Tinsert(type, "note", HOFFSET(TableRow, note), text);
  H5Tclose(text);
  H5Tclose(list);
  return type;
}

const std::vector<TableRow> kRows{
    {0.0, 1.0F, {0.1, 10.0}, "a"}, {0.5, 2.0F, {0.2, 20.0}, "b"}, {1.0, -3.0F, {0.3, 30.0}, "c"}};

// pandas and PyTables store a table as one dataset.
TEST_F(Hdf5NetCdf, TakesTheFieldsOfATable) {
  {
    OtherFile file(path_);
    const hid_t type = table_type("time");
    file.dataset<TableRow>("data", type, {3}, kRows);
    file.text("data", "acc_unit", "mm/s^2");
    H5Tclose(type);
  }
  const Recordings all = read();
  ASSERT_EQ(all.recordings.size(), 1U);
  const Recording& recording = all.recordings[0];
  EXPECT_EQ(recording.source, "a.nc:/data");
  EXPECT_EQ(recording.sampling_rate(), 2.0);
  ASSERT_EQ(recording.channels.size(), 3U);
  EXPECT_EQ(recording.channel("force").values, (std::vector<double>{1000.0, 2000.0, -3000.0}));
  EXPECT_EQ(recording.channel("force").dimension, kForce);
  const std::vector<double>& second = recording.channel("acc_2").values;
  ASSERT_EQ(second.size(), 3U);
  EXPECT_NEAR(second[2], 0.03, 1e-17);  // 30 mm/s²
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_NE(all.warnings[0].text.find("'note': left out, its values are no real numbers"),
            std::string::npos);
  ASSERT_EQ(recording.left_out.size(), 1U);
  EXPECT_EQ(recording.left_out[0].name, "note");
  EXPECT_EQ(recording.left_out[0].reason, "its values are no real numbers");
}

TEST_F(Hdf5NetCdf, TakesTheRateOfATableFromItsAttributes) {
  {
    OtherFile file(path_);
    const hid_t type = table_type("index");
    file.dataset<TableRow>("data", type, {3}, kRows);
    file.number("data", "fs", 1000.0);
    H5Tclose(type);
  }
  EXPECT_EQ(read().recordings.at(0).sampling_rate(), 1000.0);
  EXPECT_EQ(read().recordings.at(0).channels.size(), 4U);
}

struct TimedRow {
  std::int64_t time;
  double force;
};

/// A table 'data' of three rows.
void put_timed_rows(OtherFile& file, const std::vector<TimedRow>& rows) {
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(TimedRow));
  H5Tinsert(type, "time", HOFFSET(TimedRow, time), H5T_NATIVE_INT64);
  H5Tinsert(type, "force", HOFFSET(TimedRow, force), H5T_NATIVE_DOUBLE);
  file.dataset<TimedRow>("data", type, {3}, rows);
  H5Tclose(type);
}

// pandas 1.5: whole nanoseconds, which doubles do not hold, by the attribute NAME_dtype, of an
// index NAME_kind.
TEST_F(Hdf5NetCdf, TakesDatesOfATable) {
  for (const char* attribute : {"time_dtype", "time_kind"}) {
    {
      OtherFile file(path_);
      constexpr std::int64_t kStart = 1704067200000000123;  // 2024
      put_timed_rows(file, {{kStart, 1.0}, {kStart + 1'000'000, 2.0}, {kStart + 2'000'000, 3.0}});
      file.text("data", attribute, "datetime64");
      file.text("data", "units", "kN");  // of one field of two
    }
    const Recordings all = read();
    EXPECT_EQ(all.recordings.at(0).axis.start, 0.0);
    EXPECT_NEAR(all.recordings.at(0).sampling_rate(), 1000.0, 1e-9);
    EXPECT_FALSE(all.recordings.at(0).channel("force").dimension);
    ASSERT_EQ(all.warnings.size(), 1U) << attribute;
    EXPECT_EQ(all.warnings[0].code, "units_not_assigned");
  }
}

// Of a file that has times for some of its datasets.
TEST_F(Hdf5NetCdf, TakesAStatedRateForWhatNothingPlaces) {
  {
    OtherFile file(path_);
    file.group("a");
    file.dataset<double>("a/force", H5T_NATIVE_DOUBLE, {3}, kValues);
    file.number("a", "fs", 100.0);
    file.group("b");
    file.dataset<double>("b/acc", H5T_NATIVE_DOUBLE, {3}, kValues);
    const hid_t type = table_type("index");
    file.dataset<TableRow>("data", type, {3}, kRows);
    H5Tclose(type);
  }
  const Recordings all = read_recordings(path_, {.rate = 0.1});
  ASSERT_EQ(all.recordings.size(), 3U);
  for (const Recording& recording : all.recordings) {
    EXPECT_EQ(recording.axis.step, recording.source == "a.nc:/a" ? 0.01 : 10.0);
  }
  EXPECT_EQ(read().recordings.size(), 1U) << "without a rate";
  EXPECT_EQ(read_recordings_hdf5(path_, {.allow_untimed = true}).recordings.size(), 1U);
}

TEST_F(Hdf5NetCdf, TakesTimesBesideATable) {
  {
    OtherFile file(path_);
    const hid_t type = table_type("index");
    file.dataset<TableRow>("data", type, {3}, kRows);
    file.dataset<double>("time", H5T_NATIVE_DOUBLE, {3}, {0.0, 0.5, 1.0});
    H5Tclose(type);
  }
  EXPECT_EQ(read().recordings.at(0).sampling_rate(), 2.0);
}

// PyTables 3: Time64Col has seconds and microseconds in a word of eight bytes (typeconv.c,
// conv_float64_timeval32), Time32Col whole seconds.
TEST_F(Hdf5NetCdf, TakesTheTimesOfPyTables) {
  struct Row {
    std::int64_t time;
    double force;
    std::int32_t second;
  };
  const auto pair = [](std::int64_t seconds, std::int64_t microseconds) {
    return (seconds << 32) | microseconds;
  };
  for (const bool pairs : {true, false}) {
    {
      OtherFile file(path_);
      const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
      H5Tinsert(type, pairs ? "time" : "other", HOFFSET(Row, time), H5T_UNIX_D64LE);
      H5Tinsert(type, "force", HOFFSET(Row, force), H5T_NATIVE_DOUBLE);
      H5Tinsert(type, pairs ? "other" : "time", HOFFSET(Row, second), H5T_UNIX_D32LE);
      constexpr std::int64_t kStart = 1704067200;  // 2024
      file.dataset<Row>("data", type, {3},
                        {{pair(kStart, 999'000), 1.0, 1704067200},
                         {pair(kStart + 1, 0), 2.0, 1704067202},
                         {pair(kStart + 1, 1'000), 3.0, 1704067204}});
      H5Tclose(type);
    }
    const Recordings all = read();
    EXPECT_EQ(all.recordings.at(0).axis.start, 0.0);
    EXPECT_NEAR(all.recordings.at(0).axis.step, pairs ? 1e-3 : 2.0, 1e-15);
    EXPECT_EQ(all.recordings.at(0).channel("force").values, (std::vector{1.0, 2.0, 3.0}));
    EXPECT_EQ(all.recordings.at(0).channel("other").dimension, kTime);
    EXPECT_TRUE(all.warnings.empty());
  }
}

// As PyTables writes them on a big-endian machine.
TEST_F(Hdf5NetCdf, TakesTimesInTheOtherByteOrder) {
  struct Row {
    std::int64_t time;
    double force;
    std::int32_t second;
  };
  const auto pair = [](std::int64_t microseconds) {
    return byte_swapped((std::int64_t{1704067200} << 32) + microseconds);
  };
  const auto second = [](std::int32_t seconds) { return byte_swapped(1704067200 + seconds); };
  for (const bool table : {true, false}) {
    for (const bool pairs : {true, false}) {
      {
        OtherFile file(path_);
        const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
        H5Tinsert(type, pairs ? "time" : "other", HOFFSET(Row, time), H5T_UNIX_D64BE);
        H5Tinsert(type, "force", HOFFSET(Row, force), H5T_NATIVE_DOUBLE);
        H5Tinsert(type, pairs ? "other" : "time", HOFFSET(Row, second), H5T_UNIX_D32BE);
        if (table) {
          file.dataset<Row>("data", type, {3},
                            {{pair(0), 1.0, second(0)},
                             {pair(1000), 2.0, second(2)},
                             {pair(2000), 3.0, second(4)}});
        } else if (pairs) {
          file.dataset<std::int64_t>("time", H5T_UNIX_D64BE, {3},
                                     {pair(0), pair(1000), pair(2000)});
        } else {
          file.dataset<std::int32_t>("time", H5T_UNIX_D32BE, {3},
                                     {second(0), second(2), second(4)});
        }
        if (!table) file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
        H5Tclose(type);
      }
      const Recording recording = read().recordings.at(0);
      EXPECT_EQ(recording.axis.start, 0.0);
      EXPECT_NEAR(recording.axis.step, pairs ? 1e-3 : 2.0, 1e-15) << table;
    }
  }
}

// Arrays of PyTables, of Time64Col and Time32Col: 1704067200.25 s and 0.5 s each later.
TEST_F(Hdf5NetCdf, TakesDatasetsOfTimes) {
  constexpr std::int64_t kStart = std::int64_t{1704067200} << 32;
  for (const bool has_force : {true, false}) {
    {
      OtherFile file(path_);
      file.dataset<std::int64_t>(
          "time", H5T_UNIX_D64LE, {3},
          {kStart + 250000, kStart + 750000, kStart + (std::int64_t{1} << 32) + 250000});
      if (has_force) {
        file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
        file.dataset<std::int32_t>("clock", H5T_UNIX_D32LE, {3},
                                   {1704067200, 1704067201, 1704067203});
      }
    }
    if (!has_force) {
      EXPECT_NE(message().find("expected a dataset of two numbers or more, found 'time' alone"),
                std::string::npos)
          << message();
      continue;
    }
    const Recording recording = read().recordings.at(0);
    EXPECT_EQ(recording.axis.step, 0.5);
    EXPECT_EQ(recording.axis.start, 0.0);
    EXPECT_EQ(recording.channel("clock").values, (std::vector{0.0, 1.0, 3.0}));
    EXPECT_EQ(recording.channel("clock").dimension, kTime);
  }
}

// h5py has no type of dates: users write numpy.datetime64 as int64.
TEST_F(Hdf5NetCdf, TakesWholeNumbersSince1970) {
  constexpr std::int64_t kNanoseconds = 1704067200000000123;
  const auto of_table = [&](std::int64_t first, std::int64_t step, const char* unit) {
    OtherFile file(path_);
    put_timed_rows(file, {{first, 1.0}, {first + step, 2.0}, {first + 2 * step, 3.0}});
    if (unit != nullptr) file.text("data", "time_unit", unit);
  };
  const auto of_dataset = [&](std::int64_t first, std::int64_t step, const char* unit) {
    OtherFile file(path_);
    file.dataset<std::int64_t>("time", H5T_NATIVE_INT64, {3},
                               {first, first + step, first + 2 * step});
    if (unit != nullptr) file.text("time", "units", unit);
    file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
  };
  const auto expect = [&](double step, std::size_t warnings) {
    const Recordings all = read();
    EXPECT_NEAR(all.recordings.at(0).axis.step, step, 1e-12 * step);
    ASSERT_EQ(all.warnings.size(), warnings);
    if (warnings > 0) {
      EXPECT_EQ(all.warnings[0].code, "times_since_1970");
    }
  };
  for (const bool table : {true, false}) {
    const auto write = [&](std::int64_t first, std::int64_t step, const char* unit) {
      table ? of_table(first, step, unit) : of_dataset(first, step, unit);
    };
    write(kNanoseconds, 19531, nullptr);  // 51.2 kHz; doubles are 256 ns apart there
    expect(19531e-9, 1);
    write(kNanoseconds / 1000, 500, nullptr);
    expect(500e-6, 1);
    write(kNanoseconds / 1'000'000, 1, nullptr);
    expect(1e-3, 1);
    write(kNanoseconds, 19531, "ns");
    expect(19531e-9, 0);
    write(kNanoseconds / 1000, 20, "us");  // doubles are 0.2 µs apart there, as seconds
    expect(20e-6, 0);
    write(1704067200, 1, nullptr);
    expect(1.0, 0);
    write(0, 2, nullptr);
    expect(2.0, 0);
  }
}

TEST_F(Hdf5NetCdf, TakesWholeNumbersInAUnitOfTimeOfATable) {
  struct Row {
    std::int64_t time;
    std::int64_t count;
  };
  constexpr std::int64_t kStart = 1704067200000000123;  // doubles are 256 apart there
  for (const char* name : {"time [ns]", "elapsed [ns]"}) {
    {
      OtherFile file(path_);
      const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
      H5Tinsert(type, name, HOFFSET(Row, time), H5T_NATIVE_INT64);
      H5Tinsert(type, "count", HOFFSET(Row, count), H5T_NATIVE_INT64);
      file.dataset<Row>("data", type, {3}, {{kStart, 3}, {kStart + 2000, 1}, {kStart + 4000, 2}});
      H5Tclose(type);
    }
    const Recordings all = read();
    EXPECT_NEAR(all.recordings.at(0).axis.step, 2000e-9, 1e-18);
    EXPECT_TRUE(all.recordings[0].axis.even());
    EXPECT_EQ(all.recordings[0].channel("count").values, (std::vector{3.0, 1.0, 2.0}));
  }
}

// Numbers from 2⁶³ on, which 64 bits with a sign do not hold.
TEST_F(Hdf5NetCdf, TakesTimesWithoutASignFromTheFirstOn) {
  struct Row {
    std::uint64_t time;
    double force;
  };
  constexpr std::uint64_t kHalf = std::uint64_t{1} << 63U;
  for (const std::uint64_t first : {kHalf - 1000, kHalf, UINT64_MAX - 2000}) {
    for (const bool table : {true, false}) {
      {
        OtherFile file(path_);
        const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
        H5Tinsert(type, "time [ns]", HOFFSET(Row, time), H5T_NATIVE_UINT64);
        H5Tinsert(type, "force", HOFFSET(Row, force), H5T_NATIVE_DOUBLE);
        if (table) {
          file.dataset<Row>("data", type, {3},
                            {{first, 1.0}, {first + 1000, 2.0}, {first + 2000, 3.0}});
        } else {
          file.dataset<std::uint64_t>("time", H5T_NATIVE_UINT64, {3},
                                      {first, first + 1000, first + 2000});
          file.text("time", "units", "ns");
          file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
        }
        H5Tclose(type);
      }
      const Recordings all = read();
      EXPECT_EQ(all.recordings.at(0).axis.start, 0.0) << first;
      EXPECT_NEAR(all.recordings[0].axis.step, 1e-6, 1e-18) << first;
    }
  }
}

// Nanoseconds from the first on, for instance.
TEST_F(Hdf5NetCdf, WarnsOfLongStepsWithoutAUnit) {
  for (const char* unit : {"", "ns"}) {
    {
      OtherFile file(path_);
      file.dataset<std::int64_t>("time", H5T_NATIVE_INT64, {3}, {0, 1000, 2000});
      file.text("time", "units", unit);
      file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
    }
    const Recordings all = read();
    ASSERT_EQ(all.warnings.size(), *unit == '\0' ? 1U : 0U);
    if (!all.warnings.empty()) {
      EXPECT_EQ(all.warnings[0].code, "times_in_seconds");
    }
  }
}

// Whole milliseconds at 1.6 kHz, of which some are equal.
TEST_F(Hdf5NetCdf, TakesTheRateBesideAClockThatRounds) {
  constexpr std::size_t kCount = 400;
  std::vector<double> times;
  std::vector<double> force;
  for (std::size_t i = 0; i < kCount; ++i) {
    times.push_back(std::round(static_cast<double>(i) / 1.6));
    force.push_back(static_cast<double>(i % 7));
  }
  for (const bool in_file : {true, false}) {
    {
      OtherFile file(path_);
      file.dataset<double>("time", H5T_NATIVE_DOUBLE, {kCount}, times);
      file.text("time", "units", "ms");
      file.dataset<double>("force", H5T_NATIVE_DOUBLE, {kCount}, force);
      if (in_file) file.number("/", "fs", 1600.0);
    }
    RecordingReadOptions options;
    if (!in_file) options.rate = 1600.0;
    const Recordings all = read_recordings_hdf5(path_, options);
    EXPECT_EQ(all.recordings.at(0).axis.step, 1.0 / 1600.0);
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_EQ(all.rate_used, !in_file);
  }
}

TEST_F(Hdf5NetCdf, AddsTheOffsetOfWholeTimes) {
  {
    OtherFile file(path_);
    file.dataset<std::int64_t>("time", H5T_NATIVE_INT64, {3}, {0, 1, 2});
    file.number("time", "add_offset", 100.0);
    file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
  }
  EXPECT_EQ(read().recordings.at(0).axis.start, 100.0);
}

TEST_F(Hdf5NetCdf, TakesAFieldInAUnitOfTimeForTheAxis) {
  {
    OtherFile file(path_);
    const hid_t type = table_type("elapsed [ms]");
    file.dataset<TableRow>("data", type, {3}, kRows);
    H5Tclose(type);
  }
  EXPECT_NEAR(read().recordings.at(0).axis.step, 0.5e-3, 1e-18);
  EXPECT_EQ(read().recordings.at(0).channels.size(), 3U);
  {
    OtherFile file(path_);
    const hid_t type = table_type("delay [ms]");
    file.dataset<TableRow>("data", type, {3}, {kRows[0], kRows[2], kRows[1]});
    file.number("data", "fs", 8.0);
    H5Tclose(type);
  }
  EXPECT_EQ(read().recordings.at(0).channels.size(), 4U) << "it does not rise";
}

// A table of a frequency response with what else is known at each frequency.
TEST_F(Hdf5NetCdf, TakesTheFrequencyOfATableBesideTimesThatRise) {
  struct Row {
    double first;
    double second;
    double force;
  };
  const auto read = [&](const char* first, const char* second) {
    {
      OtherFile file(path_);
      const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
      H5Tinsert(type, first, HOFFSET(Row, first), H5T_NATIVE_DOUBLE);
      H5Tinsert(type, second, HOFFSET(Row, second), H5T_NATIVE_DOUBLE);
      H5Tinsert(type, "force [N]", HOFFSET(Row, force), H5T_NATIVE_DOUBLE);
      file.dataset<Row>("data", type, {3}, {{1.0, 10.0, 3.0}, {2.0, 20.0, 1.0}, {3.0, 30.0, 2.0}});
      H5Tclose(type);
    }
    return this->read();
  };
  const auto warnings = [&](const char* first, const char* second, const Axis& axis) {
    const Recordings all = read(first, second);
    EXPECT_EQ(all.recordings.at(0).axis, axis) << first << ' ' << second;
    std::string codes;
    for (const Warning& warning : all.warnings) codes += warning.code;
    return codes;
  };
  const Axis frequency{kFrequency, 10.0, 10.0, {}};
  EXPECT_EQ(warnings("group delay [s]", "frequency [Hz]", frequency), "");
  for (const char* span : {"tau [s]", "T60 [s]", "decay time [s]", "Rise time [s]"}) {
    EXPECT_EQ(warnings(span, "frequency [Hz]", frequency), "");
    EXPECT_EQ(warnings(span, "Drive freq [Hz]", frequency), "");
  }
  EXPECT_EQ(warnings("settling [s]", "Frequency [Hz]", frequency), "axis_chosen");
  EXPECT_EQ(warnings("settling [s]", "Drive freq [Hz]", frequency), "axis_chosen");
  const Axis time{kTime, 1.0, 1.0, {}};
  EXPECT_EQ(warnings("elapsed [s]", "frequency [Hz]", time), "");
  EXPECT_EQ(warnings("time [s]", "frequency [Hz]", time), "");
  EXPECT_EQ(warnings("tau [s]", "speed [Hz]", time), "");
  EXPECT_EQ(warnings("delay [s]", "coherence", time), "") << "there is nothing else";
}

TEST_F(Hdf5NetCdf, NamesWhyATableIsNoRecording) {
  const auto fault = [&](std::vector<hsize_t> sizes, bool numbers) {
    {
      OtherFile file(path_);
      file.number("/", "fs", 8.0);
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, 8);
      const hid_t type = H5Tcreate(H5T_COMPOUND, 8);
      H5Tinsert(type, "time", 0, numbers ? H5T_NATIVE_DOUBLE : text);
      file.dataset<double>("data", type, sizes, {0.0, 1.0, 2.0, 3.0});
      H5Tclose(type);
      H5Tclose(text);
    }
    const std::string text = message();
    return text.substr(std::min(text.find("a.nc"), text.size()));
  };
  const std::string expected = "a.nc:/data: expected a dataset or a table of numbers, found ";
  const std::string remedy = ". Store each column as a dataset of its own; pandas: to_csv.";
  EXPECT_EQ(fault({4}, false), expected + "a table of which no field has real numbers" + remedy);
  EXPECT_EQ(fault({4}, true), expected + "a table of times alone" + remedy);
  EXPECT_EQ(fault({1}, true), expected + "a table of one row" + remedy);
  EXPECT_EQ(fault({2, 2}, true), expected + "a table of 2 dimensions" + remedy);
}

TEST_F(Hdf5NetCdf, NamesTablesWithoutTimes) {
  {
    OtherFile file(path_);
    const hid_t type = table_type("index");
    file.dataset<TableRow>("data", type, {3}, kRows);
    H5Tclose(type);
  }
  EXPECT_NE(message().find(":/data: expected a sampling rate"), std::string::npos) << message();
}

// lzf, Blosc and bzip2 are plugins.
TEST_F(Hdf5NetCdf, NamesTheFilterThatIsMissing) {
  {
    OtherFile file(path_);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 3;
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_filter(creation, 32000, H5Z_FLAG_OPTIONAL, 0, nullptr);  // of no name here
    file.dataset<double>("x", H5T_NATIVE_DOUBLE, {3}, kValues, creation);
    H5Pclose(creation);
    file.number("x", "fs", 8.0);
  }
  EXPECT_NE(message().find("found the filter 32000"), std::string::npos) << message();
  EXPECT_NE(message().find("h5repack -f GZIP=4"), std::string::npos) << message();
}

// The increment of a load, or of anything else.
TEST_F(Hdf5NetCdf, TakesNoIncrementForAStep) {
  {
    OtherFile file(path_);
    file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
    file.number("/", "increment", 0.5);
  }
  EXPECT_NE(message().find("expected a sampling rate"), std::string::npos) << message();
}

// The frequencies of a drive over time may fall.
TEST_F(Hdf5NetCdf, TakesTheRateBesideAFrequencyThatFalls) {
  {
    OtherFile file(path_);
    file.dataset<double>("frequency", H5T_NATIVE_DOUBLE, {3}, {1.0, 3.0, 2.0});
    file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
    file.number("/", "fs", 1000.0);
  }
  const Recordings all = read();
  EXPECT_EQ(all.recordings.at(0).sampling_rate(), 1000.0);
  EXPECT_EQ(all.recordings.at(0).channels.size(), 2U);
}

// A frequency response keeps the rate at which it was sampled; a chirp may have both as well.
TEST_F(Hdf5NetCdf, SaysThatAFrequencyIsTheAxisBesideARate) {
  struct Row {
    double frequency;
    double force;
  };
  for (const char* place : {"/", "force", "data"}) {
    {
      OtherFile file(path_);
      if (std::string(place) == "data") {
        const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
        H5Tinsert(type, "frequency", HOFFSET(Row, frequency), H5T_NATIVE_DOUBLE);
        H5Tinsert(type, "force", HOFFSET(Row, force), H5T_NATIVE_DOUBLE);
        file.dataset<Row>("data", type, {3}, {{1.0, 3.0}, {2.0, 1.0}, {3.0, 2.0}});
        H5Tclose(type);
      } else {
        file.dataset<double>("frequency", H5T_NATIVE_DOUBLE, {3}, {1.0, 2.0, 3.0});
        file.dataset<double>("force", H5T_NATIVE_DOUBLE, {3}, kValues);
      }
      file.number(place, "fs", 1000.0);
    }
    const Recordings all = read();
    EXPECT_EQ(all.recordings.at(0).axis, (Axis{kFrequency, 1.0, 1.0, {}})) << place;
    ASSERT_EQ(all.warnings.size(), 1U) << place;
    EXPECT_EQ(all.warnings[0].code, "axis_chosen");
    EXPECT_NE(all.warnings[0].text.find("'frequency' is taken for the axis, though the file states "
                                        "1000 Hz"),
              std::string::npos)
        << all.warnings[0].text;
  }
}

// As h5py writes lists of names and units beside a matrix of samples and channels.
TEST_F(Hdf5NetCdf, TakesListsOfTheChannelsOfAMatrix) {
  const auto write = [&](const std::vector<const char*>& units) {
    OtherFile file(path_);
    file.dataset<double>("data", H5T_NATIVE_DOUBLE, {3, 2}, {1, 10, 2, 20, 3, 30});
    file.number("data", "sampling_rate", 1000.0);
    file.texts("data", "units", units);
    file.texts("data", "channels", {"load cell", "gap"});
  };
  write({"kN", "mm"});
  const Recordings all = read();
  EXPECT_TRUE(all.warnings.empty());
  EXPECT_EQ(all.recordings.at(0).channel("load cell").values, (std::vector{1e3, 2e3, 3e3}));
  EXPECT_EQ(all.recordings[0].channel("gap").values, (std::vector{10e-3, 20e-3, 30e-3}));
  EXPECT_EQ(all.recordings[0].channel("gap").dimension, kLength);
  write({"s", "kN", "mm"});
  const Recordings others = read();
  ASSERT_EQ(others.warnings.size(), 1U);
  EXPECT_EQ(others.warnings[0].code, "list_not_applied");
  EXPECT_FALSE(others.recordings.at(0).channel("gap").dimension);
}

}  // namespace
}  // namespace microslip::hdf5_netcdf_test
