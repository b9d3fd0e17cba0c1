// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric/parametric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"
#include "support/reference_csv.hpp"

namespace microslip::parametric_test {
namespace {

using enum ParametricModel;

struct Plan {
  double from;  ///< share of `reach`
  double to;
  std::size_t count;
  double reach;  ///< m
};

/// Levels of a joint, uniform in ln A, without noise.
Levels exact_levels(const Joint& joint, const Plan& plan, bool secant = false) {
  Levels levels;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const double step = static_cast<double>(i) / static_cast<double>(plan.count - 1);
    const double a = plan.reach * plan.from * std::pow(plan.to / plan.from, step);
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(joint, a));
    if (secant) levels.secant_stiffness.push_back(secant_stiffness(joint, a));
  }
  return levels;
}

void add_linear(double coefficient, Levels& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.dissipation[i] += coefficient * levels.amplitude[i] * levels.amplitude[i];
  }
}

/// With noise of the given share of each value, and its standard deviation stated or not.
Levels with_noise(const Levels& exact, double share, bool stated, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Levels levels = exact;
  for (double& d : levels.dissipation) {
    if (stated) levels.dissipation_std.push_back(share * d);
    d *= 1.0 + share * random.normal();
  }
  for (double& k : levels.secant_stiffness) {
    if (stated) levels.secant_stiffness_std.push_back(share * k);
    k *= 1.0 + share * random.normal();
  }
  return levels;
}

const FittedParameter& parameter(const ParametricResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.parameters, name, &FittedParameter::name);
  if (found == result.parameters.end()) throw std::runtime_error("no parameter " + name);
  return *found;
}

bool warned(const ParametricResult& result, const std::string& code) {
  return std::ranges::find(result.warnings, code, &Warning::code) != result.warnings.end();
}

void expect_relative(const ParametricResult& result, const std::string& name, double truth,
                     double tolerance) {
  EXPECT_NEAR(parameter(result, name).value, truth, tolerance * std::abs(truth)) << name;
}

/// Mean, standard deviation and share within ±1.96 of (value − truth)/standard error over draws.
struct Scatter {
  double mean = 0.0;
  double deviation = 0.0;
  double covered = 0.0;

  explicit Scatter(const std::vector<double>& z) {
    const auto n = static_cast<double>(z.size());
    for (const double value : z) {
      mean += value / n;
      covered += std::abs(value) < 1.96 ? 1.0 / n : 0.0;
    }
    for (const double value : z) deviation += (value - mean) * (value - mean) / (n - 1.0);
    deviation = std::sqrt(deviation);
  }
};

/// Four standard deviations of each figure for n draws; 0.1 more for nonlinearity.
void expect_standard_normal(const std::vector<double>& z, const std::string& what) {
  const auto n = static_cast<double>(z.size());
  const Scatter scatter(z);
  EXPECT_NEAR(scatter.mean, 0.0, 4.0 / std::sqrt(n) + 0.1) << what;
  EXPECT_NEAR(scatter.deviation, 1.0, 4.0 / std::sqrt(2.0 * n) + 0.1) << what;
  EXPECT_NEAR(scatter.covered, 0.95, 4.0 * std::sqrt(0.95 * 0.05 / n)) << what;
}

/// The sets of tests/data/four_parameter.csv, one each.
struct FourParameters {
  double force, stiffness, chi, beta, reach;
  std::vector<double> amplitude, dissipation;
};

std::vector<FourParameters> published_sets() {
  const auto table = testing::reference_table("four_parameter.csv");
  std::vector<FourParameters> sets;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double force = table["macroslip_force [N]"][i];
    if (sets.empty() || sets.back().force != force) {
      sets.push_back({force,
                      table["stiffness [N/m]"][i],
                      table["chi [1]"][i],
                      table["beta [1]"][i],
                      table["macroslip_displacement [m]"][i],
                      {},
                      {}});
    }
    sets.back().amplitude.push_back(table["displacement [m]"][i]);
    sets.back().dissipation.push_back(table["dissipation [J]"][i]);
  }
  return sets;
}

