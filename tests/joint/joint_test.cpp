// SPDX-License-Identifier: MIT
#include "microslip/joint/joint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "support/figures.hpp"
#include "support/quadrature.hpp"
#include "support/reference_csv.hpp"

namespace microslip::joint_test {
namespace {

/// The joint [AR14] Fig. 3 is drawn for: φ = 0.1 f*^-0.5 on 0..25 N.
Joint power_law_joint() { return Joint(1000.0, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}})); }

/// One joint per kind of part, and a sum.
std::vector<Joint> all_kinds() {
  std::vector<Joint> joints;
  const double k = 1.5e5;
  joints.push_back(power_law_joint());
  joints.emplace_back(k, SlipDensity({UniformPart{0.0, 5.0, 1.0}}));
  joints.emplace_back(k, SlipDensity({UniformPart{2.0, 7.0, 0.8}}));
  joints.emplace_back(k, SlipDensity({PowerLawPart{0.1, -2.0, 0.5, 10.0}}));
  joints.emplace_back(
      k, SlipDensity({PiecewiseLinearPart{{0.0, 4.0, 4.5, 20.0}, {0.1, 0.05, 0.04, 0.0}}}));
  joints.emplace_back(k, SlipDensity({AtomsPart{{1.0, 8.0, 15.0}, {0.25, 0.35, 0.3}}}));
  joints.push_back(Joint::four_parameter(30.0, k, -0.3, 0.2));
  joints.emplace_back(k,
                      SlipDensity({UniformPart{2.0, 7.0, 0.2}, PowerLawPart{0.03, -0.5, 0.0, 25.0},
                                   PiecewiseLinearPart{{1.0, 3.0, 9.0}, {0.0, 0.05, 0.0}},
                                   AtomsPart{{5.0}, {0.2}}}));
  joints.emplace_back(k, SlipDensity());  // a linear spring
  return joints;
}

/// Displacements from deep in stick to beyond macro-slip, none on a knot.
std::vector<double> displacements(const Joint& joint) {
  std::vector<double> x;
  const double end = joint.density().largest_slip_force() > 0.0
                         ? joint.density().largest_slip_force() / joint.stiffness()
                         : 1.0;
  for (const double share : {1e-6, 0.01, 0.0987, 0.21, 0.35, 0.52, 0.77, 0.981, 1.1, 3.0}) {
    x.push_back(share * end);
  }
  return x;
}

// Closed forms by an independent program, printed with 12 to 16 digits; 1e-10 is asked of the
// library.
TEST(FourParameterJoint, AgreesWithIndependentValues) {
  const testing::ReferenceTable table = testing::reference_table("four_parameter.csv");
  ASSERT_EQ(table.rows(), 20U);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const Joint joint =
        Joint::four_parameter(table["macroslip_force [N]"][i], table["stiffness [N/m]"][i],
                              table["chi [1]"][i], table["beta [1]"][i]);
    const double x = table["displacement [m]"][i];
    const double force = table["virgin_force [N]"][i];
    const double energy = table["dissipation [J]"][i];
    const double end = table["macroslip_displacement [m]"][i];
    EXPECT_NEAR(joint.macroslip_displacement(), end, 1e-10 * end) << "row " << i;
    EXPECT_NEAR(joint.virgin_force(x), force, 1e-10 * force) << "row " << i;
    EXPECT_NEAR(dissipation(joint, x), energy, 1e-10 * energy) << "row " << i;
    test::record_deviation("force", joint.virgin_force(x), force);
    test::record_deviation("dissipation", dissipation(joint, x), energy);
  }
}

