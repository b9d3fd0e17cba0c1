// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/response_draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/effort.hpp"
#include "support/structures.hpp"

namespace microslip::response_draws_test {
namespace {

constexpr double kZeta = 0.01;

/// One mode of 1 rad/s, no joint.
JointedStructure linear() {
  return {ModalModel({{1.0, 2.0 * kZeta}}, {{"mass", {1.0}}}), {}, {{"mass"}}};
}

const ResponseRange kRange{{Quantity::kForceAmplitude, 1.0}, 0.7, 1.4};

struct Predicted {
  ResponseCurve curve;
  ResponseSpread spread;
};

Predicted predict(const JointedStructure& structure, const StructureSpread& spread,
                  const DrawOptions& options, const ResponseRange& range = kRange,
                  const Execution& execution = Execution::threads(), JointDraws joint = {}) {
  const HarmonicBalance balance(structure, {"mass"}, {.harmonics = 3, .samples = 64});
  Predicted result;
  result.curve = balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to);
  const StructureDraws draws(structure, spread,
                             structure.joints().empty() ? std::vector<JointDraws>{}
                                                        : std::vector<JointDraws>{std::move(joint)},
                             JointPairing::kIndependent, options.seed);
  result.spread = response_spread(balance, result.curve, range, draws, options, execution);
  return result;
}

/// e^{±1.96σ} within four standard deviations of a quantile of 2.5 % of N draws, 2.67σ/√N.
void expect_factor(double edge, double value, double sign, double sigma, std::size_t count) {
  EXPECT_NEAR(std::log(edge / value), sign * 1.96 * sigma,
              4.0 * 2.67 * sigma / std::sqrt(static_cast<double>(count)));
}

// Of one linear mode the peak is 1/(2ζω²√(1 − ζ²)) at ω√(1 − 2ζ²): ω^−2 and ω.
TEST(ResponseDraws, OfALinearModeByItsClosedForm) {
  MICROSLIP_OF_RELEASE_ALONE();
  constexpr std::size_t kDraws = 2000;
  const Predicted found = predict(linear(), {.frequency = {0.01}}, {.count = kDraws});
  ASSERT_EQ(found.spread.peaks.size(), 1U);
  const PeakSpread& peak = found.spread.peaks[0];
  EXPECT_EQ(peak.draws, kDraws);
  expect_factor(peak.frequency_lower, peak.frequency, -1.0, 0.01, kDraws);
  expect_factor(peak.frequency_upper, peak.frequency, 1.0, 0.01, kDraws);
  expect_factor(peak.height_lower, peak.height, -1.0, 0.02, kDraws);
  expect_factor(peak.height_upper, peak.height, 1.0, 0.02, kDraws);
  EXPECT_TRUE(found.spread.warnings.empty());
}

// A gain scales what is read, by itself: of the response all heights, of the force the force that
// is there.
TEST(ResponseDraws, OfGainsScaleTheCurve) {
  constexpr std::size_t kDraws = 400;
  for (const bool of_force : {true, false}) {
    const StructureSpread spread{.force_gain = {of_force ? 0.05 : 0.0},
                                 .response_gain = of_force ? 0.0 : 0.05};
    const Predicted found = predict(linear(), spread, {.count = kDraws});
    for (std::size_t i = 0; i < found.curve.points.size(); i += 20) {
      const double height = found.curve.points[i].response;
      expect_factor(found.spread.band.lower[i], height, -1.0, 0.05, kDraws);
      expect_factor(found.spread.band.upper[i], height, 1.0, 0.05, kDraws);
    }
    EXPECT_NEAR(found.spread.peaks[0].frequency_upper, found.spread.peaks[0].frequency, 1e-6);
  }
}

// At constant response the force is ∝ the response that is there.
TEST(ResponseDraws, AtConstantResponseAreOfTheForce) {
  constexpr std::size_t kDraws = 400;
  const Predicted found = predict(linear(), {.response_gain = 0.05}, {.count = kDraws},
                                  {{Quantity::kResponse, 1.0}, 0.7, 1.4});
  ASSERT_EQ(found.spread.peaks.size(), 1U);
  expect_factor(found.spread.peaks[0].height_lower, found.spread.peaks[0].height, -1.0, 0.05,
                kDraws);
}

bool same(const ResponseSpread& a, const ResponseSpread& b) {
  return a.band.lower == b.band.lower && a.band.upper == b.band.upper &&
         a.peak_height == b.peak_height && a.peak_frequency == b.peak_frequency;
}

TEST(ResponseDraws, AreTheSameOnAnyNumberOfThreads) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const StructureSpread spread{.frequency = {0.02}, .normal_load = {0.1}};
  const ResponseRange range{{Quantity::kForceAmplitude, 0.02}, 0.8, 1.1};
  const DrawOptions options{.count = 60, .seed = 3};
  const ResponseSpread one = predict(structure, spread, options, range, Execution::serial()).spread;
  const ResponseSpread two = predict(structure, spread, options, range).spread;
  EXPECT_TRUE(same(one, two));
  const DrawOptions other{.count = 60, .seed = 4};
  EXPECT_FALSE(same(one, predict(structure, spread, other, range).spread));
}