// The published values themselves: 5 levels of 12 digits for 3 parameters.
TEST(Parametric, FindsThePublishedSetsFromTheirFiveLevels) {
  const auto sets = published_sets();
  ASSERT_EQ(sets.size(), 4U);
  for (const FourParameters& set : sets) {
    SCOPED_TRACE(set.force);
    Levels levels;
    levels.amplitude = set.amplitude;
    levels.dissipation = set.dissipation;
    const auto result = fit_parametric(levels, set.stiffness, kFourParameter);
    EXPECT_TRUE(result.summary.converged());
    expect_relative(result, "macroslip_force", set.force, 1e-8);
    expect_relative(result, "chi", set.chi, 1e-8);
    EXPECT_NEAR(parameter(result, "beta").value, set.beta, 1e-7);
  }
}

TEST(Parametric, RecoversEveryModelExactly) {
  const auto check = [](const Joint& joint, ParametricModel model, const Plan& plan,
                        const std::vector<std::pair<std::string, double>>& truth) {
    for (const bool secant : {false, true}) {
      for (const double share : {0.0, 0.4}) {  // of the linear loss in that of the first level
        SCOPED_TRACE(::testing::Message() << to_string(model) << secant << share);
        Levels levels = exact_levels(joint, plan, secant);
        const double a = levels.amplitude.front();
        const double linear = share * levels.dissipation.front() / (a * a);
        add_linear(linear, levels);
        const auto result =
            fit_parametric(levels, joint.stiffness(), model, {.linear_damping = share > 0.0});
        EXPECT_TRUE(result.summary.converged()) << result.summary.full();
        for (const auto& [name, value] : truth) expect_relative(result, name, value, 1e-6);
        if (share > 0.0) expect_relative(result, "linear_damping", linear, 1e-6);
        EXPECT_LT(result.misfit, 1e-8);
        const double last = levels.amplitude.back();
        EXPECT_NEAR(dissipation(result.joint, last) / dissipation(joint, last), 1.0, 1e-6);
      }
    }
  };
  const Joint four = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  check(four, kFourParameter, {0.02, 1.4, 25, four.macroslip_displacement()},
        {{"macroslip_force", 400.0}, {"chi", -0.5}, {"beta", 1.0}});
  // The paper's power law, [AR14 Fig. 3], seen up to half of its range and beyond all of it
  const Joint power(1e3, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}));
  for (const double to : {0.5, 1.5}) {
    check(power, kPowerLaw, {0.01, to, 20, 0.025}, {{"coefficient", 0.1}, {"exponent", -0.5}});
  }
  const Joint uniform(2e5, SlipDensity({UniformPart{0.0, 40.0, 0.7}}));
  check(uniform, kUniform, {0.02, 1.5, 20, 2e-4}, {{"weight", 0.7}, {"to", 40.0}});
}

// A relative noise of 2 % at 40 levels, 200 draws, its size given or to be estimated. In the
// studies alone: the next two tests judge standard errors by 60 draws.
TEST(Parametric, StandardErrorsAreThoseOfTheScatter) {
  MICROSLIP_STUDY();
  const Joint joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  const Levels exact = exact_levels(joint, {0.02, 1.4, 40, joint.macroslip_displacement()});
  for (const bool stated : {true, false}) {
    SCOPED_TRACE(stated);
    std::vector<double> force, chi, beta, along, noise;
    double chi_squared = 0.0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto result = fit_parametric(with_noise(exact, 0.02, stated, seed), 252660.0,
                                         kFourParameter, {.starts = 3});
      const auto z = [&](const std::string& name, double truth) {
        const FittedParameter& p = parameter(result, name);
        return (p.value - truth) / p.standard_error;
      };
      force.push_back(z("macroslip_force", 400.0));
      chi.push_back(z("chi", -0.5));
      beta.push_back(z("beta", 1.0));
      // the covariances too: the combination F_S/400 + beta
      const auto& c = result.covariance;
      const double variance = c[0] / 160000.0 + 2.0 * c[2] / 400.0 + c[8];
      along.push_back((result.parameters[0].value / 400.0 + result.parameters[2].value - 2.0) /
                      std::sqrt(variance));
      chi_squared += result.chi_squared / 200.0;
      EXPECT_EQ(result.degrees_of_freedom, 37);
      EXPECT_EQ(result.dissipation_noise.has_value(), !stated);
      if (!stated) noise.push_back(*result.dissipation_noise);
    }
    expect_standard_normal(force, "macroslip_force");
    expect_standard_normal(chi, "chi");
    expect_standard_normal(beta, "beta");
    expect_standard_normal(along, "F_S/400 + beta");
    EXPECT_NEAR(chi_squared, 37.0, 4.0 * std::sqrt(2.0 * 37.0 / 200.0));
    if (stated) continue;
    EXPECT_NEAR(Scatter(noise).mean, 0.02, 0.0007);  // 4·0.02/√(2·37·200) = 0.0007
  }
}

