// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/stepped_sine_file.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/rig/reduction/reduction.hpp"

namespace microslip::stepped_sine_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

const std::string kExamples = MICROSLIP_EXAMPLES;

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos)
        << "'" << message << "' has no '" << part << "'";
  }
}

// ---- Text. ----

constexpr const char* kTable =
    "# sweep 3\nphase [deg],frequency [Hz],force [mN],acceleration [g],note\n"
    "-10,80,500,1,a\n-90,80.5,250,2,b\n";

TEST(SteppedSineFile, ReadsATextInAnyUnitsAndOrder) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweep.csv");
  test::put(path, kTable);
  EXPECT_TRUE(is_stepped_sine(path));
  const std::vector<SteppedSine> sweeps = read_stepped_sines(path);
  ASSERT_EQ(sweeps.size(), 1U);
  EXPECT_EQ(sweeps[0].source, path);
  EXPECT_EQ(sweeps[0].frequency, (Numbers{80.0, 80.5}));
  EXPECT_EQ(sweeps[0].force, (Numbers{0.5, 0.25}));
  EXPECT_EQ(sweeps[0].acceleration, (Numbers{9.80665, 19.6133}));
  EXPECT_DOUBLE_EQ(sweeps[0].phase[0], -std::numbers::pi / 18.0);
  EXPECT_DOUBLE_EQ(sweeps[0].phase[1], -std::numbers::pi / 2.0);
}

TEST(SteppedSineFile, IsToldFromOtherFiles) {
  const test::TemporaryFolder folder;
  const auto is_one = [&](const std::string& content) {
    test::put(folder.file("x.csv"), content);
    return is_stepped_sine(folder.file("x.csv"));
  };
  EXPECT_TRUE(is_one(kTable));
  EXPECT_FALSE(is_one("time [s],force [N],acceleration [m/s^2],phase [rad]\n0,1,1,1\n"));
  EXPECT_FALSE(is_one("frequency [Hz],force [N],acc1 [m/s^2]\n1,1,1\n"));
  EXPECT_FALSE(is_one("displacement [m],force [N],frequency [Hz],damping_ratio [1]\n1,1,1,1\n"));
  EXPECT_FALSE(is_one(""));
  EXPECT_FALSE(is_one(std::string("\x89HDF\r\n\x1A\n\0\0", 10)));
  EXPECT_FALSE(is_stepped_sine(folder.file("none.csv")));
  EXPECT_FALSE(is_stepped_sine(folder.file(".")));
  EXPECT_FALSE(is_stepped_sine(folder.file("x.csv") + ":frequency"));
  EXPECT_FALSE(is_stepped_sine(""));
}

// What is meant to be a sweep and lacks a part is reported as such, not as a record without
// accelerometers.
TEST(SteppedSineFile, NamesThePartThatASweepLacks) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("x.csv");
  const auto refused = [&](const std::string& content) {
    test::put(path, content);
    EXPECT_TRUE(is_stepped_sine(path)) << content;
    return message_of<FormatError>([&] { return read_stepped_sines(path); });
  };
  expect_parts(refused("frequency [Hz],force [N],acceleration [g]\n1,1,1\n2,1,1\n"),
               {"with phase [rad]", "relative to the force"});
  expect_parts(refused("frequency [Hz],force [N],displacement [m],phase [rad]\n1,1,1,1\n"),
               {"with acceleration [m/s^2]", "displacement: multiply it by (2 pi frequency)^2"});
  expect_parts(refused("frequency [Hz],force [N],velocity [m/s],phase [rad]\n1,1,1,1\n"),
               {"with acceleration [m/s^2]", "velocity: multiply it by 2 pi frequency"});
  expect_parts(refused("frequency [Hz],force [N],displacement [m]\n1,1,1\n"),
               {"acceleration [m/s^2] and phase [rad]"});
  expect_parts(refused("frequency [Hz],force [N],acceleration [mm],phase [rad]\n1,1,1,1\n"),
               {":1:26:", "a unit of acceleration", "a unit of length"});
  expect_parts(
      refused("frequency [Hz],force [N],acceleration [g],phase [rad]\n1,1,1,1\n2,-3,1,1\n"),
      {":3:3:", "a number above 0", "'-3'"});
}

TEST(SteppedSineFile, NamesThePlaceOfAFault) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("x.csv");
  const auto fault = [&](const std::string& content) {
    test::put(path, content);
    return message_of<FormatError>([&] { return read_stepped_sines(path); });
  };
  EXPECT_NE(fault("frequency [Hz],force,acceleration [g],phase [rad]\n1,1,1,1\n")
                .find("x.csv:1:16: expected a unit of force"),
            std::string::npos);
  EXPECT_NE(fault("frequency [Hz],force [N],acceleration [g],phase [N]\n1,1,1,1\n")
                .find("x.csv:1:43: expected"),
            std::string::npos);
  EXPECT_NE(fault("frequency [Hz],force [N],acceleration [g],phase [rad]\n1,1,x,1\n")
                .find("x.csv:2:5: expected a finite number"),
            std::string::npos);
  EXPECT_NE(message_of<FileError>([] { return read_stepped_sines("none.csv"); }).find("none.csv"),
            std::string::npos);
}

// ---- MATLAB. ----

using Fields = std::vector<std::pair<std::string, Numbers>>;

