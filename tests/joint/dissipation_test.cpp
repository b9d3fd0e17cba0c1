// SPDX-License-Identifier: MIT
#include "microslip/joint/dissipation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/exact_density.hpp"
#include "support/exact_power_law.hpp"

namespace microslip::dissipation_test {
namespace {

constexpr double kStiffness = 0x1p14;  // N/m; a power of two, so that kA has no rounding

struct Case {
  std::string name;
  SlipDensity density;
};

std::vector<Case> cases() {
  const UniformPart uniform{2.0, 7.0, 0.3};
  const PiecewiseLinearPart linear{{1.0, 3.0, 3.5, 9.0, 20.0}, {0.0, 0.06, 0.01, 0.01, 0.0}};
  const AtomsPart atoms{{1.0, 8.0, 15.0}, {0.05, 0.1, 0.08}};
  std::vector<Case> all;
  const auto add = [&](const std::string& name, std::vector<DensityPart> parts) {
    all.push_back({name, SlipDensity(std::move(parts))});
  };
  add("uniform from 0", {UniformPart{0.0, 5.0, 1.0}});
  add("uniform", {uniform});
  for (const double exponent : {-0.999, -0.5, 0.0, 1.5}) {
    add("power law from 0", {PowerLawPart{2e-4, exponent, 0.0, 25.0}});
  }
  for (const double exponent : {-3.5, -3.0, -3.0 + 1e-8, -2.0 - 1e-10, -2.0, -1.5, -1.0 - 1e-6,
                                -1.0, -1.0 + 1e-12, -0.3, 0.5}) {
    add("power law above 0", {PowerLawPart{0.02, exponent, 0.5, 10.0}});
  }
  add("piecewise linear", {linear});
  add("atoms", {atoms});
  add("four-parameter", {FourParameterPart{30.0, kStiffness, -0.3, 0.2}});
  add("sum", {uniform, linear, atoms, PowerLawPart{0.01, -1.0, 0.5, 10.0},
              PowerLawPart{0.002, -0.5, 0.0, 25.0}});
  return all;
}

const std::vector<double> kSlipForces = {1e-3, 0.3, 0.52, 1.0,  1.02, 2.2,  3.4,  6.0,
                                         8.0,  9.5, 13.0, 20.1, 24.9, 26.0, 100.0};

// [AR14 (7)], by the tanh-sinh rule of the tests. It and the closed form round a few times; the
// parts of a sum are all positive.
TEST(Dissipation, IsTheIntegralOverTheDensity) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    const testing::ExactDensity exact(density);
    for (const double s : kSlipForces) {
      const double a = s / kStiffness;
      const auto weight = [&](long double f) { return 4.0L * f * (a - f / kStiffness); };
      const double expected = static_cast<double>(exact.integral(weight, s));
      EXPECT_NEAR(dissipation(joint, a), expected, 1e-13 * expected) << name << ", s = " << s;
    }
  }
}

// [AR14 (8)].
TEST(Dissipation, SlopeIsFourFirstMoments) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    const testing::ExactDensity exact(density);
    for (const double s : kSlipForces) {
      const double a = s / kStiffness;
      const auto weight = [](long double f) { return 4.0L * f; };
      const double expected = static_cast<double>(exact.integral(weight, s));
      EXPECT_NEAR(dissipation_slope(joint, a), expected, 1e-13 * expected) << name << ", s = " << s;
    }
  }
}

// D′ and D″ against central differences of D and D′, at amplitudes whose neighbourhood
// contains no kink. With h = 1e-4 A the error is h²/6 of the third derivative over the first, of
// order 1e-8 A²/A², here times up to about 20 for steep laws; rounding adds 1e-16/1e-4.
TEST(Dissipation, SlopeAndCurvatureAreDerivatives) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    for (const double s : {0.3, 0.7, 1.5, 2.5, 3.2, 6.0, 8.3, 9.4, 12.0, 17.0, 30.0}) {
      const double a = s / kStiffness;
      const double h = 1e-4 * a;
      const double slope = (dissipation(joint, a + h) - dissipation(joint, a - h)) / (2.0 * h);
      const double curvature =
          (dissipation_slope(joint, a + h) - dissipation_slope(joint, a - h)) / (2.0 * h);
      EXPECT_NEAR(dissipation_slope(joint, a), slope, 2e-7 * slope) << name << ", s = " << s;
      // In units of D′/A, which D″ vanishes against where there is no density.
      EXPECT_NEAR(dissipation_curvature(joint, a), curvature,
                  2e-7 * curvature + 1e-11 * dissipation_slope(joint, a) / a)
          << name << ", s = " << s;
    }
  }
}

// [AR14 (4)] in [AR14 (9)]: D″ = -4A F″, with F″ from central differences of F′ (same tolerance as
// above).
TEST(Dissipation, CurvatureIsThatOfTheVirginCurve) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    for (const double s : {0.3, 0.7, 1.5, 2.5, 3.2, 6.0, 8.3, 9.4, 12.0, 17.0, 30.0}) {
      const double a = s / kStiffness;
      const double h = 1e-4 * a;
      const double second =
          (joint.tangent_stiffness(a + h) - joint.tangent_stiffness(a - h)) / (2.0 * h);
      EXPECT_NEAR(dissipation_curvature(joint, a), -4.0 * a * second,
                  2e-7 * dissipation_curvature(joint, a) + 4e-11 * kStiffness)
          << name << ", s = " << s;
    }
  }
}

