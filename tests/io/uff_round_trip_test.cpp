// SPDX-License-Identifier: MIT

// What is written reads back: 58b to the bit, 58 within its digits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "io/uff_support.hpp"
#include "support/effort.hpp"

namespace microslip::uff_round_trip_test {
namespace {

using test::Function58;
using test::TemporaryFolder;

std::vector<Recording> written_and_read(const std::vector<Recording>& recordings, bool binary) {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.uff");
  write_recordings_uff(path, recordings, binary);
  Recordings read = read_recordings_uff(path);
  EXPECT_TRUE(read.warnings.empty()) << read.warnings[0].text;
  return std::move(read.recordings);
}

double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

std::vector<double> any_doubles(std::size_t count, std::mt19937_64& random) {
  std::vector<double> values(count);
  for (double& value : values) value = any_double(random);
  return values;
}

Axis any_axis(std::size_t points, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const std::vector<Dimension> dimensions{kTime, kFrequency, kLength, kDimensionless,
                                          kAngularFrequency};
  Axis axis{.dimension = dimensions[random() % dimensions.size()], .values = {}};
  switch (random() % 4) {
    case 0:
      axis.step = 1.0 / std::round(1.0 + 65536.0 * uniform(random));
      break;
    case 1:  // more digits than a header has
      axis.step = std::exp(-20.0 * uniform(random));
      break;
    case 2:
      axis.step = std::exp(-20.0 * uniform(random));
      axis.start = 2.0 * uniform(random) - 1.0;
      break;
    default:
      double x = -uniform(random);
      for (std::size_t i = 0; i < points; ++i) axis.values.push_back(x += 0.01 + uniform(random));
  }
  return axis;
}

Recording any_recording(std::mt19937_64& random) {
  const std::vector<std::optional<Dimension>> dimensions{kForce,
                                                         kAcceleration,
                                                         kLength,
                                                         kVelocity,
                                                         kMass,
                                                         std::nullopt,
                                                         kDimensionless,
                                                         kEnergy,
                                                         kStiffness,
                                                         kAngle,
                                                         kForce.power(2) / kFrequency,
                                                         kPressure,
                                                         kTime};
  const std::size_t points = 3 + random() % 40;
  Recording recording{
      .source = "t.uff", .axis = any_axis(points, random), .channels = {}, .attributes = {}};
  for (std::size_t i = 0; i < 1 + random() % 4; ++i) {
    Channel channel{.name = fmt::format("Kanal {} ²", i),
                    .dimension = dimensions[random() % dimensions.size()],
                    .values = any_doubles(points, random),
                    .imaginary = {},
                    .attributes = {}};
    if (random() % 3 == 0) channel.imaginary = any_doubles(points, random);
    recording.channels.push_back(std::move(channel));
  }
  return recording;
}

void expect_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void expect_equal(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.axis, b.axis);
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.attributes, b.attributes);
}

void expect_equal(const std::vector<Recording>& a, const std::vector<Recording>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_equal(a[i], b[i]);
}

/// The same grid: the step itself may be another where rounding hides it, only of few points.
void expect_same(const Recording& read, const Recording& expected) {
  EXPECT_EQ(read.source, expected.source);
  EXPECT_EQ(read.axis.dimension, expected.axis.dimension);
  ASSERT_EQ(read.size(), expected.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_EQ(read.axis.at(i), expected.axis.at(i)) << i;
  }
  ASSERT_EQ(read.channels.size(), expected.channels.size());
  for (std::size_t i = 0; i < read.channels.size(); ++i) {
    EXPECT_EQ(read.channels[i].name, expected.channels[i].name);
    EXPECT_EQ(read.channels[i].dimension, expected.channels[i].dimension);
    EXPECT_EQ(read.channels[i].attributes, expected.channels[i].attributes);
    expect_same_bits(read.channels[i].values, expected.channels[i].values);
    expect_same_bits(read.channels[i].imaginary, expected.channels[i].imaginary);
  }
}

TEST(UffRoundTrip, BinaryIsExact) {
  std::mt19937_64 random(1);
  for (int i = 0; i < test::cases_of(500); ++i) {
    SCOPED_TRACE(i);
    const Recording recording = any_recording(random);
    const std::vector<Recording> read = written_and_read({recording}, true);
    ASSERT_EQ(read.size(), 1U);
    expect_same(read[0], recording);
    const std::vector<Recording> again = written_and_read(read, true);
    expect_equal(again, read);  // from here on it is the same object
  }
}

