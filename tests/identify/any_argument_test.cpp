// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/bands.hpp"
#include "microslip/identify/methods/density_comparison.hpp"
#include "microslip/identify/methods/diagnostics.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/identify/methods/method_comparison.hpp"
#include "microslip/identify/parametric/parametric.hpp"
#include "microslip/identify/smoothing/differences.hpp"
#include "microslip/identify/smoothing/spline_density.hpp"
#include "microslip/joint/dissipation.hpp"

/// @file
/// Each public function of identify/ with invalid arguments: a documented value or InputError.

namespace microslip::any_argument_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kStiffness = 1e5;

Levels good_levels() {
  const Joint joint(kStiffness, SlipDensity({UniformPart{0.0, 30.0, 0.6}}));
  Levels levels;
  for (int i = 1; i <= 12; ++i) {
    levels.amplitude.push_back(2e-5 * i);
    levels.dissipation.push_back(dissipation(joint, 2e-5 * i) * (1.0 + 0.01 * std::sin(5.0 * i)));
  }
  return levels;
}

std::vector<Levels> bad_levels() {
  std::vector<Levels> all(1);  // empty
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1e-5}) {
    for (std::vector<double> Levels::*column :
         {&Levels::amplitude, &Levels::dissipation, &Levels::amplitude_std,
          &Levels::dissipation_std, &Levels::secant_stiffness, &Levels::secant_stiffness_std,
          &Levels::linear_dissipation}) {
      Levels levels = good_levels();
      (levels.*column).resize(levels.size(), 1e-6);
      (levels.*column)[3] = bad;
      all.push_back(levels);
      (levels.*column).assign(5, 1e-6);  // of another length
      all.push_back(levels);
    }
  }
  return all;
}

TEST(AnyArgument, OfLevels) {
  for (const Levels& levels : bad_levels()) {
    EXPECT_THROW(check_levels(levels), InputError);
    EXPECT_THROW((void)sort_and_merge(levels), InputError);
    EXPECT_THROW((void)diagnose(levels), InputError);
    EXPECT_THROW((void)invert(levels, kStiffness), InputError);
    EXPECT_THROW((void)density_by_spline(levels, kStiffness), InputError);
    EXPECT_THROW((void)density_by_differences(levels, kStiffness), InputError);
    EXPECT_THROW((void)fit_parametric(levels, kStiffness, ParametricModel::kUniform), InputError);
  }
  for (const double bad : {kNaN, kInfinity, -1.0, 0.0}) {
    EXPECT_THROW((void)invert(good_levels(), bad), InputError);
    EXPECT_THROW((void)density_by_spline(good_levels(), bad), InputError);
    EXPECT_THROW((void)density_by_differences(good_levels(), bad), InputError);
    EXPECT_THROW((void)fit_parametric(good_levels(), bad, ParametricModel::kUniform), InputError);
  }
}

// A posterior that was changed by hand; an empty one.
TEST(AnyArgument, OfSamplesOfTheDensity) {
  const InversionResult good = invert(good_levels(), kStiffness);
  EXPECT_NO_THROW((void)good.posterior.samples(static_cast<std::uint64_t>(-1), 1));
  EXPECT_TRUE(good.posterior.samples(1, 0).empty());
  for (const double std : {kNaN, kInfinity, -0.1, 0.5}) {
    EXPECT_THROW((void)density_bands(good, {.confidence = std - 0.5}), InputError);
    DensityPosterior posterior = good.posterior;
    posterior.common_errors.dissipation_gain_std = std;
    EXPECT_THROW((void)posterior.samples(1, 20), InputError);
  }
  EXPECT_THROW((void)density_bands(good, {.samples = 0}), InputError);

  const std::vector<DensityPosterior> bad = [&] {
    std::vector<DensityPosterior> all(11, good.posterior);
    all[0] = DensityPosterior{};
    all[1].smoothing.least = 0.0;
    all[2].density.values.pop_back();
    all[3].dissipation.factor.columns = 0;
    all[4].dissipation.data.pop_back();
    all[5].penalty.columns = 7;
    all[6].common_errors.loss_factor_std = 0.1;  // without the losses of the levels
    all[7].dissipation.count = kNaN;
    all[8].start.clear();
    all[9].slip_force.clear();
    all[10].smoothing.most = kNaN;
    return all;
  }();
  for (const DensityPosterior& posterior : bad) {
    EXPECT_THROW((void)posterior.samples(1, 20), InputError);
    InversionResult result = good;
    result.posterior = posterior;
    EXPECT_THROW((void)density_bands(result, {}), InputError);
  }
  const std::vector<InversionResult> empty = [&] {
    std::vector<InversionResult> all(3, good);
    all[0] = InversionResult{};
    all[1].density.pop_back();
    all[2].fitted_dissipation.clear();
    return all;
  }();
  for (const InversionResult& result : empty) {
    EXPECT_THROW((void)density_bands(result, {}), InputError);
    EXPECT_THROW((void)diagnose(result, good_levels(), kStiffness, {}), InputError);
  }
}

