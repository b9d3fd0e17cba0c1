// SPDX-License-Identifier: MIT
#include "microslip/joint/density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/joint.hpp"
#include "support/exact_density.hpp"

namespace microslip::density_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// φ of each kind of part that has no atom, and sums of them; total weights below 1.
std::vector<std::vector<DensityPart>> continuous_densities() {
  const UniformPart uniform{2.0, 7.0, 0.3};
  const PowerLawPart from_zero{0.03, -0.5, 0.0, 25.0};
  const PowerLawPart inverse{0.1, -1.0, 0.5, 10.0};
  const PiecewiseLinearPart linear{{1.0, 3.0, 3.5, 9.0, 20.0}, {0.0, 0.06, 0.01, 0.01, 0.0}};
  return {{uniform},
          {from_zero},
          {PowerLawPart{0.001, -0.99, 0.0, 25.0}},
          {inverse},
          {PowerLawPart{0.1, -2.0, 0.5, 10.0}},
          {PowerLawPart{0.1, -3.0, 0.5, 10.0}},
          {PowerLawPart{1e-4, 1.5, 0.0, 12.0}},
          {linear},
          {uniform, from_zero, linear},
          {uniform, UniformPart{5.0, 12.0, 0.1}, inverse, linear}};
}

// Tolerance: the tanh-sinh rule is good to 1e-17; the closed forms round a few times.
TEST(SlipDensity, MomentsAreIntegralsOfTheDensity) {
  for (const auto& parts : continuous_densities()) {
    const SlipDensity density(parts);
    const testing::ExactDensity exact(density);
    for (const double s : {0.3, 0.7, 1.0, 2.5, 3.2, 6.0, 8.0, 15.0, 30.0}) {
      const PartialMoments moments = density.moments(s);
      const double closed[] = {moments.zeroth, moments.first, moments.second};
      for (int n = 0; n < 3; ++n) {
        const auto weight = [&](long double f) { return std::pow(f, n); };
        const auto expected = static_cast<double>(exact.integral(weight, s));
        EXPECT_NEAR(closed[n], expected, 1e-13 * expected) << "s = " << s << ", n = " << n;
      }
    }
  }
}

TEST(SlipDensity, DensityIsTheSumOfItsParts) {
  for (const auto& parts : continuous_densities()) {
    const SlipDensity density(parts);
    const testing::ExactDensity exact(density);
    for (const double f : {1e-3, 0.3, 0.7, 1.0, 2.5, 3.2, 6.0, 8.0, 15.0, 30.0}) {
      EXPECT_NEAR(density.density(f), static_cast<double>(exact(f)), 1e-14 * density.density(f));
    }
  }
}