TEST(Parametric, StandardErrorsWithDampingAndSecants) {
  MICROSLIP_OF_RELEASE_ALONE();
  const Joint joint(1e3, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}));
  Levels exact = exact_levels(joint, {0.01, 0.8, 25, 0.025}, true);
  const double linear = 0.3 * exact.dissipation[0] / (exact.amplitude[0] * exact.amplitude[0]);
  add_linear(linear, exact);
  for (const bool stated : {true, false}) {
    SCOPED_TRACE(stated);
    std::vector<double> coefficient, exponent, damping;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const auto result = fit_parametric(with_noise(exact, 0.01, stated, seed), 1e3, kPowerLaw,
                                         {.linear_damping = true, .starts = 2});
      EXPECT_TRUE(result.summary.converged());
      const auto z = [&](const std::string& name, double truth) {
        const FittedParameter& p = parameter(result, name);
        return (p.value - truth) / p.standard_error;
      };
      coefficient.push_back(z("coefficient", 0.1));
      exponent.push_back(z("exponent", -0.5));
      damping.push_back(z("linear_damping", linear));
      EXPECT_EQ(result.secant_noise.has_value(), !stated);
    }
    expect_standard_normal(coefficient, "coefficient");
    expect_standard_normal(exponent, "exponent");
    expect_standard_normal(damping, "linear_damping");
  }
}

// 2 % of scatter in A, which is 5 to 6 % of D, beside 1 % of D's own: with amplitude_std the
// standard errors are right, and the weights follow (without it they are a fifth of the scatter or
// so).
TEST(Parametric, StandardErrorsWithDeviationsOfTheAmplitude) {
  MICROSLIP_OF_RELEASE_ALONE();
  const Joint joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  const Levels exact = exact_levels(joint, {0.02, 1.4, 40, joint.macroslip_displacement()});
  std::vector<double> force, chi, beta, without_std;
  double chi_squared = 0.0;
  constexpr std::uint64_t kSets = 60;
  for (std::uint64_t seed = 0; seed < kSets; ++seed) {
    Levels levels = with_noise(exact, 0.01, true, seed);
    RandomStream random(seed, 1);
    for (double& a : levels.amplitude) {
      levels.amplitude_std.push_back(0.02 * a);
      a *= 1.0 + 0.02 * random.normal();
    }
    const auto fit = [&] {
      return fit_parametric(levels, 252660.0, kFourParameter, {.starts = 2});
    };
    const ParametricResult result = fit();
    EXPECT_TRUE(result.summary.converged()) << result.summary.reason;
    const auto z = [](const ParametricResult& of, const std::string& name, double truth) {
      const FittedParameter& p = parameter(of, name);
      return (p.value - truth) / p.standard_error;
    };
    force.push_back(z(result, "macroslip_force", 400.0));
    chi.push_back(z(result, "chi", -0.5));
    beta.push_back(z(result, "beta", 1.0));
    chi_squared += result.chi_squared / static_cast<double>(kSets);
    levels.amplitude_std.clear();
    without_std.push_back(z(fit(), "chi", -0.5));
  }
  expect_standard_normal(force, "macroslip_force");
  expect_standard_normal(chi, "chi");
  expect_standard_normal(beta, "beta");
  EXPECT_NEAR(chi_squared, 37.0, 4.0 * std::sqrt(2.0 * 37.0 / static_cast<double>(kSets)));
  EXPECT_LT(Scatter(without_std).covered, 0.7) << "without amplitude_std they do not";
}

