// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/signal_quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/base/error.hpp"
#include "signal/synthetic.hpp"

namespace microslip::signal_quality_test {
namespace {

using test::Signals;

/// sin ωt + b sin 3ωt: two inner loops for b > 1/9, of a depth that grows from 0 there.
FourierSeries with_third(double b) {
  FourierSeries series;
  series.omega = test::kTwoPi * 20.0;
  series.harmonic = {{0.0, -1.0}, 0.0, {0.0, -b}};
  return series;
}

TEST(ReversalsTest, InnerLoopsAboveTheNoiseCount) {
  EXPECT_EQ(reversals(with_third(0.05)).count(), 2U);
  EXPECT_EQ(reversals(with_third(0.2)).count(), 6U);
  // The inner extremes of b = 0.2 are 0.8 and 0.8433 high: a depth of 0.0433.
  const double depth = std::sqrt(1.6 / 2.4) * (1.0 + 0.6 - 0.8 * 1.6 / 2.4) - 0.8;
  EXPECT_NEAR(depth, 0.0709, 1e-3);
  const auto at_noise = [&](double share) {
    const double sigma = share * depth / (4.0 * std::sqrt(2.0));
    return reversals(with_third(0.2), std::vector<double>{sigma, 0.0, 0.0}).count();
  };
  EXPECT_EQ(at_noise(0.99), 6U);
  EXPECT_EQ(at_noise(1.01), 2U);
}

TEST(ReversalsTest, NoiseMakesNoInnerReversal) {
  // b = 1/9 is flat at the peaks: the fitted series of noisy records turns there at random.
  const Axis axis = test::even_axis(2000.0);
  std::size_t without_threshold = 0;
  for (std::uint64_t k = 0; k < 30; ++k) {
    const Signals signals{test::sampled(with_third(1.0 / 9.0), axis, 1000, 0.05, 12, k)};
    const FourierFit fit = fit_fourier(axis, test::spans(signals));
    EXPECT_EQ(reversals(fit.series[0], fit.harmonic_std[0]).count(), 2U);
    without_threshold = std::max(without_threshold, reversals(fit.series[0]).count());
  }
  EXPECT_GT(without_threshold, 2U);
}

TEST(ReversalsTest, NothingAboveTheNoise) {
  EXPECT_EQ(reversals(with_third(0.0), std::vector<double>{1.0, 0.0, 0.0}).count(), 0U);
}

TEST(DistortionTest, HarmonicsOverTheFirst) {
  FourierSeries series;
  series.omega = 1.0;
  series.harmonic = {{0.0, 2.0}, {0.03, 0.0}, {0.0, 0.04}};
  EXPECT_NEAR(distortion(series), 0.025, 1e-16);
  series.harmonic[0] = 0.0;
  EXPECT_TRUE(std::isinf(distortion(series)));
}

std::vector<double> sine(double amplitude, double noise = 0.0) {
  const Axis axis = test::even_axis(4096.0);
  return test::sampled(test::series_of(23.7, 1, amplitude, 1.0, 0.0), axis, 4096, noise);
}

TEST(ClippingTest, FlatTopsOfAClippedSignal) {
  for (const double noise : {0.0, 0.01}) {
    std::vector<double> clipped = sine(1.0, noise);
    for (double& value : clipped) value = std::clamp(value, -0.9, 0.9);
    const Clipping found = find_clipping(clipped);
    EXPECT_TRUE(found.clipped);
    EXPECT_NEAR(found.share, 2.0 * std::acos(0.9) / std::numbers::pi, 0.02);
  }
}

TEST(ClippingTest, NeitherWholeNorQuantisedSignals) {
  EXPECT_FALSE(find_clipping(sine(1.0)).clipped);
  EXPECT_FALSE(find_clipping(sine(1.0, 0.01)).clipped);
  for (const double steps : {20.0, 200.0, 2048.0}) {
    std::vector<double> quantised = sine(1.0);
    for (double& value : quantised) value = std::round(value * steps) / steps;
    EXPECT_FALSE(find_clipping(quantised).clipped) << steps;
    EXPECT_FALSE(find_dropouts(test::even_axis(4096.0), quantised).found()) << steps;
  }
}

TEST(DropoutsTest, RunsOfOneValue) {
  std::vector<double> signal = sine(1.0, 0.01);
  const Axis axis = test::even_axis(4096.0);
  EXPECT_FALSE(find_dropouts(axis, signal).found());
  std::fill(signal.begin() + 100, signal.begin() + 150, 0.0);
  std::fill(signal.begin() + 900, signal.begin() + 912, signal[899]);  // holds the last value
  const Dropouts found = find_dropouts(axis, signal);
  EXPECT_EQ(found.runs, 2U);
  EXPECT_EQ(found.longest_run, 50U);
  EXPECT_EQ(found.points, 63U);
}

TEST(DropoutsTest, GapsOfTheAxis) {
  Axis axis;
  for (int i = 0; i < 4096; ++i) axis.values.push_back((i + (i > 2000 ? 10 : 0)) / 4096.0);
  const Dropouts found = find_dropouts(axis, sine(1.0, 0.01));
  EXPECT_EQ(found.gaps, 1U);
  EXPECT_NEAR(found.longest_gap, 11.0 / 4096.0, 1e-12);
}

SignalQuality quality_of(const std::vector<double>& signal) {
  const Axis axis = test::even_axis(4096.0);
  const Signals signals{signal};
  const auto spans = test::spans(signals);
  const FourierFit fit = fit_fourier(axis, spans);
  EXPECT_TRUE(fit.summary.converged()) << fit.summary.reason;
  const CycleSeries cycles = cycle_series(axis, spans, fit);
  return signal_quality(axis, spans, fit, cycles, 0, "force");
}

TEST(SignalQualityTest, GoodSignalHasNoWarnings) {
  const SignalQuality quality = quality_of(sine(1.0, 0.01));
  EXPECT_TRUE(quality.warnings.empty());
  EXPECT_EQ(quality.reversals.count(), 2U);
  EXPECT_LT(quality.distortion, 0.005);
  EXPECT_NEAR(quality.amplitude.mean, 1.0, 0.001);
}

TEST(SignalQualityTest, DriftingAmplitudeIsFlagged) {
  std::vector<double> signal = sine(1.0, 0.01);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] *= 1.0 + 0.03 * static_cast<double>(i) / 4096.0;
  }
  const SignalQuality quality = quality_of(signal);
  EXPECT_TRUE(quality.drifts);
  EXPECT_NEAR(quality.amplitude_change, 0.03, 0.005);
  ASSERT_EQ(quality.warnings.size(), 1U);
  EXPECT_EQ(quality.warnings[0].code, "amplitude_drift");
  EXPECT_EQ(quality.warnings[0].text.rfind("force:", 0), 0U);
}

TEST(SignalQualityTest, InputIsChecked) {
  EXPECT_THROW((void)reversals(with_third(0.1), {}, {.noise_factor = -1.0}), InputError);
  EXPECT_THROW((void)reversals(with_third(0.1), std::vector<double>{1.0}), InputError);
  EXPECT_THROW((void)find_clipping(sine(1.0), {.least_run = 1}), InputError);
  EXPECT_THROW((void)find_dropouts(test::even_axis(1.0), sine(1.0), {.least_run = 2}), InputError);
}

}  // namespace
}  // namespace microslip::signal_quality_test