// Where no draw differs the band is the curve: its interpolation, see CurveHeights.
TEST(ResponseDraws, ThatDoNotDifferLieOnTheCurve) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const ResponseRange range{{Quantity::kForceAmplitude, 0.02}, 0.8, 1.1};
  const Predicted found = predict(structure, {.normal_load = {1e-12}}, {.count = 40}, range);
  const double peak = found.curve.peaks.at(0).response;
  for (std::size_t i = 0; i < found.curve.points.size(); ++i) {
    EXPECT_NEAR(found.spread.band.lower[i], found.curve.points[i].response, 1e-3 * peak);
    EXPECT_NEAR(found.spread.band.upper[i], found.curve.points[i].response, 1e-3 * peak);
  }
}

/// A joint that only shortens: a Duffing oscillator, see
/// FrequencyResponse.RetracesACurveThatTurnsBack.
JointedStructure hardening() {
  const Joint spring(100.0, SlipDensity());
  StructuralJoint tie{.name = "tie", .joint = spring, .shape = {0.0}, .shortening = {0.3}};
  return {ModalModel({{1.0, 0.02}}, {{"mass", {1.0}}}), {std::move(tie)}, {{"mass"}}};
}

// Between the folds the highest branch has the band of the highest, the lowest that of the lowest;
// with a certain structure the branch between them is that of the draws, too.
TEST(ResponseDraws, OfACurveThatTurnsBackKeepToTheirBranch) {
  const ResponseRange range{{Quantity::kForceAmplitude, 0.01}, 0.5, 2.0};
  const JointedStructure structure = hardening();
  const Predicted certain = predict(structure, {.response_gain = 1e-9}, {.count = 40}, range);
  ASSERT_EQ(certain.curve.turning_points.size(), 2U);
  const double peak = certain.curve.peaks.at(0).response;
  for (std::size_t i = 0; i < certain.curve.points.size(); ++i) {
    EXPECT_NEAR(certain.spread.band.lower[i], certain.curve.points[i].response, 5e-3 * peak) << i;
    EXPECT_NEAR(certain.spread.band.upper[i], certain.curve.points[i].response, 5e-3 * peak) << i;
  }
  const Predicted found = predict(structure, {.frequency = {0.005}}, {.count = 100}, range);
  for (std::size_t i = 0; i < found.curve.points.size(); ++i) {
    EXPECT_LE(found.spread.band.lower[i], found.spread.band.upper[i]);
    const std::vector<std::size_t>& folds = found.curve.turning_points;
    // At a fold the branch between them is an extreme of the curve: draws that have it lie beyond.
    if (i > folds[0] && i < folds[1]) continue;
    EXPECT_LE(found.spread.band.lower[i], found.curve.points[i].response + 1e-2 * peak);
    EXPECT_GE(found.spread.band.upper[i], found.curve.points[i].response - 1e-2 * peak);
  }
}

/// Draws 0, `every`, 2 `every` … cannot be.
JointDraws failing(std::size_t count, std::size_t every) {
  return {count, [every](std::size_t i) {
            if (i % every == 0) throw InputError("draw", "this", "must be another");
            return DrawnJoint{testing::iwan_joint()};
          }};
}

TEST(ResponseDraws, ThatFailAreCountedAndLeftOut) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const ResponseRange range{{Quantity::kForceAmplitude, 0.02}, 0.8, 1.1};
  const auto failed = [&](std::size_t every) {
    return predict(structure, {}, {.count = 60}, range, Execution::threads(), failing(60, every))
        .spread;
  };
  const ResponseSpread few = failed(20);
  EXPECT_EQ(few.taken.failed(), 3U);
  EXPECT_FALSE(few.taken.too_many_failed());
  ASSERT_EQ(few.warnings.size(), 1U);
  EXPECT_EQ(few.warnings[0].code, "draws_failed");
  EXPECT_EQ(few.peaks.at(0).draws, 57U);
  const std::string comment = draws_comment(few.taken, "samples");
  EXPECT_NE(comment.find("draws_failed = 3 of 60"), std::string::npos) << comment;
  EXPECT_NE(comment.find("must be another"), std::string::npos) << comment;
  const ResponseSpread many = failed(3);
  EXPECT_TRUE(many.taken.too_many_failed());
  EXPECT_NE(draws_comment(many.taken, "samples").find("NOT CONVERGED"), std::string::npos);
  EXPECT_THROW(failed(1), InputError);
}

// Half of the draws have their peak beyond the range.
TEST(ResponseDraws, WithoutAPeakAreTold) {
  const ResponseRange range{{Quantity::kForceAmplitude, 1.0}, 0.7, 1.002};
  const Predicted found = predict(linear(), {.frequency = {0.02}}, {.count = 100}, range);
  ASSERT_EQ(found.spread.warnings.size(), 1U);
  EXPECT_EQ(found.spread.warnings[0].code, "peak_missing");
  EXPECT_LT(found.spread.peaks.at(0).draws, 80U);
}

TEST(ResponseDraws, NeedEnoughForTheirQuantiles) {
  EXPECT_NO_THROW(DrawOptions({.count = 40}).check());
  EXPECT_THROW(DrawOptions({.count = 39}).check(), InputError);
  EXPECT_NO_THROW(DrawOptions({.count = 4, .confidence = 0.5}).check());
  EXPECT_THROW(DrawOptions({.count = 4, .confidence = 1.0}).check(), InputError);
  EXPECT_THROW(DrawOptions({.count = 4, .confidence = 0.0}).check(), InputError);
}

}  // namespace
}  // namespace microslip::response_draws_test