// k_eq has slopes too, and an estimated noise already includes that of the amplitude.
TEST(Parametric, DeviationsOfTheAmplitudeMatterWhereDeviationsAreGiven) {
  const Joint joint(1e3, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}));
  const Levels exact = exact_levels(joint, {0.01, 0.8, 25, 0.025}, true);
  const auto error_of = [&](bool stated, bool amplitude) {
    Levels levels = with_noise(exact, 0.01, stated, 3);
    if (amplitude) {
      for (const double a : levels.amplitude) levels.amplitude_std.push_back(0.05 * a);
    }
    const ParametricResult result = fit_parametric(levels, 1e3, kPowerLaw);
    EXPECT_TRUE(result.summary.converged()) << result.summary.reason;
    return parameter(result, "exponent").standard_error;
  };
  EXPECT_GT(error_of(true, true), 2.0 * error_of(true, false));
  EXPECT_EQ(error_of(false, true), error_of(false, false));
}

TEST(Parametric, BoundsAreHitExactly) {
  const auto fit = [](double chi, double beta) {
    const Joint joint = Joint::four_parameter(50.0, 1e6, chi, beta);
    return fit_parametric(exact_levels(joint, {0.02, 1.3, 25, joint.macroslip_displacement()}), 1e6,
                          kFourParameter);
  };
  const auto no_atom = fit(-0.4, 0.0);
  EXPECT_EQ(parameter(no_atom, "beta").value, 0.0);
  EXPECT_TRUE(parameter(no_atom, "beta").at_bound);
  EXPECT_EQ(parameter(no_atom, "beta").standard_error, 0.0);
  expect_relative(no_atom, "chi", -0.4, 1e-6);
  EXPECT_TRUE(warned(no_atom, "parameter_at_bound"));

  const auto flat = fit(0.0, 0.5);
  EXPECT_EQ(parameter(flat, "chi").value, 0.0);
  EXPECT_TRUE(parameter(flat, "chi").at_bound);
  expect_relative(flat, "beta", 0.5, 1e-6);

  const auto both = fit(0.0, 0.0);
  EXPECT_EQ(parameter(both, "chi").value, 0.0);
  EXPECT_EQ(parameter(both, "beta").value, 0.0);
  expect_relative(both, "macroslip_force", 50.0, 1e-6);

  // all slips: weight 1; no linear loss: βl = 0
  const Joint uniform(2e5, SlipDensity({UniformPart{0.0, 40.0, 1.0}}));
  const auto full = fit_parametric(exact_levels(uniform, {0.02, 1.5, 20, 2e-4}), 2e5, kUniform,
                                   {.linear_damping = true});
  EXPECT_EQ(parameter(full, "weight").value, 1.0);
  expect_relative(full, "to", 40.0, 1e-6);
  EXPECT_EQ(full.linear_damping, 0.0);
  EXPECT_TRUE(parameter(full, "linear_damping").at_bound);
}

// Truth at beta = 0 with noise: half of the draws would have beta < 0 and must end at the bound.
TEST(Parametric, NoisyTruthAtABound) {
  const Joint joint = Joint::four_parameter(50.0, 1e6, -0.4, 0.0);
  const Levels exact = exact_levels(joint, {0.02, 1.3, 25, joint.macroslip_displacement()});
  int at_bound = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto result =
        fit_parametric(with_noise(exact, 0.02, true, seed), 1e6, kFourParameter, {.starts = 3});
    EXPECT_TRUE(result.summary.converged());
    EXPECT_FALSE(warned(result, "systematic_misfit"));
    const FittedParameter& beta = parameter(result, "beta");
    EXPECT_EQ(beta.at_bound, beta.value == 0.0);
    at_bound += beta.at_bound ? 1 : 0;
    EXPECT_NEAR(parameter(result, "macroslip_force").value, 50.0, 5.0);
  }
  EXPECT_GT(at_bound, 15);  // 30 ± 3.9
  EXPECT_LT(at_bound, 45);
}

