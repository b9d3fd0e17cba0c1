// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/stepped_sine_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/rig/reduction/reduction.hpp"

namespace microslip::stepped_sine_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

const std::string kExamples = MICROSLIP_EXAMPLES;

bool holds_sweep(const std::string& path) {
  return open_test(path).content == TestContent::kSteppedSine;
}

std::vector<SteppedSine> sweeps_in(const std::string& path) {
  return read_stepped_sines(open_test(path));
}

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
  EXPECT_TRUE(holds_sweep(path));
  const std::vector<SteppedSine> sweeps = sweeps_in(path);
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
    return holds_sweep(folder.file("x.csv"));
  };
  EXPECT_TRUE(is_one(kTable));
  EXPECT_FALSE(is_one("time [s],force [N],acceleration [m/s^2],phase [rad]\n0,1,1,1\n"));
  EXPECT_FALSE(is_one("frequency [Hz],force [N],acc1 [m/s^2]\n1,1,1\n"));
  EXPECT_FALSE(is_one("displacement [m],force [N],frequency [Hz],damping_ratio [1]\n1,1,1,1\n"));
  EXPECT_FALSE(is_one(""));
  EXPECT_FALSE(is_one(std::string("\x89HDF\r\n\x1A\n\0\0", 10)));
  EXPECT_FALSE(holds_sweep(folder.file("x.csv") + ":frequency"));
}

// What is meant to be a sweep and lacks a part is reported as such, not as a record without
// accelerometers.
TEST(SteppedSineFile, NamesThePartThatASweepLacks) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("x.csv");
  const auto refused = [&](const std::string& content) {
    test::put(path, content);
    EXPECT_TRUE(holds_sweep(path)) << content;
    return message_of<FormatError>([&] { return sweeps_in(path); });
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
    return message_of<FormatError>([&] { return sweeps_in(path); });
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
  EXPECT_NE(message_of<FileError>([] { return sweeps_in("none.csv"); }).find("none.csv"),
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

// A campaign of sweeps in one MATLAB file opened it 200 times: once for each field of each sweep.
TEST(SteppedSineFile, ReadsAVariableWhenItIsOpened) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  write_mat(path, {fields("amplitude", 1.0), fields("amplitude", 3.0)}, "Hz, kN, g, deg");
  const TestFile opened = open_test(path + ":s");
  std::filesystem::remove(path);
  EXPECT_EQ(read_stepped_sines(opened).size(), 2U);
}

TEST(SteppedSineFile, ReadsAStructArray) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  for (const std::string acceleration : {"amplitude", "acceleration"}) {
    write_mat(path, {fields(acceleration, 1.0), fields(acceleration, 3.0)}, "Hz, kN, g, deg");
    EXPECT_TRUE(holds_sweep(path + ":s"));
    EXPECT_TRUE(holds_sweep(path)) << "its only variable of sweeps";
    EXPECT_FALSE(holds_sweep(path + ":t"));
    const std::vector<SteppedSine> sweeps = sweeps_in(path + ":s");
    ASSERT_EQ(sweeps.size(), 2U);
    EXPECT_EQ(sweeps[1].source, path + ":s(2)");
    EXPECT_EQ(sweeps[1].frequency, (Numbers{80.0, 80.5}));
    EXPECT_EQ(sweeps[1].force, (Numbers{1500.0, 750.0}));
    EXPECT_EQ(sweeps[0].acceleration, (Numbers{9.80665, 19.6133}));
    EXPECT_DOUBLE_EQ(sweeps[0].phase[1], -std::numbers::pi / 2.0);
    const std::vector<SteppedSine> one = sweeps_in(path + ":s(2)");
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].force, sweeps[1].force);
  }
}

TEST(SteppedSineFile, IsInSiWithoutUnits) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  write_mat(path, {fields("amplitude", 1.0)});
  const std::vector<SteppedSine> sweeps = sweeps_in(path + ":s");
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
    const std::string message = message_of<InputError>([&] { return sweeps_in(path + ":s"); });
    EXPECT_NE(message.find("s.units = '" + units + "'; must be units of"), std::string::npos)
        << message;
  }
}

TEST(SteppedSineFile, RefusesAnArrayWithoutSweeps) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  write_mat(path, {});
  EXPECT_NE(message_of<InputError>([&] { return sweeps_in(path + ":s"); }), "no error");
}

// ---- The published tests of a real beam. ----

/// The eight levels, their resonances found by someone else and printed with five digits.
TEST(SteppedSineFile, BrakeReussBeam) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const std::string file = std::string(folder) + "/brake_reuss_beam/ForcedFrequencyResponses.mat";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string path = file + ":FRdata.ResponseControl";
  ASSERT_TRUE(holds_sweep(path));
  const std::vector<SteppedSine> sweeps = sweeps_in(path);
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

// ---- Frequency responses with the level of the response. ----