TEST(SlipDensity, DensityAddsPartsAndTakesTheValueAboveAStep) {
  const SlipDensity density({UniformPart{2.0, 7.0, 0.5}, PowerLawPart{0.02, -0.5, 1.0, 4.0},
                             PiecewiseLinearPart{{0.0, 2.0, 4.0}, {0.1, 0.0, 0.05}},
                             AtomsPart{{3.0}, {0.1}}});
  EXPECT_EQ(density.density(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(density.density(0.0), 0.1);
  EXPECT_DOUBLE_EQ(density.density(0.5), 0.075);
  EXPECT_DOUBLE_EQ(density.density(1.0), 0.05 + 0.02);
  EXPECT_DOUBLE_EQ(density.density(2.0), 0.1 + 0.02 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(density.density(3.0), 0.1 + 0.025 + 0.02 / std::sqrt(3.0));  // no Dirac term
  EXPECT_DOUBLE_EQ(density.density(4.0), 0.1);
  EXPECT_DOUBLE_EQ(density.density(6.5), 0.1);
  EXPECT_EQ(density.density(7.0), 0.0);
  EXPECT_EQ(density.density(kInfinity), 0.0);
}

TEST(SlipDensity, AtomsCountFromTheirSlipForceOn) {
  const SlipDensity density({AtomsPart{{3.0, 1.0, 3.0}, {0.2, 0.1, 0.3}}});
  ASSERT_EQ(density.atoms().slip_force, (std::vector<double>{1.0, 3.0}));  // sorted, merged
  EXPECT_EQ(density.moments(std::nextafter(1.0, 0.0)).zeroth, 0.0);
  EXPECT_DOUBLE_EQ(density.moments(1.0).zeroth, 0.1);
  EXPECT_DOUBLE_EQ(density.moments(std::nextafter(3.0, 0.0)).first, 0.1);
  EXPECT_DOUBLE_EQ(density.moments(3.0).zeroth, 0.6);
  EXPECT_DOUBLE_EQ(density.moments(3.0).first, 0.1 + 1.5);
  EXPECT_DOUBLE_EQ(density.moments(3.0).second, 0.1 + 4.5);
  EXPECT_EQ(density.density(3.0), 0.0);
}

TEST(SlipDensity, TotalsAreTheMomentsAtInfinity) {
  for (const auto& parts : continuous_densities()) {
    const SlipDensity density(parts);
    const PartialMoments at_infinity = density.moments(kInfinity);
    const PartialMoments beyond = density.moments(1e3);
    EXPECT_EQ(density.total().zeroth, at_infinity.zeroth);
    EXPECT_EQ(density.total().first, at_infinity.first);
    EXPECT_EQ(density.total().second, at_infinity.second);
    EXPECT_DOUBLE_EQ(beyond.zeroth, at_infinity.zeroth);
    EXPECT_DOUBLE_EQ(beyond.first, at_infinity.first);
    EXPECT_DOUBLE_EQ(beyond.second, at_infinity.second);
    for (const double s : {0.0, -1.0, -kInfinity}) {
      EXPECT_EQ(density.moments(s).zeroth, 0.0);
      EXPECT_EQ(density.moments(s).first, 0.0);
      EXPECT_EQ(density.moments(s).second, 0.0);
    }
  }
}

TEST(SlipDensity, ElasticRemainderIsWhatHasNoSlipForce) {
  EXPECT_EQ(SlipDensity().elastic_remainder(), 1.0);
  EXPECT_EQ(SlipDensity().largest_slip_force(), 0.0);
  EXPECT_DOUBLE_EQ(SlipDensity({UniformPart{0.0, 5.0, 0.8}}).elastic_remainder(), 0.2);
  EXPECT_DOUBLE_EQ(
      SlipDensity({UniformPart{0.0, 5.0, 0.5}, AtomsPart{{9.0}, {0.25}}}).elastic_remainder(),
      0.25);
  // Ten tenths do not add up to 1 in floating point; nothing is left all the same.
  const std::vector<DensityPart> tenths(10, UniformPart{0.0, 3.0, 0.1});
  EXPECT_EQ(SlipDensity(tenths).elastic_remainder(), 0.0);
  // [AR14 Fig. 3]: 0.1 f*^-0.5 on 0..25 N has area 1 and f_y = 25/3 N.
  const SlipDensity power_law({PowerLawPart{0.1, -0.5, 0.0, 25.0}});
  EXPECT_EQ(power_law.elastic_remainder(), 0.0);
  EXPECT_DOUBLE_EQ(power_law.total().first, 25.0 / 3.0);
}

TEST(SlipDensity, LargestSlipForceIsWhereTheDensityEnds) {
  EXPECT_EQ(
      SlipDensity({UniformPart{0.0, 5.0, 0.5}, AtomsPart{{9.0}, {0.25}}}).largest_slip_force(),
      9.0);
  EXPECT_EQ(SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}).largest_slip_force(), 25.0);
  EXPECT_EQ(SlipDensity({PiecewiseLinearPart{{0.0, 4.0, 6.0, 8.0}, {0.1, 0.0, 0.0, 0.0}}})
                .largest_slip_force(),
            4.0);
  EXPECT_EQ(
      SlipDensity({UniformPart{0.0, 5.0, 0.5}, UniformPart{0.0, 9.0, 0.0}}).largest_slip_force(),
      5.0);
  // An atom without weight is none: an identification may leave it at a bound.
  EXPECT_EQ(SlipDensity({AtomsPart{{1.0, 5.0}, {1.0, 0.0}}}).largest_slip_force(), 1.0);
  EXPECT_EQ(Joint(2.0, SlipDensity({AtomsPart{{1.0, 5.0}, {1.0, 0.0}}})).macroslip_displacement(),
            0.5);
}

// The definitions of theory: Rψ^χ on [0, ψ_max] and S at ψ_max make F_S and K_T
// [Segalman, J. Appl. Mech. 72 (2005) 752].
TEST(SlipDensity, FourParameterPartHasAreaOneAndItsMacroslipForce) {
  for (const double chi : {-0.99, -0.5, -0.1, 0.0}) {
    for (const double beta : {0.0, 0.005, 1.0, 30.0}) {
      const FourParameterPart part{400.0, 2.5e5, chi, beta};
      const SlipDensity density({part});
      EXPECT_NEAR(density.total().zeroth, 1.0, 1e-14);
      EXPECT_NEAR(density.total().first, 400.0, 400.0 * 1e-14);
      EXPECT_EQ(density.elastic_remainder(), 0.0);
      const double shape = beta + (chi + 1.0) / (chi + 2.0);
      const double psi_max = 400.0 * (1.0 + beta) / (2.5e5 * shape);
      EXPECT_DOUBLE_EQ(macroslip_displacement(part), psi_max);
      EXPECT_DOUBLE_EQ(density.largest_slip_force(), 2.5e5 * psi_max);
      const double s = 400.0 * beta / (psi_max * shape);  // of the atom, N/m
      if (beta > 0.0) {
        EXPECT_NEAR(density.atoms().weight.at(0), s / 2.5e5, 1e-15);
      }
    }
  }
}

// ---- The rules. ----

struct Offence {
  std::vector<DensityPart> parts;
  std::string name;
  std::string text;  // part of the message with value, rule and remedy
};

std::vector<Offence> offences() {
  const std::string finite = "must be 0 or more, and finite";
  const std::string positive = "must be positive and finite";
  using Linear = PiecewiseLinearPart;
  return {
      {{UniformPart{-1.0, 5.0, 0.5}}, "density[0].from", "= -1; " + finite},
      {{UniformPart{kNaN, 5.0, 0.5}}, "density[0].from", "= nan; " + finite},
      {{UniformPart{5.0, 5.0, 0.5}},
       "density[0].to",
       "= 5; must be finite and larger than from = 5"},
      {{UniformPart{5.0, 2.0, 0.5}}, "density[0].to", "swap the two"},
      {{UniformPart{0.0, kInfinity, 0.5}}, "density[0].to", "= inf; must be finite"},
      {{UniformPart{0.0, 5.0, -0.5}}, "density[0].weight", "= -0.5; " + finite},
      {{UniformPart{0.0, 5.0, kInfinity}}, "density[0].weight", "= inf; " + finite},
      {{PowerLawPart{0.1, -0.5, -1.0, 5.0}}, "density[0].from", "= -1; " + finite},
      {{PowerLawPart{0.1, -0.5, 6.0, 5.0}}, "density[0].to", "= 5; must be finite and larger"},
      {{PowerLawPart{-0.1, -0.5, 0.0, 5.0}}, "density[0].coefficient", "= -0.1; " + finite},
      {{PowerLawPart{0.1, kNaN, 1.0, 5.0}}, "density[0].exponent", "= nan; must be finite"},
      {{PowerLawPart{0.1, -1.0, 0.0, 5.0}}, "density[0].exponent", "= -1; must be above -1 where"},
      {{PowerLawPart{0.1, -2.5, 0.0, 5.0}},
       "density[0].exponent",
       "= -2.5; must be above -1 where"},
      {{Linear{{1.0}, {0.1}}}, "density[0].slip_force", "= 1; must have at least 2 knots"},
      {{Linear{{}, {}}}, "density[0].slip_force", "= 0; must have at least 2 knots"},
      {{Linear{{1.0, 2.0}, {0.1}}},
       "density[0].density",
       "= 1; must have one value per knot, 2 in all"},
      {{Linear{{-1.0, 2.0}, {0.1, 0.1}}}, "density[0].slip_force[0]", "= -1; " + finite},
      {{Linear{{1.0, 1.0}, {0.1, 0.1}}},
       "density[0].slip_force[1]",
       "= 1; must be larger than the"},
      {{Linear{{1.0, 3.0, 2.0}, {0.1, 0.1, 0.1}}},
       "density[0].slip_force[2]",
       "= 2; must be larger"},
      {{Linear{{1.0, kNaN}, {0.1, 0.1}}}, "density[0].slip_force[1]", "= nan; " + finite},
      {{Linear{{1.0, 2.0}, {0.1, -0.1}}}, "density[0].density[1]", "= -0.1; " + finite},
      {{AtomsPart{{}, {}}}, "density[0].slip_force", "must have at least one atom"},
      {{AtomsPart{{1.0, 2.0}, {0.1}}}, "density[0].weight", "= 1; must have one value per atom, 2"},
      {{AtomsPart{{1.0, 0.0}, {0.1, 0.1}}}, "density[0].slip_force[1]", "= 0; " + positive},
      {{AtomsPart{{kInfinity}, {0.1}}}, "density[0].slip_force[0]", "= inf; " + positive},
      {{AtomsPart{{1.0, 2.0}, {0.1, -0.1}}}, "density[0].weight[1]", "= -0.1; " + finite},
      {{FourParameterPart{0.0, 1.0, -0.5, 1.0}}, "density[0].macroslip_force", "= 0; " + positive},
      {{FourParameterPart{1.0, -1.0, -0.5, 1.0}}, "density[0].stiffness", "= -1; " + positive},
      {{FourParameterPart{1.0, 1.0, -1.0, 1.0}}, "density[0].chi", "= -1; must be in (-1, 0]"},
      {{FourParameterPart{1.0, 1.0, 0.5, 1.0}}, "density[0].chi", "= 0.5; must be in (-1, 0]"},
      {{FourParameterPart{1.0, 1.0, kNaN, 1.0}}, "density[0].chi", "= nan; must be in (-1, 0]"},
      {{FourParameterPart{1.0, 1.0, -0.5, -1.0}}, "density[0].beta", "= -1; " + finite},
      // The index is that of the part.
      {{UniformPart{0.0, 5.0, 0.5}, AtomsPart{{1.0}, {kNaN}}}, "density[1].weight[0]", "= nan; "},
      {{UniformPart{0.0, 5.0, 0.5}, FourParameterPart{1.0, 1.0, -0.5, 1.0}},
       "density[1]",
       "= four_parameter; must stand alone"},
      // Of the whole.
      {{UniformPart{0.0, 5.0, 0.75}, AtomsPart{{1.0}, {0.5}}},
       "total weight of density",
       "= 1.25; must not exceed 1"},
      {{UniformPart{0.0, 5.0, 1.0 + 2e-9}}, "total weight of density", "must not exceed 1"},
  };
}

TEST(SlipDensity, SaysWhichRuleOfWhichPartIsBroken) {
  for (const Offence& offence : offences()) {
    try {
      const SlipDensity density(offence.parts);
      ADD_FAILURE() << "accepted: " << offence.name << " " << offence.text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.name(), offence.name);
      EXPECT_NE(std::string(error.what()).find(offence.text), std::string::npos)
          << error.what() << "\n  should hold: " << offence.text;
    }
  }
}

TEST(SlipDensity, AcceptsWhatIsJustAllowed) {
  EXPECT_NO_THROW(SlipDensity({UniformPart{0.0, 5.0, 1.0 + 5e-10}}));  // decimals of a file
  EXPECT_NO_THROW(SlipDensity({UniformPart{0.0, 5.0, 0.0}}));
  EXPECT_NO_THROW(SlipDensity({PowerLawPart{0.01, -1.0, 1e-3, 5.0}}));
  EXPECT_NO_THROW(SlipDensity({PowerLawPart{0.0, 5.0, 0.0, 5.0}}));
  EXPECT_NO_THROW(SlipDensity({FourParameterPart{1.0, 1.0, 0.0, 0.0}}));
  EXPECT_NO_THROW(SlipDensity({PiecewiseLinearPart{{0.0, 1.0}, {0.0, 0.0}}}));
}

}  // namespace
}  // namespace microslip::density_test