// [AR14 Fig. 3], values by an independent program: the slope d ln D/d ln f̄ = (D′/D)·(F/F′) from
// the library's derivatives. Near macro-slip F′ is a small difference, 0.02 k in the last row: 50
// roundings.
TEST(PowerLawJoint, SlopeOfDissipationOverForceAgreesWithIndependentValues) {
  const testing::ReferenceTable table = testing::reference_table("power_law_slope.csv");
  ASSERT_EQ(table.rows(), 10U);
  const Joint joint = power_law_joint();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double amplitude = table["amplitude [m]"][i];
    const double force = table["force_amplitude [N]"][i];
    const double energy = table["dissipation [J]"][i];
    const double slope = table["slope [1]"][i];
    EXPECT_NEAR(joint.virgin_force(amplitude), force, 1e-10 * force) << "row " << i;
    EXPECT_NEAR(dissipation(joint, amplitude), energy, 1e-10 * energy) << "row " << i;
    const double computed = dissipation_slope(joint, amplitude) / dissipation(joint, amplitude) *
                            joint.virgin_force(amplitude) / joint.tangent_stiffness(amplitude);
    EXPECT_NEAR(computed, slope, 1e-10 * slope) << "row " << i;
    test::record_deviation("slope", computed, slope);
    // The closed form of [AR14] for this joint, s = √(kA).
    const double s = std::sqrt(1000.0 * amplitude);
    EXPECT_NEAR(computed, 2.5 * (1.0 - 2.0 / 15.0 * s) / (1.0 - s / 5.0), 1e-10 * slope);
  }
}

// [AR14 (2)] with the library's own moments, which density_test checks by quadrature. F is a
// difference of terms up to kx: 1e-14 of kx.
TEST(Joint, VirginForceAndTangentFollowFromTheMoments) {
  for (const Joint& joint : all_kinds()) {
    for (const double x : displacements(joint)) {
      const double kx = joint.stiffness() * x;
      const PartialMoments moments = joint.density().moments(kx);
      EXPECT_NEAR(joint.virgin_force(x), moments.first + kx * (1.0 - moments.zeroth), 1e-14 * kx);
      EXPECT_NEAR(joint.tangent_stiffness(x), joint.stiffness() * (1.0 - moments.zeroth),
                  1e-14 * joint.stiffness());
    }
  }
}

// The same formulas, but the power in F from that in F′: a few rounding errors.
TEST(Joint, VirginCurveGivesForceAndSlopeAtOnce) {
  for (const Joint& joint : all_kinds()) {
    const VirginCurve& curve = joint.virgin_curve();
    EXPECT_EQ(curve.response(-1.0).force, curve.force(0.0));
    for (const double x : displacements(joint)) {
      const double s = joint.stiffness() * x;
      EXPECT_NEAR(curve.response(s).force, curve.force(s), 1e-14 * s);
      EXPECT_NEAR(curve.response(s).slope, curve.slope(s), 1e-14);
    }
  }
}

// F is the integral of F′; a quadrature cut at the knots, good to rounding.
TEST(Joint, TangentIsTheDerivativeOfTheVirginForce) {
  for (const Joint& joint : all_kinds()) {
    std::vector<double> knots;
    for (const auto& segment : joint.density().segments()) {
      knots.push_back(segment.start / joint.stiffness());
    }
    for (const PowerLawPart& part : joint.density().power_laws()) {
      knots.push_back(part.from / joint.stiffness());
      knots.push_back(part.to / joint.stiffness());
    }
    for (const double x : displacements(joint)) {
      const auto tangent = [&](long double at) {
        return joint.tangent_stiffness(static_cast<double>(at));
      };
      const auto force = static_cast<double>(testing::integrate(tangent, 0.0L, x, knots));
      EXPECT_NEAR(joint.virgin_force(x), force, 1e-14 * joint.stiffness() * x);
    }
  }
}

TEST(Joint, IsOddAndStartsAtRest) {
  for (const Joint& joint : all_kinds()) {
    EXPECT_EQ(joint.virgin_force(0.0), 0.0);
    for (const double x : displacements(joint)) {
      EXPECT_EQ(joint.virgin_force(-x), -joint.virgin_force(x));
      EXPECT_EQ(joint.tangent_stiffness(-x), joint.tangent_stiffness(x));
    }
  }
}