// A density with a dip and a peak is none of a power law: with 1 % of noise that shows at once.
TEST(Parametric, SaysThatAModelDoesNotFit) {
  const Joint joint = testing::reference_joint();
  const Levels exact = exact_levels(joint, {0.05, 1.0, 60, 3e-4});
  for (std::uint64_t seed = 0; seed < test::draws_of(10, 2); ++seed) {
    const Levels levels = with_noise(exact, 0.01, true, seed);
    for (const ParametricModel model : {kFourParameter, kPowerLaw, kUniform}) {
      const auto result = fit_parametric(levels, joint.stiffness(), model, {.starts = 3});
      EXPECT_TRUE(warned(result, "systematic_misfit")) << to_string(model) << ", seed " << seed;
    }
  }
}

// Below macro-slip the same D comes from any F_S between an atom at the last level and none.
TEST(Parametric, SaysThatMacroslipWasNotReached) {
  const Joint joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  const Levels levels = exact_levels(joint, {0.02, 0.7, 20, joint.macroslip_displacement()});
  const auto result = fit_parametric(levels, 252660.0, kFourParameter);
  EXPECT_TRUE(warned(result, "macroslip_not_reached"));
  expect_relative(result, "chi", -0.5, 1e-6);
  // At K_T = 252660 N/m the power law alone, half of the stiffness up to ψ_max, has all of it at
  // 4ψ_max; there F_S = K_T·4ψ_max/3 = 800 N.
  expect_relative(result, "macroslip_force", 800.0, 1e-6);
  EXPECT_LT(result.misfit, 1e-9);

  const Joint wide(2e5, SlipDensity({UniformPart{0.0, 100.0, 0.9}}));
  const auto part = fit_parametric(exact_levels(wide, {0.02, 1.0, 20, 2e-4}), 2e5, kUniform);
  EXPECT_TRUE(warned(part, "macroslip_not_reached"));
  expect_relative(part, "to", 40.0, 1e-12);
  expect_relative(part, "weight", 0.36, 1e-6);
}

// The power law of area 1 is the four-parameter model with beta = 0: by chance that may win by a
// little. A margin of 6, −2 ln of a likelihood ratio of 20, is exceeded once in 500 draws.
TEST(Parametric, CriteriaPreferTheModelThatMadeTheLevels) {
  const Joint four = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  const Joint power(1e3, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}));
  const Joint uniform(2e5, SlipDensity({UniformPart{0.0, 40.0, 0.7}}));
  const std::vector<std::pair<Joint, ParametricModel>> truths{
      {four, kFourParameter}, {power, kPowerLaw}, {uniform, kUniform}};
  for (const auto& [joint, model] : truths) {
    const double reach = joint.density().largest_slip_force() / joint.stiffness();
    for (std::uint64_t seed = 0; seed < test::draws_of(5, 2); ++seed) {
      for (const bool stated : {true, false}) {
        const Levels levels =
            with_noise(exact_levels(joint, {0.02, 1.4, 30, reach}), 0.02, stated, seed);
        const auto right = fit_parametric(levels, joint.stiffness(), model);
        EXPECT_NEAR(right.misfit, 0.02, 0.01);
        for (const ParametricModel other : {kFourParameter, kPowerLaw, kUniform}) {
          if (other == model) continue;
          const auto wrong = fit_parametric(levels, joint.stiffness(), other);
          const bool contains = model == kPowerLaw && other == kFourParameter;
          EXPECT_LT(right.bic, wrong.bic + (contains ? 6.0 : 0.0))
              << to_string(model) << " against " << to_string(other);
        }
      }
    }
  }
}

