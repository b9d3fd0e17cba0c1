// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/fourier_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "microslip/base/error.hpp"
#include "signal/synthetic.hpp"
#include "support/figures.hpp"

namespace microslip::fourier_fit_test {
namespace {

using test::kTwoPi;
using test::Signals;

constexpr double kFrequency = 55.637;  // Hz; no whole number of samples per cycle

struct Record {
  Axis axis;
  std::vector<FourierSeries> truth;
  Signals signals;
};

/// Two signals of order 10, the second with harmonics as large as its first, on offset and drift.
Record record_of(const Axis& axis, std::size_t points, double noise = 0.0, std::uint64_t seed = 1) {
  Record record{axis, {}, {}};
  for (std::uint64_t j = 0; j < 2; ++j) {
    FourierSeries series = test::series_of(kFrequency, 10, 1.0 + 3.0 * static_cast<double>(j),
                                           j == 0 ? 0.4 : 1.0, static_cast<double>(j));
    series.mean = 5.0;
    series.trend = {0.3};
    series.trend_centre = 0.5 * (axis.at(0) + axis.at(points - 1));
    series.trend_half_width = 0.5 * (axis.at(points - 1) - axis.at(0));
    record.signals.push_back(test::sampled(series, axis, points, noise, seed, j));
    record.truth.push_back(series);
  }
  return record;
}

FourierFit fit_of(const Record& record, const FourierFitOptions& options = {}) {
  return fit_fourier(record.axis, test::spans(record.signals), options);
}

/// ω to 1e−10 and the coefficients to 1e−9 of the largest: what rounding of sums over the record
/// allows with room to spare; no other error is there.
void expect_exact(const FourierFit& fit, const Record& record) {
  ASSERT_TRUE(fit.summary.converged()) << fit.summary.reason;
  EXPECT_NEAR(fit.frequency() / kFrequency, 1.0, 1e-10);
  test::record_deviation("frequency", fit.frequency(), kFrequency);
  for (std::size_t j = 0; j < record.truth.size(); ++j) {
    EXPECT_LT(test::coefficient_error(fit.series[j], record.truth[j]), 1e-9);
    test::record_largest("coefficients [1]",
                         test::coefficient_error(fit.series[j], record.truth[j]));
    EXPECT_NEAR(fit.series[j].mean, 5.0, 1e-9);
    EXPECT_NEAR(fit.series[j].trend.at(0), 0.3, 1e-9);
    EXPECT_LT(fit.residual_rms[j], 1e-9);
    EXPECT_GT(fit.explained[j], 1.0 - 1e-12);
  }
}

TEST(FourierFitTest, ExactWithoutNoise) {
  // 3.3 to 56 cycles, without guess and with one up to 2.5 % off.
  for (const std::size_t points : {500U, 1000U, 4096U, 8192U}) {
    const Record record = record_of(test::even_axis(8192.0, -0.2), points);
    expect_exact(fit_of(record), record);
    for (const double off : {0.975, 0.99, 1.0, 1.01, 1.025}) {
      SCOPED_TRACE(::testing::Message() << points << " points, guess times " << off);
      expect_exact(fit_of(record, {.frequency_guess = off * kFrequency}), record);
    }
  }
}

TEST(FourierFitTest, ExactForUnevenTimes) {
  const Axis axis = test::jittered_axis(test::even_axis(8192.0), 3000, 0.45, 5);
  const Record record = record_of(axis, 3000);
  expect_exact(fit_of(record), record);
  expect_exact(fit_of(record, {.frequency_guess = 1.01 * kFrequency}), record);
}

TEST(FourierFitTest, EvenTimesGivenOneByOneChangeNothing) {
  Record record = record_of(test::even_axis(4096.0, 3.0), 2000, 0.05);
  const FourierFit even = fit_of(record);
  Axis listed;
  for (std::size_t i = 0; i < 2000; ++i)
    listed.values.push_back(3.0 + static_cast<double>(i) / 4096.0);
  record.axis = listed;
  const FourierFit uneven = fit_of(record);
  // Both stop within 1e−4 standard errors of the minimum.
  EXPECT_NEAR(uneven.omega, even.omega, 2e-4 * even.omega_std);
  EXPECT_NEAR(uneven.omega_std, even.omega_std, 1e-6 * even.omega_std);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_LT(test::coefficient_error(uneven.series[j], even.series[j]), 1e-6);
    EXPECT_NEAR(uneven.residual_rms[j], even.residual_rms[j], 1e-9);
  }
}

TEST(FourierFitTest, MeanSquareIsThatOfSeriesAndResidual) {
  // Parseval: over a record of whole cycles the harmonics are orthogonal.
  Record record{test::even_axis(1000.0), {}, {}};
  const FourierSeries series = test::series_of(20.0, 10, 1.0, 0.5, 0.0);
  record.signals.push_back(test::sampled(series, record.axis, 1000, 0.1));
  const FourierFit fit =
      fit_of(record, {.frequency_guess = 20.0, .trend_degree = 0, .fit_frequency = false});
  double square = 0.0;
  for (const double value : record.signals[0]) square += value * value / 1000.0;
  EXPECT_NEAR(square,
              std::pow(rms(fit.series[0]), 2) + std::pow(fit.residual_rms[0], 2) +
                  std::pow(fit.series[0].mean, 2),
              1e-13);
}

TEST(FourierFitTest, ScalesDoNotMatter) {
  // Newtons beside nanometres: each signal weighs with its own scatter.
  Record record = record_of(test::even_axis(4096.0), 2000, 0.05);
  const FourierFit plain = fit_of(record);
  for (double& value : record.signals[1]) value *= 1e-9;
  const FourierFit scaled = fit_of(record);
  EXPECT_NEAR(scaled.omega, plain.omega, 2e-4 * plain.omega_std);
  EXPECT_NEAR(scaled.harmonic_std[1][0] / plain.harmonic_std[1][0], 1e-9, 1e-12);
}

/// Scatter of the estimates over many records over the mean stated standard error.
struct ErrorRatios {
  double omega;
  double coefficient;
};

ErrorRatios monte_carlo(ResidualModel model, double correlation, std::size_t points) {
  constexpr int kRecords = 300;
  const Axis axis = test::even_axis(2048.0);
  const double middle = 0.5 * axis.at(points - 1);
  const FourierSeries truth = shifted(test::series_of(50.0, 3, 1.0, 0.5, 0.4), -middle);
  double omega_square = 0.0;
  double omega_variance = 0.0;
  double square = 0.0;
  double variance = 0.0;
  for (std::uint64_t k = 0; k < kRecords; ++k) {
    Signals signals;
    for (std::uint64_t j = 0; j < 2; ++j) {
      std::vector<double> x = values(truth, axis, points);
      RandomStream random(11 + j, k);
      double coloured = 0.0;
      for (double& value : x) {
        coloured = correlation * coloured + random.normal();
        value += 0.1 * coloured;
      }
      signals.push_back(x);
    }
    const FourierFit fit = fit_fourier(axis, test::spans(signals),
                                       {.order = 3, .frequency_guess = 50.0, .residuals = model});
    omega_square += std::pow(fit.omega - truth.omega, 2);
    omega_variance += std::pow(fit.omega_std, 2);
    for (std::size_t j = 0; j < 2; ++j) {
      const FourierSeries found = shifted(fit.series[j], middle);
      for (std::size_t n = 1; n <= 3; ++n) {
        const std::complex<double> expected = shifted(truth, middle).c(n);
        square += std::norm(found.c(n) - expected) / 2.0;
        variance += std::pow(fit.harmonic_std[j][n - 1], 2);
      }
    }
  }
  return {std::sqrt(omega_square / omega_variance), std::sqrt(square / variance)};
}

/// 300 records give the scatter to 4 %, and 1.2 is required.
void expect_right(const ErrorRatios& ratios) {
  EXPECT_GT(ratios.omega, 1.0 / 1.2);
  EXPECT_LT(ratios.omega, 1.2);
  EXPECT_GT(ratios.coefficient, 1.0 / 1.2);
  EXPECT_LT(ratios.coefficient, 1.2);
}

TEST(FourierFitTest, StandardErrorsAreRightForWhiteNoise) {
  expect_right(monte_carlo(ResidualModel::kWhite, 0.0, 1100));
  expect_right(monte_carlo(ResidualModel::kBlocks, 0.0, 1100));
  // 4.9 cycles: too few for blocks.
  expect_right(monte_carlo(ResidualModel::kBlocks, 0.0, 200));
}

TEST(FourierFitTest, BlocksKeepStandardErrorsRightForColouredNoise) {
  // AR(1) of 0.95 has at 50 … 150 Hz some 2 … 6 times the power of white noise of its variance.
  expect_right(monte_carlo(ResidualModel::kBlocks, 0.95, 1100));
  EXPECT_GT(monte_carlo(ResidualModel::kWhite, 0.95, 1100).coefficient, 1.2);
}

TEST(FourierFitTest, OrderIsReducedBelowTheNyquistFrequency) {
  Record record{test::even_axis(512.0), {}, {}};
  const FourierSeries series = test::series_of(60.0, 3, 1.0, 0.5, 0.0);
  record.signals.push_back(test::sampled(series, record.axis, 512, 0.001));
  const FourierFit fit = fit_of(record);
  ASSERT_TRUE(fit.summary.converged()) << fit.summary.reason;
  EXPECT_EQ(fit.order(), 3U);  // 0.45·512/60 = 3.8
  ASSERT_EQ(fit.warnings.size(), 1U);
  EXPECT_EQ(fit.warnings[0].code, "order_reduced");
}

TEST(FourierFitTest, ConstantSignalAmongOthersIsNamed) {
  Record record = record_of(test::even_axis(8192.0), 4096, 0.01);
  record.signals.insert(record.signals.begin(), std::vector<double>(4096, 0.7));
  const FourierFit fit = fit_of(record);
  ASSERT_TRUE(fit.summary.converged()) << fit.summary.reason;
  EXPECT_EQ(fit.warnings.at(0).code, "signal_constant");
  EXPECT_NEAR(fit.series[0].mean, 0.7, 1e-13);  // rounding of a sum of 4096
  EXPECT_EQ(rms(fit.series[0]), 0.0);
  EXPECT_EQ(fit.series[0].omega, fit.omega);
}

TEST(FourierFitTest, InputIsChecked) {
  const Record record = record_of(test::even_axis(8192.0), 1000);
  const auto with = [&](FourierFitOptions options) { (void)fit_of(record, options); };
  EXPECT_THROW(with({.order = 0}), InputError);
  EXPECT_THROW(with({.frequency_guess = -1.0}), InputError);
  EXPECT_THROW(with({.guess_tolerance = 0.5}), InputError);
  EXPECT_THROW(with({.trend_degree = 5}), InputError);
  EXPECT_THROW(with({.fit_frequency = false}), InputError);
  EXPECT_THROW((void)fit_fourier(record.axis, {}), InputError);
  Record bad = record;
  bad.signals[1][17] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)fit_of(bad), InputError);
  bad = record;
  bad.signals[1].pop_back();
  EXPECT_THROW((void)fit_of(bad), InputError);
  bad = record;
  bad.axis.dimension = microslip::kAngle;
  EXPECT_THROW((void)fit_of(bad), InputError);
}

}  // namespace
}  // namespace microslip::fourier_fit_test
