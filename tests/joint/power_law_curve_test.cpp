// SPDX-License-Identifier: MIT
#include "microslip/joint/power_law_curve.hpp"

#include <gtest/gtest.h>

#include "support/exact_power_law.hpp"

namespace microslip::power_law_curve_test {
namespace {

using testing::ExactPowerLaw;
using testing::relative_error;

// Against the antiderivatives in 100 digits. A few roundings of the power and of products; laws
// that begin above 0 are by power_law_slip(), of ninety roundings.
TEST(PowerLawCurve, IsThePowerLawBeforeInsideAndBeyondIt) {
  for (const double exponent : {-0.95, -0.5, 0.0, 0.7, 3.0, 6.9, 9.0}) {
    for (const double from : {0.0, 3.0}) {
      const PowerLawPart part{0.01, exponent, from, 40.0};
      const PowerLawCurve curve(part);
      for (const double s : {3.1, 10.0, 39.99, 40.0, 40.01, 100.0, 1e4}) {
        const ExactPowerLaw exact(part, s);
        const PowerLawSlip slip = curve.slip(s);
        EXPECT_LT(relative_error(slip.weight, exact.moment(0)), 2e-14) << exponent << " at " << s;
        EXPECT_LT(relative_error(slip.force_deficit, exact.force_deficit()), 2e-14)
            << exponent << " at " << s;
        EXPECT_LT(relative_error(curve.weight(s), exact.moment(0)), 2e-14);
        EXPECT_LT(relative_error(curve.force_deficit(s), exact.force_deficit()), 2e-14);
      }
      EXPECT_EQ(curve.slip(0.0).weight, 0.0);
      EXPECT_EQ(curve.slip(0.0).force_deficit, 0.0);
    }
  }
}

TEST(PowerLawCurve, IsAccurateFarBelowItsEnd) {
  const PowerLawPart part{0.01, -0.4, 0.0, 40.0};
  const PowerLawCurve curve(part);
  for (const double s : {1e-3, 1e-9, 1e-18, 1e-30, 1e-150}) {
    const ExactPowerLaw exact(part, s);
    EXPECT_LT(relative_error(curve.slip(s).weight, exact.moment(0)), 2e-14) << s;
    EXPECT_LT(relative_error(curve.slip(s).force_deficit, exact.force_deficit()), 2e-14) << s;
  }
}

}  // namespace
}  // namespace microslip::power_law_curve_test