TEST(UffRoundTrip, EvenAxesStayEven) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int even = 0;
  constexpr int kCases = 500;
  for (int i = 0; i < kCases; ++i) {
    Recording recording{.source = "t.uff",
                        .axis = {.step = std::exp(-10.0 * uniform(random)), .values = {}},
                        .channels = {{"a", kForce, {}, {}, {}}},
                        .attributes = {}};
    recording.axis.start = i % 2 == 0 ? 0.0 : uniform(random);
    recording.channels[0].values.assign(1000, 1.0);
    const std::vector<Recording> read = written_and_read({recording}, true);
    even += read.at(0).axis.even() ? 1 : 0;
    // A start that is not 0 rounds each point: some grids have no step of their own any more that
    // the search finds, but their points are the same.
    if (i % 2 == 0) {
      EXPECT_EQ(read[0].axis, recording.axis) << i;
    }
  }
  EXPECT_GT(even, kCases * 9 / 10);
}

TEST(UffRoundTrip, TextHasThirteenDigits) {
  std::mt19937_64 random(3);
  for (int i = 0; i < test::cases_of(200); ++i) {
    Recording recording = any_recording(random);
    recording.axis = {.dimension = kTime, .start = 0.0, .step = 1.0 / 8192.0, .values = {}};
    const Recording read = written_and_read({recording}, false).at(0);
    EXPECT_EQ(read.axis, recording.axis);
    ASSERT_EQ(read.channels.size(), recording.channels.size());
    for (std::size_t c = 0; c < read.channels.size(); ++c) {
      const Channel& before = recording.channels[c];
      const Channel& after = read.channels[c];
      EXPECT_EQ(after.dimension, before.dimension);
      EXPECT_EQ(after.name, before.name);
      for (std::size_t p = 0; p < after.values.size(); ++p) {
        // Half a unit in the thirteenth digit, 5e-13, and the rounding of a double.
        EXPECT_NEAR(after.values[p], before.values[p],
                    5.001e-13 * std::abs(before.values[p]) + 5e-324);
      }
    }
    expect_equal(written_and_read({read}, false).at(0), read);  // the second time it is exact
    expect_equal(written_and_read({read}, true).at(0), read);
  }
}

/// A file as another program has made it, with all fields of its headers in use.
std::string foreign_file() {
  Function58 f;
  f.points = 3;
  f.even = false;
  f.ordinate_type = 6;
  f.function_type = 4;
  f.response = "wing";
  f.response_node = 3;
  f.response_direction = 3;
  f.abscissa_type = 18;
  f.abscissa_unit = "Hz";
  f.ordinate_type_code = 12;
  f.ordinate_unit = "g";
  f.denominator_type = 13;
  f.denominator_unit = "N";
  f.id = "Record";
  Function58 g = f;
  g.response_node = 4;
  g.ordinate_unit = "V";
  Function58 h = f;
  h.id = "blank";
  h.ordinate_unit = h.denominator_unit = "";
  const std::string values =
      "  1.00000E+00  1.000000000000E+00  1.100000000000E+00\n"
      "  2.50000E+00 -2.345678901234E-05  0.000000000000E+00\n"
      "  7.00000E+00  3.333333333333E+30 -1.000000000001-300\n";
  return test::marker() + "   151\nwing model\nNONE\nAnalyser 3.1\n01-Jan-24 12:00:00 \n" +
         test::marker() + text_dataset(f, values) + text_dataset(g, values) +
         text_dataset(h, values);
}

TEST(UffRoundTrip, WhatWasReadFromTextSurvivesAllTrips) {
  const std::vector<Recording> read = test::read_uff(foreign_file()).recordings;
  ASSERT_EQ(read.size(), 1U);
  ASSERT_EQ(read[0].channels.size(), 3U);
  EXPECT_EQ(read[0].channels[0].name, "wing 3 +Z");
  EXPECT_EQ(read[0].channels[0].dimension, kAcceleration / kForce);
  EXPECT_EQ(read[0].channels[0].imaginary[0], 1.1 * 9.80665);
  EXPECT_EQ(read[0].channels[1].dimension, std::nullopt);
  EXPECT_EQ(read[0].channels[2].dimension, std::nullopt);
  EXPECT_EQ(read[0].attributes, (Attributes{{"model name", "wing model"},
                                            {"creating program", "Analyser 3.1"},
                                            {"created", "01-Jan-24 12:00:00"}}));
  std::vector<Recording> trip = read;
  for (int i = 0; i < 3; ++i) {
    trip = written_and_read(trip, true);
    SCOPED_TRACE(i);
    expect_equal(trip, read);
  }
}