/// A dataset 58 over uneven frequencies, 80, 80.5 and 81.5 Hz, of complex values.
/// @param id  its first line, which identifies it.
std::string dataset(int type, const std::string& numerator, const std::string& denominator,
                    const std::array<std::complex<double>, 3>& values,
                    const std::string& id = "sweep") {
  constexpr std::array kFrequencies{80.0, 80.5, 81.5};
  std::string text = "    -1\n    58\n" + id + "\nNONE\n11-JUN-24  10:12:00\nNONE\nNONE\n";
  text += fmt::format(
      "{:5}         1    1         0 PLATE              1   3 PLATE              1   3\n", type);
  text +=
      "         6         3         0  0.00000E+00  0.00000E+00  0.00000E+00\n"
      "        18    0    0    0 Frequency            Hz                  \n";
  text += fmt::format("{}{}         0    0    0    0 NONE                 NONE\n", numerator,
                      denominator);
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("{:13.5E}{:20.12E}{:20.12E}\n", kFrequencies[i], values[i].real(),
                        values[i].imag());
  }
  return text + "    -1\n";
}

const std::string kAccelerationLine =
    "        12    0    0    0 Acceleration         m/s^2               \n";
const std::string kVelocityLine =
    "        11    0    0    0 Velocity             m/s                 \n";
const std::string kForceLine =
    "        13    0    0    0 Excitation Force     N                   \n";
const std::string kNoLine = "         0    0    0    0 NONE                 NONE                \n";

// H = (4i − 3, 6i, 4) m/s²/N at responses of 2, 3 and 4 m/s²: forces of 0.4, 0.5 and 1 N. The
// mobility of the same is H/(iω), whose level is a velocity.
TEST(SteppedSineFile, ReadsFrequencyResponsesWithTheirLevels) {
  const test::TemporaryFolder folder;
  const std::array<std::complex<double>, 3> accelerance{{{-3.0, 4.0}, {0.0, 6.0}, 4.0}};
  const std::array<std::complex<double>, 3> level{{2.0, {0.0, -3.0}, 4.0}};
  std::array<std::complex<double>, 3> mobility{};
  std::array<std::complex<double>, 3> velocity{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::complex<double> rate(0.0, 2.0 * std::numbers::pi *
                                             (i == 0   ? 80.0
                                              : i == 1 ? 80.5
                                                       : 81.5));
    mobility[i] = accelerance[i] / rate;
    velocity[i] = level[i] / rate;
  }
  const std::string path = folder.file("sweep.unv");
  for (const std::string& text : {dataset(4, kAccelerationLine, kForceLine, accelerance) +
                                      dataset(12, kAccelerationLine, kNoLine, level),
                                  dataset(4, kVelocityLine, kForceLine, mobility) +
                                      dataset(12, kVelocityLine, kNoLine, velocity)}) {
    test::put(path, "    -1\n   151\nPlate\nNONE\nTest system\n    -1\n" + text);
    ASSERT_TRUE(holds_sweep(path));
    const std::vector<SteppedSine> sweeps = sweeps_in(path);
    ASSERT_EQ(sweeps.size(), 1U);
    EXPECT_EQ(sweeps[0].frequency, (Numbers{80.0, 80.5, 81.5}));
    const Numbers force{0.4, 0.5, 1.0};
    const Numbers phase{std::atan2(4.0, -3.0), 0.5 * std::numbers::pi, 0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(sweeps[0].force[i], force[i], 1e-9);
      EXPECT_NEAR(sweeps[0].acceleration[i], std::abs(level[i]), 1e-9);
      EXPECT_NEAR(sweeps[0].phase[i], phase[i], 1e-9);
    }
  }
}

TEST(SteppedSineFile, SaysWhatAFrequencyResponseLacks) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweep.unv");
  const std::string response = dataset(4, kAccelerationLine, kForceLine, {-8.0, {0.0, 6.0}, 4.0});
  test::put(path, response);
  ASSERT_TRUE(holds_sweep(path));
  const std::string without = message_of<InputError>([&] { return sweeps_in(path); });
  EXPECT_NE(without.find("sweep.unv"), std::string::npos) << without;
  EXPECT_NE(without.find("0 channels with the level of the response"), std::string::npos)
      << without;
  EXPECT_NE(without.find("Export the spectrum"), std::string::npos) << without;
  const std::string level = dataset(12, kAccelerationLine, kNoLine, {2.0, 3.0, 4.0});
  test::put(path, level + response);
  ASSERT_TRUE(holds_sweep(path));
  EXPECT_EQ(sweeps_in(path).at(0).force[0], 0.25);
  test::put(path, level);
  EXPECT_NE(message_of<InputError>([&] {
              return sweeps_in(path);
            }).find("0 channels with a frequency response"),
            std::string::npos);
}

