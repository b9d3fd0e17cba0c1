// SPDX-License-Identifier: MIT
#include "microslip/base/plausibility.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace microslip::plausibility_test {
namespace {

// 31 m and 4.1 MJ result from the decay of a bolted beam where m/s^2 are taken for m.
TEST(Plausibility, WarnsOfWhatNoStructureSurvives) {
  const auto warning = implausible_value("a.csv: channel 'acc1'", kLength, 31.0);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->code, "implausible_value");
  EXPECT_EQ(warning->text,
            "a.csv: channel 'acc1': displacement of 31 m; no structure survives more than 1 m. "
            "Is the unit wrong?");
  EXPECT_TRUE(implausible_value("x", kEnergy, 4.1e6));
  EXPECT_TRUE(implausible_value("x", kAcceleration, 1.1e6));
  EXPECT_TRUE(implausible_value("x", kVelocity, 1.1e3));
}

TEST(Plausibility, IsSilentOfMeasurements) {
  EXPECT_FALSE(implausible_value("a seismic damper", kLength, 0.5));
  EXPECT_FALSE(implausible_value("a shock", kAcceleration, 5e5));
  EXPECT_FALSE(implausible_value("a damper of 400 kN over 1 m", kEnergy, 4e5));
  EXPECT_FALSE(implausible_value("no bound", kForce, 1e12));
  EXPECT_FALSE(implausible_value("not a number", kLength, 0.0 / 0.0));
  std::vector<Warning> warnings;
  warn_of_implausible("x", kLength, std::vector{0.1, 2.0, 0.3}, warnings);
  warn_of_implausible("x", kLength, std::vector<double>{}, warnings);
  EXPECT_EQ(warnings.size(), 1U);
}

}  // namespace
}  // namespace microslip::plausibility_test
