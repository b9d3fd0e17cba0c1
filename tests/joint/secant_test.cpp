// SPDX-License-Identifier: MIT
#include "microslip/joint/secant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"
#include "support/exact_density.hpp"
#include "support/quadrature.hpp"

namespace microslip::secant_test {
namespace {

using std::numbers::pi;
using std::numbers::pi_v;

/// g(ρ) in long double, the textbook form; its cancellation is removed by a series below ρ = 1e-4,
/// of which the next term is ρ³ of the first.
long double exact_secant(long double rho) {
  constexpr long double kPi = pi_v<long double>;
  if (rho < 1e-4L) {  // ∫ (8/π)√(ρ(1 − ρ)) dρ
    const long double r = std::sqrt(rho);
    return 8.0L / kPi * rho * r *
           (2.0L / 3.0L - rho / 5.0L - rho * rho / 28.0L - rho * rho * rho / 72.0L);
  }
  const long double theta = std::acos(1.0L - 2.0L * rho);
  return (theta - 0.5L * std::sin(2.0L * theta)) / kPi;
}

/// A saw-tooth of the density over `count` segments of a width.
PiecewiseLinearPart saw_tooth(double from, double width, int count) {
  PiecewiseLinearPart part;
  for (int i = 0; i <= count; ++i) {
    part.slip_force.push_back(from + width * i);
    part.density.push_back(i % 2 == 0 ? 0.01 : 0.5 / (width * count));
  }
  return part;
}

struct Case {
  std::string name;
  SlipDensity density;
};

std::vector<Case> cases() {
  const UniformPart uniform{2.0, 7.0, 0.3};
  const PiecewiseLinearPart linear{{0.0, 3.0, 3.5, 9.0, 20.0}, {0.05, 0.06, 0.01, 0.01, 0.0}};
  const AtomsPart atoms{{1.0, 8.0, 15.0}, {0.05, 0.1, 0.08}};
  std::vector<Case> all;
  const auto add = [&](const std::string& name, std::vector<DensityPart> parts) {
    all.push_back({name, SlipDensity(std::move(parts))});
  };
  add("nothing", {});
  add("uniform from 0", {UniformPart{0.0, 5.0, 1.0}});
  add("uniform", {uniform});
  for (const double exponent : {-0.99, -0.5, 0.0, 1.5}) {
    add("power law from 0", {PowerLawPart{2e-4, exponent, 0.0, 25.0}});
  }
  for (const double exponent : {-3.0, -2.0, -1.0, 0.5}) {
    add("power law above 0", {PowerLawPart{0.02, exponent, 0.5, 10.0}});
  }
  add("piecewise linear", {linear});
  add("segments of 0.01 rad", {saw_tooth(0.0, 0.1, 100)});
  add("segments below 1e-4 rad", {saw_tooth(4.0, 1e-4, 100)});
  add("atoms", {atoms});
  add("four-parameter", {FourParameterPart{30.0, 1e5, -0.3, 0.2}});
  add("sum", {uniform, linear, atoms, PowerLawPart{0.01, -1.0, 0.5, 10.0},
              PowerLawPart{0.002, -0.5, 0.0, 25.0}});
  return all;
}

/// 1 - Φ0(s) + ∫₀ˢ φ g(f*/s) df* by quadrature.
double exact_share(const SlipDensity& density, double s) {
  const testing::ExactDensity exact(density);
  const auto share =
      static_cast<double>(exact.integral([&](long double f) { return exact_secant(f / s); }, s));
  if (s >= density.largest_slip_force()) return share + density.elastic_remainder();
  return share + (1.0 - density.moments(s).zeroth);
}

const std::vector<double> kSlipForces = {1e-3, 0.3,  0.52, 1.0,  1.02, 2.2,  3.4,
                                         8.0,  13.0, 20.1, 24.9, 26.0, 100.0};

// ---- One element. ----

// The closed form of the describing function of one Jenkins element: stiffness κ, slip at x_s < A.
// Tolerance: rounding of acos and of the sum.
TEST(SecantStiffness, OfOneJenkinsElement) {
  const double k = 3.0;
  const Joint joint(k, SlipDensity({AtomsPart{{6.0}, {0.5}}}));
  const double kappa = 1.5;
  const double slip = 2.0;
  for (const double a : {0.1, 1.99}) EXPECT_DOUBLE_EQ(secant_stiffness(joint, a), k);
  for (const double a : {2.0, 2.1, 4.0, 10.0, 300.0}) {
    const double theta = std::acos(1.0 - 2.0 * slip / a);
    const double element = kappa / pi * (theta - 0.5 * std::sin(2.0 * theta));
    EXPECT_NEAR(secant_stiffness(joint, a), 0.5 * k + element, 1e-14 * k) << a;
    const double energy = 4.0 * kappa * slip * (a - slip);
    EXPECT_NEAR(loss_factor(joint, a), energy / (pi * (0.5 * k + element) * a * a), 1e-14) << a;
  }
}

// y - sin y by its series below y = 0.1; above, the difference loses a factor of up to 600.
TEST(JenkinsSecant, IsAccurateForSmallArguments) {
  for (const double rho : {1e-300, 1e-20, 1e-10, 1e-6, 5e-5, 1e-3, 1e-2, 0.1, 0.3, 0.5, 0.9, 1.0}) {
    const auto exact = static_cast<double>(exact_secant(rho));
    EXPECT_NEAR(jenkins_secant(rho), exact, 1e-13 * exact) << rho;
  }
  EXPECT_EQ(jenkins_secant(0.0), 0.0);
  EXPECT_EQ(jenkins_secant(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(jenkins_secant(1.0), 1.0);
  EXPECT_DOUBLE_EQ(jenkins_secant(2.0), 1.0);
}

// ---- Densities. ----

// Tolerance: that of the adaptive quadrature over a power law above 0 (1e-13); all else rounds.
TEST(SecantStiffness, IsTheIntegralOverTheDensity) {
  const double k = 0x1p17;  // a power of two: kA exact
  for (const auto& [name, density] : cases()) {
    if (name == "four-parameter") continue;  // has a stiffness of its own; below
    const Joint joint(k, density);
    for (const double s : kSlipForces) {
      const double share = exact_share(density, s);
      EXPECT_NEAR(secant_stiffness(joint, s / k), k * share, 2e-13 * k * share)
          << name << ", s = " << s;
    }
  }
}

// The incomplete beta function against quadrature, from deep in stick to far in macro-slip, where
// k_eq is 1e-5 k and less: the tolerance is relative all the same. With p = χ + 1 the form is a
// difference over p and loses a factor 1/p.
TEST(SecantStiffness, OfAPowerLawFromZero) {
  for (const double exponent : {-0.999, -0.9, -0.5, -0.1, 0.0, 0.8}) {
    const double coefficient = (exponent + 1.0) / std::pow(8.0, exponent + 1.0);  // area 1
    const SlipDensity density({PowerLawPart{coefficient, exponent, 0.0, 8.0}});
    const Joint joint(1.0, density);
    for (const double s : {1e-6, 1e-3, 0.5, 4.0, 7.99, 8.0, 8.01, 20.0, 1e3, 1e4}) {
      const double share = exact_share(density, s);
      EXPECT_NEAR(secant_stiffness(joint, s), share, 1e-13 / (exponent + 1.0) * share)
          << exponent << ", s = " << s;
    }
  }
}

// (1/(πA)) ∮ f cosθ dθ over a steady cycle x = A cosθ, f from a Memory that has been through one:
// by symmetry twice the unloading branch. The integrand is cut where an element starts to slip, and
// then smooth; f is in double, so that the sum is good to 1e-15 of kA.
TEST(SecantStiffness, IsTheFirstHarmonicOfTheMemorysForce) {
  const double k = 1e5;
  for (const auto& [name, density] : cases()) {
    const Joint joint(k, density);
    for (const double s : {0.3, 1.02, 3.4, 13.0, 26.0, 60.0}) {
      const double a = s / k;
      Memory memory(joint);
      for (const double x : {a, -a, a}) memory.advance(x);
      std::vector<double> angles;
      for (const double knot : testing::ExactDensity(density).kinks()) {
        if (knot < s) angles.push_back(2.0 * std::asin(std::sqrt(knot / s)));
      }
      const auto integrand = [&](long double theta) {
        const auto x = static_cast<double>(a * std::cos(theta));
        return memory.trial(x).force * std::cos(theta);
      };
      const long double integral = testing::integrate(integrand, 0.0L, pi_v<long double>, angles);
      const auto expected = static_cast<double>(2.0L * integral / (pi_v<long double> * a));
      EXPECT_NEAR(secant_stiffness(joint, a), expected, 1e-13 * k) << name << ", s = " << s;
    }
  }
}

// A step of φ is written as two knots close to each other: the closer, the nearer to a true step.
// k_eq changes by less than φ·(kA)·width between the two.
TEST(SecantStiffness, TakesAStepWrittenAsTwoCloseKnots) {
  const double k = 1e5;
  const Joint step(k, SlipDensity({UniformPart{0.0, 10.0, 0.9}}));
  for (const double width : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    // No fourth knot of zero: with AVX-512, GCC 12.2 writes constants {a, a, 0, 0} as {a, a, a, a}.
    const Joint ramp(
        k, SlipDensity({PiecewiseLinearPart{{0.0, 10.0, 10.0 + width}, {0.09, 0.09, 0.0}}}));
    for (const double a : {1.01e-4, 3e-4, 1e-3}) {
      EXPECT_NEAR(secant_stiffness(ramp, a), secant_stiffness(step, a), k * (0.09 * width + 1e-14))
          << width << ", " << a;
    }
  }
}

// Far in macro-slip k_eq is a small number of which the parts must not be lost in rounding of 1.
TEST(SecantStiffness, KeepsItsDigitsInMacroslip) {
  const std::vector<SlipDensity> densities = {
      SlipDensity({UniformPart{0.0, 10.0, 1.0}}),
      SlipDensity(
          {PiecewiseLinearPart{{0.0, 4.0, 10.0}, {0.15, 0.1, 0.0}}, AtomsPart{{5.0}, {0.2}}}),
      SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}})};
  for (const SlipDensity& density : densities) {
    const Joint joint(1.0, density);
    ASSERT_EQ(density.elastic_remainder(), 0.0);
    for (const double a : {1e2, 1e3, 1e4, 1e5}) {
      const double share = exact_share(density, a);
      EXPECT_NEAR(secant_stiffness(joint, a), share, 1e-13 * share) << a;
      EXPECT_NEAR(loss_factor(joint, a), dissipation(joint, a) / (pi * share * a * a),
                  1e-13 * loss_factor(joint, a));
    }
  }
}

// At small amplitude nothing slips; k_eq falls as A rises, and never below the elastic remainder.
TEST(SecantStiffness, FallsFromTheStiffnessOfTheStuckJoint) {
  const double k = 1e5;
  for (const auto& [name, density] : cases()) {
    const Joint joint(k, density);
    EXPECT_EQ(secant_stiffness(joint, 0.0), k) << name;
    // The slipped weight at kA = 1e-9 N is at most the weight below, and above it the change is
    // smaller.
    EXPECT_NEAR(secant_stiffness(joint, 1e-9 / k), k, k * (density.moments(1e-9).zeroth + 1e-15))
        << name;
    double previous = k;
    for (double s = 0.01; s < 1e4; s *= 1.1) {
      const double secant = secant_stiffness(joint, s / k);
      EXPECT_LE(secant, previous + 1e-14 * k) << name << ", s = " << s;
      EXPECT_GE(secant, k * density.elastic_remainder()) << name << ", s = " << s;
      previous = secant;
    }
  }
}

TEST(LossFactor, IsDissipationOverStoredEnergy) {
  for (const auto& [name, density] : cases()) {
    const Joint joint(1e5, density);
    EXPECT_EQ(loss_factor(joint, 0.0), 0.0);
    for (const double s : kSlipForces) {
      const double a = s / 1e5;
      const double expected = dissipation(joint, a) / (pi * secant_stiffness(joint, a) * a * a);
      EXPECT_DOUBLE_EQ(loss_factor(joint, a), expected) << name << ", s = " << s;
    }
  }
}

TEST(SecantStiffness, RejectsAnAmplitudeThatIsNone) {
  const Joint joint(1.0, SlipDensity());
  for (const double amplitude :
       {-1e-9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (auto* function : {&secant_stiffness, &loss_factor}) {
      EXPECT_THROW((void)function(joint, amplitude), InputError);
    }
  }
}

}  // namespace
}  // namespace microslip::secant_test