// The usual way of a test system: each level over the same frequencies, identified in its first
// line.
TEST(SteppedSineFile, PairsLevelsOverTheSameFrequencies) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweep.unv");
  const auto response = [](double h, const std::string& id) {
    return dataset(4, kAccelerationLine, kForceLine, {-h, {0.0, h}, h}, id);
  };
  const auto level = [](double a, const std::string& id) {
    return dataset(12, kAccelerationLine, kNoLine, {a, a, a}, id);
  };
  test::put(path, response(8.0, "level 1") + response(4.0, "level 2") + level(6.0, "level 2") +
                      level(2.0, "level 1"));
  const std::vector<SteppedSine> sweeps = sweeps_in(path);
  ASSERT_EQ(sweeps.size(), 2U);
  EXPECT_EQ(sweeps[0].source, "sweep.unv: level 1");
  EXPECT_EQ(sweeps[0].force[0], 0.25) << "2/8";
  EXPECT_EQ(sweeps[1].source, "sweep.unv: level 2");
  EXPECT_EQ(sweeps[1].force[0], 1.5) << "6/4";
  test::put(path, response(8.0, "a") + response(4.0, "a") + level(6.0, "a") + level(2.0, "b"));
  EXPECT_NE(message_of<InputError>([&] {
              return sweeps_in(path);
            }).find("need one identification each, in the first line"),
            std::string::npos);
}

TEST(SteppedSineFile, ReadsFrequencyResponsesOfAStruct) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweeps.mat");
  const std::string units = "Hz, g/kN, g";
  for (const std::string name : {"Freq", "frequency"}) {
    const Fields sweep{{name, {80.0, 81.0}}, {"FRF", {4000.0, 8000.0}}, {"Response", {2.0, 1.0}}};
    write_mat(path, {sweep, sweep}, units);
    ASSERT_TRUE(holds_sweep(path + ":s"));
    const std::vector<SteppedSine> sweeps = sweeps_in(path + ":s");
    ASSERT_EQ(sweeps.size(), 2U);
    EXPECT_EQ(sweeps[1].source, path + ":s(2)");
    EXPECT_NEAR(sweeps[0].force[0], 0.5, 1e-12);
    EXPECT_NEAR(sweeps[0].force[1], 0.125, 1e-12);
    EXPECT_DOUBLE_EQ(sweeps[0].acceleration[0], 2.0 * kStandardGravity);
    EXPECT_EQ(sweeps[0].phase[1], 0.0);
  }
  write_mat(path, {{{"Freq", {80.0, 81.0}}, {"FRF", {4.0, 8.0}}, {"Response", {2.0}}}});
  EXPECT_NE(message_of<InputError>([&] {
              return sweeps_in(path + ":s");
            }).find("2 frequencies, 2 frequency responses and 1 responses"),
            std::string::npos);
}

// As test systems write a sweep: names in any spelling, lines above, units on a line of their own,
// decimal commas, blanks, a time beside it, names in another language.
// 1 g = 9.80665 m/s^2.
TEST(SteppedSineFile, ReadsTablesOfTestSystems) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sweep.txt");
  for (const std::string text :
       {"Sine test: level 0;;;\nFrequency;Force;Acceleration;Phase\nHz;mN;g;deg\n"
        "80,5;500;1;-10\n80,0;250;2;-90\n79,5;250;2;-120\n",
        "frequency[Hz] force[mN] acceleration[g] phase[deg]\n80.5 500 1 -10\n80.0 250 2 -90\n"
        "79.5 250 2 -120\n",
        "Frequenz (Hz);Kraft (mN);Beschleunigung (g);Winkel (deg)\n80,5;500;1;-10\n"
        "80,0;250;2;-90\n79,5;250;2;-120\n",
        "Sweep 3\nFreq (Hz),Force (N),Acc (g),Phase angle (deg)\n80.5,0.5,1,-10\n80,0.25,2,-90\n"
        "79.5,0.25,2,-120\n",
        "time [s],frequency [Hz],force [mN],acceleration [g],phase [deg]\n0,80.5,500,1,-10\n"
        "1,80,250,2,-90\n2,79.5,250,2,-120\n"}) {
    test::put(path, text);
    ASSERT_TRUE(holds_sweep(path)) << text;
    const std::vector<SteppedSine> sweeps = sweeps_in(path);
    ASSERT_EQ(sweeps.size(), 1U);
    EXPECT_EQ(sweeps[0].frequency, (Numbers{80.5, 80.0, 79.5})) << text;
    EXPECT_EQ(sweeps[0].force, (Numbers{0.5, 0.25, 0.25})) << text;
    EXPECT_DOUBLE_EQ(sweeps[0].acceleration[1], 2 * 9.80665);
    EXPECT_DOUBLE_EQ(sweeps[0].phase[1], -std::numbers::pi / 2);
  }
  test::put(path, "Freq (Hz),Force (N),Acc (g)\n80.5,0.5,1\n80,0.25,2\n");
  EXPECT_NE(message_of<FormatError>([&] { return sweeps_in(path); }).find("with phase [rad]"),
            std::string::npos);
  test::put(
      path,
      "Sweep\nFreq (Hz),Force 1 (N),Force 2 (N),Acc (g),Phase (deg)\n80,1,1,1,1\n81,1,1,1,1\n");
  EXPECT_NE(message_of<FormatError>([&] {
              return sweeps_in(path);
            }).find("expected one column of the force of a stepped sine, found 2"),
            std::string::npos);
  test::put(path, "Time (s),Force (N),Acc (g)\n0,0.5,1\n1,0.25,2\n");
  EXPECT_FALSE(holds_sweep(path)) << "a record";
}

}  // namespace
}  // namespace microslip::stepped_sine_file_test