TEST(UffRoundTrip, RecordingsOfOneAxisStayApart) {
  Recording recording{.source = "t.uff #1",
                      .axis = {.step = 0.001, .values = {}},
                      .channels = {{"force", kForce, {1, 2, 3}, {}, {}}},
                      .attributes = {{"model name", "run 1"}}};
  Recording second = recording;
  second.source = "t.uff #2";
  second.attributes = {};
  const std::vector<Recording> both{recording, second};
  expect_equal(written_and_read(both, true), both);
  expect_equal(written_and_read(both, false), both);
}

TEST(UffRoundTrip, AttributesDoNotOverruleTheUnitOfTheValues) {
  Recording recording{.source = "t.uff",
                      .axis = {.step = 0.001, .values = {}},
                      .channels = {{.name = "a",
                                    .dimension = kForce,
                                    .values = {1, 2, 3},
                                    .imaginary = {},
                                    .attributes = {{"ordinate unit", "mm"}, {"nonsense", "x"}}},
                                   {.name = "b",
                                    .dimension = std::nullopt,
                                    .values = {1, 2, 3},
                                    .imaginary = {},
                                    .attributes = {{"ordinate type", "12"}}}},
                      .attributes = {}};
  const Recording read = written_and_read({recording}, true).at(0);
  EXPECT_EQ(read.channels[0].dimension, kForce);
  EXPECT_EQ(read.channels[0].values, recording.channels[0].values);
  EXPECT_EQ(read.channels[1].dimension, std::nullopt) << "blank would be SI by dataset 164";
  EXPECT_EQ(read.channels[1], recording.channels[1]);
}

TEST(UffRoundTrip, LinesAreEightyColumns) {
  const TemporaryFolder folder;
  std::mt19937_64 random(4);
  for (int i = 0; i < 20; ++i) {
    Recording recording = any_recording(random);
    write_recordings_uff(folder.file("t.uff"), std::vector{recording}, false);
    std::istringstream lines(test::get(folder.file("t.uff")));
    for (std::string line; std::getline(lines, line);) {
      // Two bytes for ².
      const bool square = line.find("²") != std::string::npos;
      EXPECT_EQ(line.size(), square ? 81U : 80U) << line;
    }
  }
}

TEST(UffRoundTrip, RefusesWhatAFileCannotHold) {
  const TemporaryFolder folder;
  const auto fault = [&](const Recording& recording, bool binary) {
    return test::message_of<InputError>([&] {
      write_recordings_uff(folder.file("t.uff"), std::vector{recording}, binary);
      return 0;
    });
  };
  const Recording good{.source = "s",
                       .axis = {.step = 0.001, .values = {}},
                       .channels = {{"a", kForce, {1, 2, 3}, {}, {}}},
                       .attributes = {}};
  EXPECT_EQ(fault(good, true), "no error");
  for (const std::string& name : {std::string(81, 'x'), std::string("NONE"), std::string(" a"),
                                  std::string("a\nb"), std::string("\xFF")}) {
    Recording bad = good;
    bad.channels[0].name = name;
    EXPECT_NE(fault(bad, true).find("must have at most 80 characters"), std::string::npos) << name;
  }
  Recording close = good;
  close.axis = {.dimension = kTime, .start = 0.0, .step = 0.0, .values = {1.0, 1.0000001, 2.0}};
  EXPECT_NE(fault(close, false).find("s: point 2 of the axis = 1.0000001; must differ"),
            std::string::npos)
      << fault(close, false);
  EXPECT_EQ(fault(close, true), "no error");
  Recording empty = good;
  empty.channels.clear();
  EXPECT_NE(fault(empty, true).find("must have at least one"), std::string::npos);
  Recording wide = good;
  wide.channels[0].dimension = Dimension{.length = 9, .mass = -9, .time = -9, .angle = 9};
  EXPECT_EQ(fault(wide, true), "no error") << "m9 kg-9 s-9 rad9 has its place";
}

}  // namespace
}  // namespace microslip::uff_round_trip_test