// Concave and rising: the tangent falls from k to what never slips, and is never negative.
TEST(Joint, TangentFallsFromStiffnessToElasticRemainder) {
  for (const Joint& joint : all_kinds()) {
    const double k = joint.stiffness();
    double previous = k;
    for (const double x : displacements(joint)) {
      const double tangent = joint.tangent_stiffness(x);
      EXPECT_LE(tangent, previous * (1.0 + 1e-15));
      EXPECT_GE(tangent, 0.0);
      previous = tangent;
    }
    EXPECT_NEAR(previous, k * joint.density().elastic_remainder(), 1e-15 * k);
  }
}

// [AR14 (1)]. Far beyond the end F is a difference of terms of size kx where there are power laws.
TEST(Joint, CarriesTheMacroslipForceAndNoMore) {
  for (const Joint& joint : all_kinds()) {
    if (joint.density().elastic_remainder() > 0.0) {
      EXPECT_EQ(joint.macroslip_displacement(), std::numeric_limits<double>::infinity());
      continue;
    }
    const double end = joint.macroslip_displacement();
    const double limit = joint.macroslip_force();
    EXPECT_NEAR(joint.virgin_force(end), limit, 1e-13 * limit);
    EXPECT_NEAR(joint.virgin_force(100.0 * end), limit, 1e-13 * limit);
    EXPECT_LT(joint.virgin_force(0.9 * end), limit);
  }
  EXPECT_DOUBLE_EQ(power_law_joint().macroslip_force(), 25.0 / 3.0);
}

// Each knot of a cubic is found, however uneven: the table of buckets has 64 per knot at most, and
// here the narrowest gap is 1e-12 of the range. The reference steps through the knots.
TEST(Joint, FindsTheRightSegmentAmongUnevenKnots) {
  RandomStream random(3, 0);
  PiecewiseLinearPart part;
  double knot = 0.0;
  for (int i = 0; i < 60; ++i) {
    part.slip_force.push_back(knot);
    part.density.push_back(1e-3 * random.uniform());
    knot += std::pow(10.0, -10.0 + 12.0 * random.uniform());
  }
  const Joint joint(1.0, SlipDensity({part}));
  const auto check = [&](double s) {
    double slope = 1.0;
    for (std::size_t i = 0; i + 1 < part.slip_force.size() && part.slip_force[i] < s; ++i) {
      const double width = part.slip_force[i + 1] - part.slip_force[i];
      const double t = std::min(s - part.slip_force[i], width);
      slope -= t * (part.density[i] + 0.5 * t / width * (part.density[i + 1] - part.density[i]));
    }
    EXPECT_NEAR(joint.tangent_stiffness(s), slope, 1e-14) << "s = " << s;
  };
  for (const double s : part.slip_force) {
    check(s);
    check(std::nextafter(s, 0.0));
    check(std::nextafter(s, 1e9));
  }
  for (int i = 0; i < 2000; ++i) check(1.1 * knot * random.uniform());
}

std::string message_of(double stiffness, const SlipDensity& density) {
  try {
    const Joint joint(stiffness, density);
  } catch (const InputError& error) {
    EXPECT_EQ(error.name(), "stiffness");
    return error.what();
  }
  return "accepted";
}

TEST(Joint, NamesTheRuleThatAStiffnessBreaks) {
  const std::string rule = "must be positive and finite, in N/m";
  EXPECT_EQ(message_of(0.0, {}), "stiffness = 0; " + rule);
  EXPECT_EQ(message_of(-1.0, {}), "stiffness = -1; " + rule);
  EXPECT_EQ(message_of(std::numeric_limits<double>::infinity(), {}), "stiffness = inf; " + rule);
  EXPECT_EQ(message_of(std::numeric_limits<double>::quiet_NaN(), {}), "stiffness = nan; " + rule);
  EXPECT_EQ(message_of(2.0, SlipDensity({FourParameterPart{1.0, 3.0, -0.5, 1.0}})),
            "stiffness = 2; must equal K_T = 3 of its four-parameter density");
}

}  // namespace
}  // namespace microslip::joint_test
