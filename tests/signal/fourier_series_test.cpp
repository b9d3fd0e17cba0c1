// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/fourier_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/base/error.hpp"
#include "microslip/signal/harmonic/turning_points.hpp"
#include "signal/synthetic.hpp"

namespace microslip::fourier_series_test {
namespace {

using test::kTwoPi;

FourierSeries with_trend() {
  FourierSeries series = test::series_of(3.0, 5, 2.0, 0.6, 0.3);
  series.mean = -1.5;
  series.trend = {0.4, -0.2, 0.1, 0.05};
  series.trend_centre = 0.7;
  series.trend_half_width = 0.9;
  return series;
}

TEST(FourierSeriesTest, ValueIsMeanTrendAndHarmonics) {
  FourierSeries series;
  series.omega = 2.0;
  series.mean = 1.0;
  series.trend = {0.5, 0.25};
  series.trend_centre = 1.0;
  series.trend_half_width = 2.0;
  series.harmonic = {{3.0, 0.0}, {0.0, 4.0}};
  const double t = 1.8;
  const double s = 0.4;
  const double expected = 1.0 + 0.5 * s + 0.25 * (1.5 * s * s - 0.5) + 3.0 * std::cos(2.0 * t) -
                          4.0 * std::sin(4.0 * t);
  EXPECT_NEAR(series.value(t), expected, 1e-14);  // a few roundings of numbers up to 4
  EXPECT_NEAR(series.period(), std::numbers::pi, 1e-15);
}

TEST(FourierSeriesTest, DerivativeIsThatOfTheValue) {
  const FourierSeries series = with_trend();
  const FourierSeries slope = derivative(series);
  // Central differences of step h: truncation h²/6 |x‴| ≤ 1e−10·5e5/6 of a slope of about 100.
  const double h = 1e-5;
  for (double t = 0.0; t < 1.5; t += 0.083) {
    const double difference = (series.value(t + h) - series.value(t - h)) / (2.0 * h);
    EXPECT_NEAR(slope.value(t), difference, 2e-5);
  }
}

TEST(FourierSeriesTest, DerivativeOfTheIntegralIsThePeriodicPart) {
  const FourierSeries series = with_trend();
  const FourierSeries back = derivative(integral(series));
  for (double t = 0.0; t < 1.0; t += 0.07) {
    EXPECT_NEAR(back.value(t), series.periodic_value(t), 1e-13);
  }
  EXPECT_EQ(integral(series).mean, 0.0);
  EXPECT_TRUE(integral(series).trend.empty());
}

TEST(FourierSeriesTest, ShiftedIsTheSameSignal) {
  const FourierSeries series = with_trend();
  const FourierSeries other = shifted(series, 12.3);
  // Phases of up to 5·ω·12 = 1200 rad: 1e−13 of an argument.
  for (double t = 0.0; t < 1.0; t += 0.07) {
    EXPECT_NEAR(other.value(t - 12.3), series.value(t), 1e-11);
  }
}

TEST(FourierSeriesTest, RmsIsThatOfTheSamples) {
  const FourierSeries series = test::series_of(2.0, 4, 1.0, 0.7, 0.0);
  double sum = 0.0;
  constexpr int kPoints = 16;  // more than 2H: exact for a trigonometric polynomial
  for (int i = 0; i < kPoints; ++i) sum += std::pow(series.value(0.5 * i / kPoints), 2);
  EXPECT_NEAR(rms(series), std::sqrt(sum / kPoints), 1e-14);
  EXPECT_NEAR(std::pow(rms(series), 2) - std::pow(rms(series, 2), 2), 0.5, 1e-14);
}

TEST(FourierSeriesTest, IntegralNeedsAFrequency) {
  EXPECT_THROW((void)integral(FourierSeries{}), InputError);
}

TEST(TurningPointsTest, SineWithThirdHarmonic) {
  // x = sin ωt + b sin 3ωt: x′ = 0 where cos = 0 or sin² = (1 + 3b)/(12b), the latter for b > 1/9.
  for (const double b : {0.05, 0.3}) {
    FourierSeries series;
    series.omega = kTwoPi;
    series.harmonic = {{0.0, -1.0}, 0.0, {0.0, -b}};
    const auto points = turning_points(series);
    ASSERT_EQ(points.size(), b < 1.0 / 9.0 ? 2U : 6U);
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &TurningPoint::time));
    const PeakToPeak peaks = peak_to_peak(series);
    const double sine = b < 1.0 / 9.0 ? 1.0 : std::sqrt((1.0 + 3.0 * b) / (12.0 * b));
    const double largest = sine + b * (3.0 * sine - 4.0 * std::pow(sine, 3));
    EXPECT_NEAR(peaks.largest, largest, 1e-14);
    EXPECT_NEAR(peaks.amplitude(), largest, 1e-14);
    EXPECT_NEAR(peaks.middle(), 0.0, 1e-14);
  }
}

TEST(TurningPointsTest, OfACosineOneLiesAtTheStart) {
  FourierSeries series;
  series.omega = kTwoPi * 50.0;
  series.harmonic = {1.0};
  EXPECT_EQ(turning_points(series).size(), 2U);
  series.harmonic = {0.0};
  EXPECT_TRUE(turning_points(series).empty());
}

}  // namespace
}  // namespace microslip::fourier_series_test
