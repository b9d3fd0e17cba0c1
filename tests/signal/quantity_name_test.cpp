// SPDX-License-Identifier: MIT
#include "microslip/signal/recording/quantity_name.hpp"

#include <gtest/gtest.h>

#include <string>

#include "microslip/base/error.hpp"
#include "microslip/signal/recording/recording.hpp"
#include "support/messages.hpp"

namespace microslip::quantity_name_test {
namespace {

TEST(QuantityName, IsAWordOfIt) {
  EXPECT_EQ(quantity_of_name("acc1"), kAcceleration);
  EXPECT_EQ(quantity_of_name("Tip-Acceleration (2)"), kAcceleration);
  EXPECT_EQ(quantity_of_name("FORCE"), kForce);
  EXPECT_EQ(quantity_of_name("disp_acc"), std::nullopt) << "which of the two?";
  EXPECT_EQ(quantity_of_name("accident"), std::nullopt) << "no word is a part of another";
}

TEST(QuantityName, IsALetterThatStandsAlone) {
  EXPECT_EQ(quantity_of_name("x"), kLength);
  EXPECT_EQ(quantity_of_name("u_12"), kLength);
  EXPECT_EQ(quantity_of_name("x_force"), kForce);
  EXPECT_EQ(quantity_of_name("x_left"), std::nullopt);
  EXPECT_EQ(quantity_of_name(""), std::nullopt);
}

std::string fault(const std::string& name, const Dimension& expected) {
  Recording recording;
  recording.source = "r";
  recording.axis.step = 1.0;
  recording.channels.push_back(
      {.name = name, .dimension = {}, .values = {1.0, 2.0}, .imaginary = {}, .attributes = {}});
  return test::message_or<InputError>("no error",
                                      [&] { return recording.signal(name, expected).size(); });
}

// Who obeys must not get metres from an acceleration.
TEST(QuantityName, DecidesWhichUnitIsProposed) {
  EXPECT_EQ(fault("acc1", kLength),
            "r: channel 'acc1' is without unit; must have a unit. Give its unit with "
            "`assume_units acc1=m/s^2`, if it is acceleration as its name states.");
  EXPECT_EQ(fault("ldv", kLength),
            "r: channel 'ldv' is without unit; must have a unit of length. Give its unit with "
            "`assume_units ldv=m`.");
  EXPECT_NE(fault("force", kForce).find("`assume_units force=N`."), std::string::npos);
  EXPECT_NE(fault("vel", kVelocity).find("`assume_units vel=m/s`."), std::string::npos);
}

}  // namespace
}  // namespace microslip::quantity_name_test
