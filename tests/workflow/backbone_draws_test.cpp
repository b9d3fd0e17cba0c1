// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/backbone_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::backbone_draws_test {
namespace {

constexpr double kZeta = 0.01;

/// One mode of 1 rad/s: at phase resonance A = 2ζω² a, at ω.
JointedStructure linear() {
  return {ModalModel({{1.0, 2.0 * kZeta}}, {{"mass", {1.0}}}), {}, {{"mass"}}};
}

BackboneSpread predict(const StructureSpread& spread, std::size_t count) {
  const HarmonicBalance balance(linear(), {"mass"});
  const std::vector<double> responses{1.0, 2.0};
  const ResponseCurve curve = balance.resonances(responses);
  const StructureDraws draws(linear(), spread, {}, JointPairing::kIndependent, 1);
  return backbone_spread(balance, curve, responses, 0, draws, {.count = count});
}

/// ln of upper over lower is 2 · 1.96 σ, within four standard deviations of two quantiles of N
/// draws, 2.67σ√(2/N).
void expect_spread(const Band& band, double sigma, std::size_t count) {
  for (std::size_t i = 0; i < band.lower.size(); ++i) {
    EXPECT_NEAR(std::log(band.upper[i] / band.lower[i]), 2.0 * 1.96 * sigma,
                4.0 * 2.67 * sigma * std::sqrt(2.0 / static_cast<double>(count)));
  }
}

TEST(BackboneDraws, OfALinearModeByItsClosedForm) {
  constexpr std::size_t kDraws = 1000;
  const BackboneSpread frequency = predict({.frequency = {0.01}}, kDraws);
  ASSERT_EQ(frequency.frequency.lower.size(), 2U);
  expect_spread(frequency.frequency, 0.01, kDraws);
  expect_spread(frequency.force, 0.02, kDraws);
  const BackboneSpread damping = predict({.loss_factor = {0.1}}, kDraws);
  expect_spread(damping.damping_ratio, 0.1, kDraws);
  expect_spread(damping.force, 0.1, kDraws);
  for (const StructureSpread& gain :
       {StructureSpread{.force_gain = {0.05}}, StructureSpread{.response_gain = 0.05}}) {
    expect_spread(predict(gain, kDraws).force, 0.05, kDraws);
  }
}

}  // namespace
}  // namespace microslip::backbone_draws_test