// A chord of a convex function lies above it; equality within rounding where D is straight.
TEST(Dissipation, IsConvexAndRisesFromZero) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    EXPECT_EQ(dissipation(joint, 0.0), 0.0);
    EXPECT_EQ(dissipation_slope(joint, 0.0), 0.0);
    const double h = 0.05 / kStiffness;
    for (int i = 1; i < 700; ++i) {
      const double middle = dissipation(joint, i * h);
      const double chord =
          0.5 * (dissipation(joint, (i - 1) * h) + dissipation(joint, (i + 1) * h));
      EXPECT_LE(middle, chord + 1e-14 * middle) << name << ", s = " << 0.05 * i;
      EXPECT_GE(middle, dissipation(joint, (i - 1) * h)) << name << ", s = " << 0.05 * i;
    }
  }
}

// In macro-slip D is a straight line of slope 4 f_y.
TEST(Dissipation, SlopeTendsToFourMacroslipForces) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(kStiffness, density);
    const double a = 1.01 * density.largest_slip_force() / kStiffness;
    const double slope = 4.0 * joint.macroslip_force();
    EXPECT_NEAR(dissipation_slope(joint, a), slope, 1e-14 * slope) << name;
    EXPECT_NEAR(dissipation(joint, 2.0 * a) - dissipation(joint, a), slope * a, 1e-14 * slope * a)
        << name;
    EXPECT_EQ(dissipation_curvature(joint, a), 0.0) << name;
  }
}

TEST(Dissipation, SlopeJumpsAtAnAtomAndDissipationDoesNot) {
  const double weight = 0.1;
  const double f = 8.0;
  const Joint joint(1.0, SlipDensity({UniformPart{0.0, 20.0, 0.5}, AtomsPart{{f}, {weight}}}));
  const double below = std::nextafter(f, 0.0);
  EXPECT_NEAR(dissipation_slope(joint, f) - dissipation_slope(joint, below), 4.0 * weight * f,
              1e-14 * 4.0 * weight * f);
  EXPECT_NEAR(dissipation(joint, f), dissipation(joint, below), 1e-14 * dissipation(joint, f));
  EXPECT_DOUBLE_EQ(dissipation_curvature(joint, f),
                   4.0 * f * 0.5 / 20.0);  // without its Dirac term
}

// One Jenkins element of stiffness κ that slips at x_s: D = 4κx_s(A - x_s).
TEST(Dissipation, OfOneJenkinsElement) {
  const Joint joint(3.0, SlipDensity({AtomsPart{{6.0}, {0.5}}}));  // κ = 1.5 N/m, x_s = 2 m
  EXPECT_EQ(dissipation(joint, 1.9), 0.0);
  EXPECT_EQ(dissipation(joint, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(dissipation(joint, 5.0), 4.0 * 1.5 * 2.0 * 3.0);
}

// Just above the smallest slip force AΦ1 and Φ2/k agree in almost all their digits. 100 digits are
// the reference; the tolerance, ninety rounding errors, is that of power_law_test.
TEST(Dissipation, KeepsItsDigitsJustAboveTheSmallestSlipForce) {
  const double k = kStiffness;
  for (const double exponent : {-3.0, -2.0 + 1e-9, -1.0, -0.5, 0.0, 1.0}) {
    const PowerLawPart part{0.005, exponent, 7.3, 20.0};
    const Joint joint(k, SlipDensity({part}));
    for (const double beyond : {1e-13, 1e-10, 1e-7, 1e-4, 0.1, 0.5, 0.95, 1.2}) {
      const double s = part.from * (1.0 + beyond);
      const testing::ExactPowerLaw exact(part, s);
      EXPECT_LT(testing::relative_error(dissipation(joint, s / k), 4 * exact.slip_energy() / k),
                2e-14)
          << exponent << ", " << beyond;
      EXPECT_LT(testing::relative_error(dissipation_slope(joint, s / k), 4 * exact.moment(1)),
                2e-14)
          << exponent << ", " << beyond;
    }
  }
  // A uniform part and an atom: closed forms in s - from.
  const double from = 7.3;
  const Joint uniform(k, SlipDensity({UniformPart{from, 20.0, 0.5}}));
  const Joint atom(k, SlipDensity({AtomsPart{{from}, {0.5}}}));
  for (const double beyond : {1e-13, 1e-10, 1e-7, 1e-4, 0.1}) {
    const double s = from * (1.0 + beyond);
    const testing::Exact t = testing::Exact(s) - from;
    const testing::Exact phi = testing::Exact(0.5) / (testing::Exact(20) - from);
    EXPECT_LT(testing::relative_error(dissipation(uniform, s / k),
                                      4 * phi * (from * t * t / 2 + t * t * t / 6) / k),
              2e-15);
    EXPECT_LT(
        testing::relative_error(dissipation(atom, s / k), 4 * 0.5 * testing::Exact(from) * t / k),
        2e-15);
  }
}

TEST(Dissipation, RejectsAnAmplitudeThatIsNone) {
  const Joint joint(1.0, SlipDensity());
  for (const double amplitude :
       {-1e-9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (auto* function : {&dissipation, &dissipation_slope, &dissipation_curvature}) {
      try {
        (void)function(joint, amplitude);
        ADD_FAILURE() << "accepted " << amplitude;
      } catch (const InputError& error) {
        EXPECT_EQ(error.name(), "amplitude");
        EXPECT_NE(std::string(error.what()).find("must be 0 m or more, and finite"),
                  std::string::npos);
      }
    }
  }
}

}  // namespace
}  // namespace microslip::dissipation_test