TEST(AnyArgument, OfSplines) {
  const NaturalSpline none;
  const NaturalSpline line({0.0, 1.0}, {2.0, 3.0}, {0.0, 0.0});
  EXPECT_TRUE(std::isnan(none.value(0.0)));
  EXPECT_TRUE(std::isnan(none.first_derivative(0.0)));
  EXPECT_TRUE(std::isnan(none.second_derivative(0.0)));
  EXPECT_TRUE(std::isnan(line.value(kNaN)));
  EXPECT_TRUE(std::isnan(line.first_derivative(kNaN)));
  EXPECT_EQ(line.value(kInfinity), kInfinity);
  EXPECT_EQ(line.value(-kInfinity), -kInfinity);
  EXPECT_EQ(line.second_derivative(-kInfinity), 0.0);
  EXPECT_THROW(NaturalSpline({}, {}, {}), InputError);
  EXPECT_THROW(NaturalSpline({0.0, kNaN}, {0.0, 0.0}, {0.0, 0.0}), InputError);
  EXPECT_THROW(NaturalSpline({0.0, 1.0}, {0.0}, {0.0, 0.0}), InputError);
  EXPECT_TRUE(std::isnan(SplineDensityResult{}.fit.spline.value(1.0)));
  (void)SplineDensityResult{}.density_at(1.0);

  const std::vector<double> x{0.0, 1.0, 2.0, 3.0};
  const std::vector<double> y{0.0, 1.0, 4.0, 9.0};
  const std::vector<double> some{1.0, 1.0};
  EXPECT_THROW((void)fit_smoothing_spline({}, {}, {}), InputError);
  EXPECT_THROW((void)fit_smoothing_spline(x, some, {}), InputError);
  EXPECT_THROW((void)fit_smoothing_spline(x, y, some), InputError);
  for (const double bad : {kNaN, -1.0, -kInfinity}) {
    const std::vector<double> broken{0.0, bad, 2.0, 3.0};
    EXPECT_THROW((void)fit_smoothing_spline(x, y, broken), InputError);
    EXPECT_THROW((void)fit_smoothing_spline(x, y, {}, FixedLambda{bad}), InputError);
    EXPECT_THROW((void)fit_smoothing_spline(x, y, {}, TargetEdf{bad}), InputError);
    EXPECT_THROW((void)fit_smoothing_spline(x, y, {}, MatlabP{bad, 1.0}), InputError);
    EXPECT_THROW((void)fit_smoothing_spline(x, y, {}, MatlabP{0.5, bad}), InputError);
    EXPECT_THROW((void)fit_smoothing_spline(x, y, {}, Gcv{.edf_factor = bad}), InputError);
  }
}

TEST(AnyArgument, OfComparisons) {
  const SlipDensity truth({UniformPart{0.0, 30.0, 0.6}});
  const std::vector<double> force{0.0, 10.0};
  const std::vector<double> density{0.1, 0.1};
  for (const double bad : {kNaN, kInfinity, -1.0, 0.0}) {
    EXPECT_THROW((void)density_error(truth, bad, truth), InputError);
    EXPECT_THROW((void)density_error(force, density, bad, truth), InputError);
  }
  EXPECT_THROW((void)density_error(truth, 10.0, truth, {kNaN, 0.5}), InputError);
  EXPECT_THROW((void)density_error(truth, 10.0, truth, {0.5, 0.2}), InputError);
  EXPECT_THROW((void)density_error(force, {}, 10.0, truth), InputError);
  EXPECT_THROW((void)density_error(std::vector<double>{}, {}, 10.0, truth), InputError);
  EXPECT_THROW((void)density_error(truth, 10.0, SlipDensity()), InputError);

  const IdentificationOptions options{.bands = BandOptions{.samples = 20}};
  Identification found = identify(good_levels(), kStiffness, options);
  EXPECT_NO_THROW((void)band_coverage(found, truth));
  found.upper.pop_back();
  EXPECT_THROW((void)band_coverage(found, truth), InputError);
  found.lower.clear();
  EXPECT_THROW((void)band_coverage(found, truth), InputError);

  MethodComparison methods = compare_methods(good_levels(), kStiffness, options);
  for (const double bad : {kNaN, kInfinity, -1.0, 0.0}) {
    EXPECT_THROW((void)inversion_with(methods, bad), InputError);
  }
  EXPECT_THROW((void)spline_with(methods, kNaN), InputError);
  methods.inversion.free = {};
  EXPECT_THROW((void)inversion_with(methods, 1.0), InputError);
  EXPECT_THROW((void)compare_methods(Levels{}, kStiffness, options), InputError);
}

}  // namespace
}  // namespace microslip::any_argument_test