/// A struct array `s` of the sweeps, each with the same fields, and the text `units` where there is
/// one.
void write_mat(const std::string& path, const std::vector<Fields>& sweeps,
               const std::string& units = {}) {
  mat_t* file = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  std::vector<const char*> names{"frequency", "force", "amplitude", "phase"};
  if (!sweeps.empty()) {
    names.clear();
    for (const auto& field : sweeps.front()) names.push_back(field.first.c_str());
  }
  if (!units.empty()) names.push_back("units");
  std::array<std::size_t, 2> sizes{1, sweeps.size()};
  matvar_t* array =
      Mat_VarCreateStruct("s", 2, sizes.data(), names.data(), static_cast<unsigned>(names.size()));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    for (const auto& [name, values] : sweeps[i]) {
      std::array<std::size_t, 2> length{values.size(), 1};
      Mat_VarSetStructFieldByName(
          array, name.c_str(), i,
          Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, length.data(),
                        const_cast<double*>(values.data()), 0));
    }
    std::array<std::size_t, 2> length{1, units.size()};
    if (!units.empty()) {
      Mat_VarSetStructFieldByName(array, "units", i,
                                  Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UTF8, 2, length.data(),
                                                const_cast<char*>(units.data()), 0));
    }
  }
  Mat_VarWrite(file, array, MAT_COMPRESSION_NONE);
  Mat_VarFree(array);
  Mat_Close(file);
}

Fields fields(const std::string& acceleration, double scale) {
  return {{"frequency", {80.0, 80.5}},
          {"force", {0.5 * scale, 0.25 * scale}},
          {acceleration, {1.0 * scale, 2.0 * scale}},
          {"phase", {-10.0, -90.0}}};
}

TEST(SteppedSineFile, ReadsAStructArray) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  for (const std::string acceleration : {"amplitude", "acceleration"}) {
    write_mat(path, {fields(acceleration, 1.0), fields(acceleration, 3.0)}, "Hz, kN, g, deg");
    EXPECT_TRUE(is_stepped_sine(path + ":s"));
    EXPECT_FALSE(is_stepped_sine(path)) << "the file alone";
    EXPECT_FALSE(is_stepped_sine(path + ":t"));
    const std::vector<SteppedSine> sweeps = read_stepped_sines(path + ":s");
    ASSERT_EQ(sweeps.size(), 2U);
    EXPECT_EQ(sweeps[1].source, path + ":s(2)");
    EXPECT_EQ(sweeps[1].frequency, (Numbers{80.0, 80.5}));
    EXPECT_EQ(sweeps[1].force, (Numbers{1500.0, 750.0}));
    EXPECT_EQ(sweeps[0].acceleration, (Numbers{9.80665, 19.6133}));
    EXPECT_DOUBLE_EQ(sweeps[0].phase[1], -std::numbers::pi / 2.0);
    const std::vector<SteppedSine> one = read_stepped_sines(path + ":s(2)");
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].force, sweeps[1].force);
  }
}

TEST(SteppedSineFile, IsInSiWithoutUnits) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  write_mat(path, {fields("amplitude", 1.0)});
  const std::vector<SteppedSine> sweeps = read_stepped_sines(path + ":s");
  EXPECT_EQ(sweeps[0].source, path + ":s");
  EXPECT_EQ(sweeps[0].force, (Numbers{0.5, 0.25}));
  EXPECT_EQ(sweeps[0].phase, (Numbers{-10.0, -90.0}));
}

TEST(SteppedSineFile, RefusesUnitsThatAreNone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  for (const std::string units : {"Hz, N, g", "Hz, g, N, deg", "Hz; N; g; deg", "Hz, N, g, deg, s",
                                  "Hz, N, g,", "Hz,, g, deg"}) {
    write_mat(path, {fields("amplitude", 1.0)}, units);
    const std::string message =
        message_of<InputError>([&] { return read_stepped_sines(path + ":s"); });
    EXPECT_NE(message.find("s.units = '" + units + "'; must be units of"), std::string::npos)
        << message;
  }
}

TEST(SteppedSineFile, RefusesAnArrayWithoutSweeps) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  write_mat(path, {});
  EXPECT_NE(message_of<InputError>([&] { return read_stepped_sines(path + ":s"); }), "no error");
}

// ---- The published tests of a real beam. ----

/// The eight levels, their resonances found by someone else and printed with five digits.
TEST(SteppedSineFile, BrakeReussBeam) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const std::string file = std::string(folder) + "/brake_reuss_beam/ForcedFrequencyResponses.mat";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string path = file + ":FRdata.ResponseControl";
  ASSERT_TRUE(is_stepped_sine(path));
  const std::vector<SteppedSine> sweeps = read_stepped_sines(path);
  ASSERT_EQ(sweeps.size(), 8U);

  const Levels expected = read_levels(kExamples + "/brake_reuss_beam/levels.csv").levels;
  const Reducer reducer(read_rig(kExamples + "/brake_reuss_beam/rig.toml"));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(sweeps[i].frequency.size(), 41U);
    const ReducedLevel level = reduce_stepped_sine(reducer, sweeps[i]);
    // X = a/ω² whatever the rig's modes. Half a unit of the fifth digit, 5e-5 of 1.0, for the print
    // and as much for how the amplitudes are interpolated between the steps.
    EXPECT_NEAR(level.amplitude.value / expected.amplitude[i], 1.0, 1e-4);
    const double omega = 2.0 * std::numbers::pi * level.frequency;
    EXPECT_NEAR(level.amplitude.value * omega * omega / level.response_amplitude, 1.0, 1e-6);
    // D = πFX: without loss in the rig nothing is taken from what the drive point loses.
    // Two amplitudes are interpolated here: 5e-5 for each and for the print.
    EXPECT_NEAR(level.dissipation.value / expected.dissipation[i], 1.0, 1.5e-4);
    EXPECT_EQ(level.linear_dissipation, 0.0);
    EXPECT_FALSE(level.secant_stiffness.has_value());
    EXPECT_TRUE(level.flags.empty());
  }
}

}  // namespace
}  // namespace microslip::stepped_sine_file_test
