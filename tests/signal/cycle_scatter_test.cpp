// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/cycle_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/base/error.hpp"
#include "signal/synthetic.hpp"

namespace microslip::cycle_scatter_test {
namespace {

using test::Signals;

struct Fitted {
  Axis axis;
  Signals signals;
  FourierFit fit;
  [[nodiscard]] CycleSeries cycles(int order = 10) const {
    return cycle_series(axis, test::spans(signals), fit, {.order = order});
  }
};

Fitted fitted(const Axis& axis, Signals signals, const FourierFitOptions& options = {}) {
  FourierFit fit = fit_fourier(axis, test::spans(signals), options);
  EXPECT_TRUE(fit.summary.converged()) << fit.summary.reason;
  return {axis, std::move(signals), std::move(fit)};
}

TEST(CycleSeriesTest, EachCycleOfAPeriodicRecordIsTheSeries) {
  FourierSeries truth = test::series_of(31.7, 6, 2.0, 0.6, 0.1);
  truth.mean = 4.0;
  const Axis even = test::even_axis(2048.0, 0.5);
  for (const Axis& axis : {even, test::jittered_axis(even, 2048, 0.3, 9)}) {
    const Fitted record = fitted(axis, {test::sampled(truth, axis, 2048)});
    const CycleSeries cycles = record.cycles(6);
    EXPECT_EQ(cycles.cycles_per_block, 1);
    ASSERT_EQ(cycles.block.size(), 31U);
    for (const auto& block : cycles.block) {
      // Rounding of 64 points and 13 unknowns; trends of 1e−12 that were fitted.
      EXPECT_LT(test::coefficient_error(block[0], truth), 1e-9);
      EXPECT_NEAR(block[0].mean, 4.0, 1e-9);
    }
    EXPECT_NEAR(cycles.middle[1] - cycles.middle[0], truth.period(), 1e-9);
  }
}

TEST(CycleSeriesTest, WholeRecordLosesNoCycle) {
  const Axis axis = test::even_axis(1000.0);
  const Fitted record =
      fitted(axis, {test::sampled(test::series_of(20.0, 2, 1.0, 0.5, 0.0), axis, 1000)});
  EXPECT_EQ(record.cycles(2).block.size(), 20U);
}

TEST(CycleSeriesTest, FewPointsACycleMakeBlocks) {
  const Axis axis =
      test::even_axis(200.0);  // 7.3 points per cycle; order 3, so 14 points are asked
  const FourierSeries truth = test::series_of(27.4, 3, 1.0, 0.4, 0.2);
  const Fitted record = fitted(axis, {test::sampled(truth, axis, 1000, 1e-4)});
  ASSERT_EQ(record.fit.order(), 3U);
  const CycleSeries cycles = record.cycles();
  EXPECT_EQ(cycles.cycles_per_block, 2);
  EXPECT_EQ(cycles.block.size(), 68U);  // 137 cycles
  for (const auto& block : cycles.block) {
    EXPECT_LT(test::coefficient_error(block[0], truth), 2e-3);  // noise 1e−4·√(2/14)·5
  }
}

TEST(CycleSeriesTest, ScatterOverCyclesIsTheErrorOfTheFit) {
  const Axis axis = test::even_axis(4096.0);
  const FourierSeries truth = test::series_of(50.3, 2, 1.0, 0.4, 0.2);
  const Fitted record =
      fitted(axis, {test::sampled(truth, axis, 8192, 0.05)}, {.residuals = ResidualModel::kWhite});
  const Scatter amplitude = scatter(
      record.cycles(2), [](std::span<const FourierSeries> s) { return std::abs(s[0].c(1)); });
  EXPECT_EQ(amplitude.count, 100U);
  // σ√(2/81) a cycle, known to 7 % from 100 cycles.
  EXPECT_NEAR(amplitude.deviation, 0.05 * std::sqrt(2.0 / 81.4), 0.25 * amplitude.deviation);
  EXPECT_NEAR(amplitude.standard_error / record.fit.harmonic_std[0][0], 1.0, 0.3);
  EXPECT_NEAR(amplitude.mean, 1.0, 4.0 * amplitude.standard_error);
}

TEST(ScatterTest, StandardErrorIsRightForWhiteAndCorrelatedValues) {
  // AR(1): the exact variance of a mean is close to σ²/N (1 + ρ)/(1 − ρ).
  for (const double rho : {0.0, 0.6}) {
    double square = 0.0;
    double variance = 0.0;
    constexpr int kSeries = 400;
    for (std::uint64_t k = 0; k < kSeries; ++k) {
      RandomStream random(21, k);
      double x = random.normal() / std::sqrt(1.0 - rho * rho);
      std::vector<double> values;
      for (int i = 0; i < 60; ++i) {
        values.push_back(10.0 + x);
        x = rho * x + random.normal();
      }
      const Scatter result = scatter(values);
      square += std::pow(result.mean - 10.0, 2);
      variance += std::pow(result.standard_error, 2);
    }
    const double ratio = std::sqrt(square / variance);
    EXPECT_GT(ratio, 1.0 / 1.25) << rho;  // 400 series: 3.5 %; the factor itself is estimated
    EXPECT_LT(ratio, 1.25) << rho;
  }
}

TEST(ScatterTest, DriftIsSignificantOnlyWhereItIs) {
  int significant = 0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    RandomStream random(22, k);
    std::vector<double> still;
    std::vector<double> drifting;
    for (int i = 0; i < 50; ++i) {
      still.push_back(random.normal());
      drifting.push_back(still.back() + 0.1 * i);
    }
    significant += scatter(still).slope_significance() > 4.0 ? 1 : 0;
    const Scatter drift = scatter(drifting);
    EXPECT_GT(drift.slope_significance(), 4.0);
    EXPECT_NEAR(drift.slope, 0.1, 5.0 * drift.slope_std);
  }
  EXPECT_EQ(significant, 0);
}

TEST(ScatterTest, FewValuesTellNothing) {
  const std::vector<double> three{1.0, 2.0, 3.0};
  EXPECT_EQ(scatter(three).mean, 2.0);
  EXPECT_TRUE(std::isnan(scatter(three).standard_error));
  EXPECT_THROW((void)scatter(std::vector<double>{}), InputError);
  const std::vector<double> equal(10, 3.0);
  EXPECT_EQ(scatter(equal).standard_error, 0.0);
}

TEST(CycleSeriesTest, InputIsChecked) {
  const Axis axis = test::even_axis(1000.0);
  Fitted record =
      fitted(axis, {test::sampled(test::series_of(20.0, 2, 1.0, 0.5, 0.0), axis, 1000)});
  EXPECT_THROW((void)record.cycles(0), InputError);
  record.signals[0].pop_back();
  EXPECT_THROW((void)record.cycles(), InputError);
}

}  // namespace
}  // namespace microslip::cycle_scatter_test
