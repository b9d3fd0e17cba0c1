// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/assumed_units.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::assumed_units_test {
namespace {

using test::message_of;

AssumedUnits parse(const std::vector<std::string>& arguments) {
  return parse_assumed_units(arguments);
}

Recording sample() {
  Recording r;
  r.source = "r";
  r.axis.step = 1.0;
  for (const char* name : {"force", "acc1", "Velocity x", "ldv", "x"}) {
    r.channels.push_back(
        {.name = name, .dimension = {}, .values = {1.0, -2.0}, .imaginary = {}, .attributes = {}});
  }
  r.channels[4].attributes = {{"quantity", "displacement, relative"}};
  return r;
}

std::string fault(const std::vector<std::string>& arguments) {
  return message_of<InputError>([&] {
    std::vector<Recording> recordings{sample()};
    recordings[0].channels[0].dimension = kForce;
    assume_units(parse(arguments), recordings);
    return 0;
  });
}

TEST(AssumedUnits, ByName) {
  std::vector<Recording> recordings{sample(), sample()};
  recordings[1].channels.erase(recordings[1].channels.begin());
  assume_units(parse({"force=kN", "acc1 = g"}), recordings);
  EXPECT_EQ(recordings[0].channels[0].values, (std::vector<double>{1000.0, -2000.0}));
  EXPECT_EQ(recordings[0].channels[0].dimension, kForce);
  EXPECT_EQ(recordings[1].channels[0].values, (std::vector<double>{9.80665, -2 * 9.80665}));
  EXPECT_FALSE(recordings[0].channels[3].dimension.has_value());
}

TEST(AssumedUnits, SiByQuantity) {
  std::vector<Recording> recordings{sample()};
  assume_units(parse({"SI", "acc1=g"}), recordings);
  const std::vector<Channel>& channels = recordings[0].channels;
  EXPECT_EQ(channels[0].dimension, kForce);
  EXPECT_EQ(channels[1].values[0], 9.80665) << "the name goes before";
  EXPECT_EQ(channels[2].dimension, kVelocity);
  EXPECT_FALSE(channels[3].dimension.has_value()) << "nobody knows what it is";
  EXPECT_EQ(channels[4].dimension, kLength) << "the file says it";
  EXPECT_EQ(channels[4].values, (std::vector<double>{1.0, -2.0}));
}

// The letters that stand for a displacement, a velocity, an acceleration and a force are names.
TEST(AssumedUnits, SiByTheUsualNames) {
  struct Case {
    std::string name;
    std::optional<Dimension> dimension;
  };
  const std::vector<Case> cases{{"x", kLength},        {"X2", kLength},
                                {"y", kLength},        {"u_1", kLength},
                                {"v", kVelocity},      {"a", kAcceleration},
                                {"F", kForce},         {"tip_acceleration", kAcceleration},
                                {"2 Force", kForce},   {"accel_x", kAcceleration},
                                {"Disp 3", kLength},   {"x tip", std::nullopt},
                                {"ldv", std::nullopt}, {"force velocity", std::nullopt},
                                {"17", std::nullopt}};
  for (const Case& c : cases) {
    std::vector<Recording> recordings{sample()};
    recordings[0].channels.resize(1);
    recordings[0].channels[0].name = c.name;
    assume_units(parse({"SI"}), recordings);
    EXPECT_EQ(recordings[0].channels[0].dimension, c.dimension) << c.name;
    EXPECT_EQ(recordings[0].channels[0].values[0], 1.0);
  }
}

TEST(AssumedUnits, KnowsWhatAnAxisIsCalled) {
  EXPECT_EQ(axis_dimension("Time"), kTime);
  EXPECT_EQ(axis_dimension("t"), kTime);
  EXPECT_EQ(axis_dimension("FREQUENCY"), kFrequency);
  EXPECT_FALSE(axis_dimension("time2").has_value());
  EXPECT_FALSE(axis_dimension("force").has_value());
  EXPECT_FALSE(axis_dimension("").has_value());
}

TEST(AssumedUnits, RefusesWhatDoesNotFit) {
  EXPECT_EQ(fault({"acc1"}),
            "`assume_units` = 'acc1'; must read CHANNEL=UNIT or SI. For instance force=N.");
  EXPECT_NE(fault({"=N"}).find("must read CHANNEL=UNIT"), std::string::npos);
  EXPECT_NE(fault({"acc1=furlong"}).find("'furlong' must be a known unit"), std::string::npos);
  EXPECT_NE(fault({"acc1=g", "acc1=m/s^2"}).find("each channel once"), std::string::npos);
  EXPECT_NE(fault({"acc9=g"}).find("the recording has 'force', 'acc1'"), std::string::npos);
  EXPECT_NE(fault({"force=N"}).find("must have no unit if one is assumed"), std::string::npos);
  EXPECT_EQ(fault({"time=s"}), "no error") << "it may be that of the axis";
}

}  // namespace
}  // namespace microslip::assumed_units_test
