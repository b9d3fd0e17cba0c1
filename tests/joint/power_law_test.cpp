// SPDX-License-Identifier: MIT
#include "microslip/joint/power_law.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/effort.hpp"
#include "support/exact_power_law.hpp"

namespace microslip::power_law_test {
namespace {

using testing::Exact;
using testing::ExactPowerLaw;
using testing::relative_error;

// Ninety rounding errors: that of χ ln(f/from) alone makes 4·ln(1000) of them, the antiderivative
// of f^4 loses a factor 5.
constexpr double kRounding = 2e-14;

void expect_accurate(const PowerLawPart& part, double s, double tolerance) {
  SCOPED_TRACE(::testing::Message()
               << "exponent " << part.exponent << " from " << part.from << " to " << part.to
               << " s/from - 1 = " << s / part.from - 1.0);
  const ExactPowerLaw exact(part, s);
  const PartialMoments moments = power_law_moments(part, s);
  EXPECT_LT(relative_error(moments.zeroth, exact.moment(0)), tolerance);
  EXPECT_LT(relative_error(moments.first, exact.moment(1)), tolerance);
  EXPECT_LT(relative_error(moments.second, exact.moment(2)), tolerance);
  EXPECT_LT(relative_error(power_law_force_deficit(part, s), exact.force_deficit()), tolerance);
  EXPECT_LT(relative_error(power_law_slip_energy(part, s), exact.slip_energy()), tolerance);
  const PowerLawSlip slip = power_law_slip(part, s);
  EXPECT_LT(relative_error(slip.weight, exact.moment(0)), tolerance);
  EXPECT_LT(relative_error(slip.force_deficit, exact.force_deficit()), tolerance);
}

// The exponents at and near which an antiderivative is a logarithm, and ordinary ones.
const std::vector<double> kExponents = {-4.0,         -3.5,        -3.0 - 1e-3, -3.0 - 1e-9, -3.0,
                                        -3.0 + 1e-12, -2.0 - 1e-6, -2.0,        -2.0 + 1e-9, -1.5,
                                        -1.0 - 1e-12, -1.0,        -1.0 + 1e-9, -1.0 + 1e-3, -0.5,
                                        0.0,          0.7,         2.0,         4.0};

TEST(PowerLaw, IsAccurateFromJustAboveItsStartToFarBeyondItsEnd) {
  for (const double exponent : kExponents) {
    for (const double from : {1.0 / 3.0, 7.3}) {
      if (from < 1.0 && !test::in_studies()) continue;  // the same on another scale
      for (const double reach : {1.5, 1000.0}) {
        const PowerLawPart part{0.01, exponent, from, from * reach};
        for (const double beyond :
             {1e-13, 1e-10, 1e-6, 1e-3, 0.1, 0.49, 0.5, 0.9, 0.999, 1.0, 1.5, 10.0, 999.0, 5e3}) {
          expect_accurate(part, from * (1.0 + beyond), kRounding);
        }
      }
    }
  }
}

// Exponents so steep that the part is almost an atom: (f/from)^χ is not smooth between from and 2
// from. The closed forms lose a factor |χ| there, pow() another: a few times 100·100·1e-16.
TEST(PowerLaw, IsAccurateWithSteepExponents) {
  for (const double exponent : {-100.0, -30.0, -10.0, 10.0, 30.0, 100.0}) {
    const PowerLawPart part{0.01, exponent, 2.0, 5.0};
    for (const double beyond : {1e-12, 1e-6, 1e-2, 0.05, 0.1, 0.3, 0.6, 0.95, 0.999, 1.0, 1.4}) {
      expect_accurate(part, 2.0 * (1.0 + beyond), 3e-12);
    }
  }
}

TEST(PowerLaw, IsAccurateFromZero) {
  for (const double exponent : {-0.999, -0.9, -0.5, -0.1, 0.0, 1.0, 3.0}) {
    const PowerLawPart part{0.01, exponent, 0.0, 25.0};
    for (const double s : {1e-12, 1e-3, 1.0, 24.9, 25.0, 25.1, 1e3}) {
      expect_accurate(part, s, kRounding);
    }
  }
}

TEST(PowerLaw, IsNothingUpToItsStart) {
  const PowerLawPart part{0.01, -1.0, 2.0, 5.0};
  for (const double s : {-1.0, 0.0, 1.0, 2.0}) {
    EXPECT_EQ(power_law_moments(part, s).zeroth, 0.0);
    EXPECT_EQ(power_law_moments(part, s).first, 0.0);
    EXPECT_EQ(power_law_moments(part, s).second, 0.0);
    EXPECT_EQ(power_law_force_deficit(part, s), 0.0);
    EXPECT_EQ(power_law_slip_energy(part, s), 0.0);
    EXPECT_EQ(power_law_slip(part, s).weight, 0.0);
    EXPECT_EQ(power_law_slip(part, s).force_deficit, 0.0);
  }
}

TEST(PowerLaw, MomentsAtInfinityAreThoseAtItsEnd) {
  const PowerLawPart part{0.01, -2.0, 2.0, 5.0};
  const PartialMoments total = power_law_moments(part, std::numeric_limits<double>::infinity());
  const PartialMoments end = power_law_moments(part, 5.0);
  EXPECT_EQ(total.zeroth, end.zeroth);
  EXPECT_EQ(total.first, end.first);
  EXPECT_EQ(total.second, end.second);
}

}  // namespace
}  // namespace microslip::power_law_test
