// SPDX-License-Identifier: MIT
#include "microslip/joint/normal_load_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip::normal_load_scale_test {
namespace {

/// Of each kind of part.
std::vector<Joint> joints() {
  return {Joint(0.25, SlipDensity({AtomsPart{{0.2, 0.3}, {0.5, 0.4}}})),
          Joint::four_parameter(0.2, 0.25, -0.5, 0.3),
          Joint(1.0, SlipDensity({UniformPart{0.1, 0.5, 0.9}})),
          Joint(3.0, SlipDensity({PowerLawPart{0.3, -0.4, 0.0, 2.0}})),
          Joint(2.0, SlipDensity({PiecewiseLinearPart{{0.0, 0.1, 0.5}, {1.0, 2.5, 1.0}}}))};
}

// F_s(x) = s F(x/s) and D_s(A) = s² D(A/s) by what the class says, to rounding of powers and sums.
TEST(NormalLoadScale, StretchesTheVirginCurveBothWays) {
  for (const Joint& joint : joints()) {
    for (const double s : {0.3, 1.0, 1.7}) {
      const Joint scaled = with_normal_load(joint, s);
      EXPECT_EQ(scaled.stiffness(), joint.stiffness());
      for (const double x : {1e-3, 0.1, 0.4, 1.0, 5.0}) {
        EXPECT_NEAR(scaled.virgin_force(x), s * joint.virgin_force(x / s),
                    1e-12 * joint.stiffness() * x);
        EXPECT_NEAR(dissipation(scaled, x), s * s * dissipation(joint, x / s),
                    1e-12 * joint.stiffness() * x * x);
      }
    }
  }
}

TEST(NormalLoadScale, RefusesWhatIsNoLoad) {
  for (const double s : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(static_cast<void>(with_normal_load(joints()[0], s)), InputError) << s;
  }
}

}  // namespace
}  // namespace microslip::normal_load_scale_test
