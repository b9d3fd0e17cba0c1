// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/march_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/structures.hpp"

namespace microslip::march_draws_test {
namespace {

/// One mode of 1 rad/s, no joint.
JointedStructure linear() { return {ModalModel({{1.0, 0.02}}, {{"mass", {1.0}}}), {}, {{"mass"}}}; }

ModelFile model_of(JointedStructure structure, StructureSpread spread = {}) {
  ModelFile model{.structure = std::move(structure), .response = "mass", .joint_files = {}};
  model.spread = std::move(spread);
  return model;
}

/// 0.05 N for 40 s, ten samples a second.
LoadHistory sine(double omega, const std::string& point = "mass") {
  LoadHistory loads{{}, {{point, {}}}};
  for (std::size_t i = 0; i <= 400; ++i) {
    loads.time.push_back(0.1 * static_cast<double>(i));
    loads.forces[0].force.push_back(0.05 * std::sin(omega * loads.time.back()));
  }
  return loads;
}

DrawnMarch predict(const ModelFile& model, const DrawOptions& drawn, const LoadHistory& loads,
                   std::size_t every = 1, const Execution& execution = Execution::threads(),
                   std::vector<JointDraws> joints = {}) {
  const StructureDraws draws(model.structure, model.spread, std::move(joints),
                             JointPairing::kIndependent, drawn.seed);
  return drawn_march(model, loads, {.every = every, .points = {"mass"}}, draws, drawn, execution);
}

/// e^{±1.96σ} within four standard deviations of a quantile of N draws, 2.67σ/√N.
void expect_edges(const StatisticSpread& spread, double sigma, std::size_t count) {
  const double tolerance = 4.0 * 2.67 * sigma / std::sqrt(static_cast<double>(count));
  EXPECT_NEAR(std::log(spread.lower / spread.value), -1.96 * sigma, tolerance);
  EXPECT_NEAR(std::log(spread.upper / spread.value), 1.96 * sigma, tolerance);
}

// A linear motion grows with either gain, at all times.
TEST(MarchDraws, OfGainsScaleALinearMotion) {
  constexpr std::size_t kDraws = 400;
  for (const bool of_force : {true, false}) {
    const DrawnMarch found = predict(model_of(linear(), {.force_gain = {of_force ? 0.05 : 0.0},
                                                         .response_gain = of_force ? 0.0 : 0.05}),
                                     {.count = kDraws}, sine(0.9));
    ASSERT_TRUE(found.march.summary.converged());
    ASSERT_EQ(found.signals.size(), 3U);
    ASSERT_EQ(found.rows.size(), 3U * 401U);
    EXPECT_TRUE(found.march.warnings.empty());
    for (const MarchedSignal& signal : found.signals) {
      expect_edges(signal.peak, 0.05, kDraws);
      expect_edges(signal.rms, 0.05, kDraws);
    }
    for (std::size_t at = 3; at < found.rows.size(); at += 97) {
      const double value = found.rows[at];
      const StatisticSpread here{std::abs(value),
                                 value > 0.0 ? found.band.lower[at] : -found.band.upper[at],
                                 value > 0.0 ? found.band.upper[at] : -found.band.lower[at]};
      expect_edges(here, 0.05, kDraws);
    }
  }
}

// From rest under a constant force F, undamped, q = F/ω² (1 − cos ωt): its peak is 2F/ω², its rms
// F/ω² √1.5 over whole periods.
TEST(MarchDraws, TellPeakAndRmsOfAKnownMotion) {
  const JointedStructure undamped(ModalModel({{1.0, 0.0}}, {{"mass", {1.0}}}), {}, {{"mass"}});
  LoadHistory loads{{}, {{"mass", {}}}};
  constexpr double kPeriod = 6.283185307179586;
  for (std::size_t i = 0; i <= 200; ++i) {
    loads.time.push_back(kPeriod / 100.0 * static_cast<double>(i));
    loads.forces[0].force.push_back(0.3);
  }
  const DrawnMarch found =
      predict(model_of(undamped, {.response_gain = 0.01}), {.count = 40}, loads, 7);
  EXPECT_NEAR(found.signals[0].peak.value, 0.6, 1e-9);
  // By trapezia over whole periods: exact for these harmonics.
  EXPECT_NEAR(found.signals[0].rms.value, 0.3 * std::sqrt(1.5), 1e-9);
  // The same of few times, unequally far apart: what is between them counts.
  const LoadHistory few{{0.0, 0.1, 2.0 * kPeriod}, {{"mass", {0.3, 0.3, 0.3}}}, {}};
  const DrawnMarch of_few = drawn_march(
      model_of(undamped), few, {.step = 0.01 * kPeriod, .points = {"mass"}},
      StructureDraws(undamped, {.response_gain = 0.01}, {}, JointPairing::kIndependent, 1),
      {.count = 40});
  // Steps are 1/100 of a period: the peak lies within half of one of an end, cos(π/100) = 1 − 5e-4;
  // of the trapezia the ends of unequal steps are left.
  EXPECT_NEAR(of_few.signals[0].peak.value, 0.6, 0.6 * 5e-4);
  EXPECT_NEAR(of_few.signals[0].rms.value, 0.3 * std::sqrt(1.5), 1e-4);
  // Every seventh time and the last.
  EXPECT_EQ(found.times.size(), 30U);
  EXPECT_EQ(found.times.back(), 200U);
  EXPECT_EQ(found.rows.size(), 90U);
}

bool same(const DrawnMarch& a, const DrawnMarch& b) {
  return a.band.lower == b.band.lower && a.band.upper == b.band.upper &&
         a.signals[0].peak.lower == b.signals[0].peak.lower &&
         a.signals[4].rms.upper == b.signals[4].rms.upper;
}

TEST(MarchDraws, AreTheSameOnAnyNumberOfThreads) {
  const ModelFile model = model_of(testing::one_mass(testing::iwan_joint()),
                                   {.frequency = {0.02}, .normal_load = {0.1}});
  const DrawOptions drawn{.count = 40, .seed = 3};
  const DrawnMarch one = predict(model, drawn, sine(0.9), 5, Execution::serial());
  EXPECT_TRUE(same(one, predict(model, drawn, sine(0.9), 5)));
  EXPECT_FALSE(same(one, predict(model, {.count = 40, .seed = 4}, sine(0.9), 5)));
  // The row of the model lies inside of the band of what is about it, at most times.
  std::size_t inside = 0;
  for (std::size_t at = 0; at < one.rows.size(); ++at) {
    inside += one.rows[at] >= one.band.lower[at] && one.rows[at] <= one.band.upper[at] ? 1 : 0;
  }
  EXPECT_GT(inside, one.rows.size() * 95 / 100);
}

TEST(MarchDraws, ThatFailAreCountedAndLeftOut) {
  const JointDraws failing{60, [](std::size_t i) {
                             if (i % 20 == 0) throw InputError("draw", "this", "must be another");
                             return DrawnJoint{testing::iwan_joint()};
                           }};
  const DrawnMarch found = predict(model_of(testing::one_mass(testing::iwan_joint())),
                                   {.count = 60}, sine(0.9), 50, Execution::threads(), {failing});
  EXPECT_EQ(found.taken.failed(), 3U);
  ASSERT_EQ(found.march.warnings.size(), 1U);
  EXPECT_EQ(found.march.warnings[0].code, "draws_failed");
  EXPECT_NE(march_peaks_table(found, "").find("57"), std::string::npos);
}

// The excitation of the model has a gain, but the force acts elsewhere.
TEST(MarchDraws, TellOfAGainThatMeetsNoForce) {
  const JointedStructure two(ModalModel({{1.0, 0.02}}, {{"mass", {1.0}}, {"tip", {2.0}}}), {},
                             {{"mass"}});
  const ModelFile model = model_of(two, {.force_gain = {0.05}});
  const DrawnMarch found = predict(model, {.count = 40}, sine(0.9, "tip"), 50);
  ASSERT_EQ(found.march.warnings.size(), 1U);
  EXPECT_EQ(found.march.warnings[0].code, "gain_unused");
  EXPECT_EQ(found.signals[0].peak.lower, found.signals[0].peak.upper);
}

TEST(MarchDraws, BeyondTheMemoryAreRefused) {
  const ModelFile model = model_of(linear(), {.response_gain = 0.1});
  // 3 signals at 401 times, 1203 numbers: 111 569 draws fill 1 GiB.
  EXPECT_THROW(predict(model, {.count = 111'570}, sine(0.9)), InputError);
}

}  // namespace
}  // namespace microslip::march_draws_test