// The likelihood of the criteria, from the numbers of a small case.
TEST(Parametric, CriteriaAreThoseOfTheNormalLikelihood) {
  const Joint uniform(2e5, SlipDensity({UniformPart{0.0, 40.0, 0.7}}));
  const Levels levels = with_noise(exact_levels(uniform, {0.1, 1.5, 8, 2e-4}), 0.05, true, 3);
  const auto result = fit_parametric(levels, 2e5, kUniform);
  double deviance = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double sigma = levels.dissipation_std[i];
    const double r = dissipation(result.joint, levels.amplitude[i]) - levels.dissipation[i];
    deviance += std::log(2.0 * M_PI * sigma * sigma) + r * r / (sigma * sigma);
  }
  EXPECT_NEAR(result.aic, deviance + 4.0, 1e-9);
  EXPECT_NEAR(result.bic, deviance + 2.0 * std::log(8.0), 1e-9);
}

// Lengths, forces and energies in other units are the same problem: k, A and D scaled together.
TEST(Parametric, NoScaleIsSpecial) {
  for (const double scale : {1e-6, 1e6}) {
    const Joint joint = Joint::four_parameter(400.0 * scale, 252660.0, -0.5, 1.0);
    const Levels levels = with_noise(
        exact_levels(joint, {0.02, 1.4, 25, joint.macroslip_displacement()}), 0.02, false, 7);
    const auto result = fit_parametric(levels, 252660.0, kFourParameter);
    const Joint unit = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
    const auto expected = fit_parametric(
        with_noise(exact_levels(unit, {0.02, 1.4, 25, unit.macroslip_displacement()}), 0.02, false,
                   7),
        252660.0, kFourParameter);
    expect_relative(result, "macroslip_force", scale * parameter(expected, "macroslip_force").value,
                    1e-6);
    expect_relative(result, "beta", parameter(expected, "beta").value, 1e-6);
  }
}

TEST(Parametric, ReportsARunThatDidNotEnd) {
  const Joint joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  const Levels levels = with_noise(
      exact_levels(joint, {0.02, 1.4, 25, joint.macroslip_displacement()}), 0.02, true, 1);
  const auto result =
      fit_parametric(levels, 252660.0, kFourParameter, {.starts = 1, .max_evaluations = 2});
  EXPECT_FALSE(result.summary.converged());
  EXPECT_EQ(result.summary.reason, "the best start ran out of evaluations");
}

std::string error_of(const Levels& levels, double stiffness, ParametricModel model,
                     const ParametricOptions& options = {}) {
  try {
    (void)fit_parametric(levels, stiffness, model, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Parametric, RefusesWhatItCannotUse) {
  const Joint joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);
  Levels levels = exact_levels(joint, {0.1, 1.2, 3, joint.macroslip_displacement()});
  EXPECT_EQ(error_of(levels, 252660.0, kFourParameter),
            "number of distinct amplitudes = 3; must be at least 4, one more than the parameters. "
            "Measure more levels, or fit a model with fewer parameters");
  EXPECT_EQ(error_of(levels, 252660.0, kUniform), "no error");
  EXPECT_NE(
      error_of(levels, 252660.0, kUniform, {.linear_damping = true}).find("must be at least 4"),
      std::string::npos);
  levels.amplitude.push_back(levels.amplitude.back());  // a repetition is no new level
  levels.dissipation.push_back(levels.dissipation.back());
  EXPECT_NE(error_of(levels, 252660.0, kFourParameter).find("amplitudes = 3"), std::string::npos);
  EXPECT_NE(error_of(levels, -1.0, kUniform).find("stiffness = -1"), std::string::npos);
  EXPECT_NE(error_of(levels, 1e5, kUniform, {.starts = 0}).find("starts = 0"), std::string::npos);
  EXPECT_NE(error_of(levels, 1e5, kUniform, {.max_evaluations = 0}).find("max_evaluations = 0"),
            std::string::npos);
  levels.dissipation[1] = 0.0;  // one such level counts as one at the floor
  EXPECT_EQ(error_of(levels, 252660.0, kUniform), "no error");
  levels.dissipation.assign(4, 0.0);
  EXPECT_NE(error_of(levels, 252660.0, kUniform).find("dissipation = 0 at all levels"),
            std::string::npos);
  levels.dissipation_std.assign(4, 1e-6);
  EXPECT_EQ(error_of(levels, 252660.0, kUniform), "no error");
}

}  // namespace
}  // namespace microslip::parametric_test
