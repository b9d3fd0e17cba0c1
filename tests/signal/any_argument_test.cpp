// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/signal/decay/ring_down.hpp"
#include "microslip/signal/harmonic/cycle_energy.hpp"
#include "microslip/signal/harmonic/cycle_scatter.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/harmonic/signal_quality.hpp"
#include "microslip/signal/harmonic/turning_points.hpp"

/// @file
/// Public functions of signal/ with arguments that mean nothing: a documented value or InputError.

namespace microslip::any_argument_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPoints = 256;

using Signals = std::vector<std::span<const double>>;

std::vector<double> sine() {
  std::vector<double> values;
  for (std::size_t i = 0; i < kPoints; ++i) {
    values.push_back(std::sin(2.0 * std::numbers::pi * 10.0 * static_cast<double>(i) / 256.0));
  }
  return values;
}

Axis even_axis(double step = 1.0 / 256.0) { return {.step = step, .values = {}}; }

Axis uneven_axis(std::size_t points = kPoints) {
  Axis axis;
  for (std::size_t i = 0; i < points; ++i) axis.values.push_back(static_cast<double>(i) / 256.0);
  return axis;
}

TEST(AnyArgument, OfSeriesAndAxes) {
  const FourierSeries empty;
  const FourierSeries series{.omega = 2.0, .trend = {0.5}, .harmonic = {{1.0, 2.0}, {0.1, 0.0}}};
  EXPECT_EQ(series.c(0), 0.0) << "the mean is no harmonic";
  EXPECT_EQ(empty.c(0), 0.0);
  EXPECT_EQ(series.c(static_cast<std::size_t>(-1)), 0.0);
  EXPECT_EQ(rms(series, 0), rms(series, 1));
  EXPECT_EQ(rms(series, static_cast<std::size_t>(-1)), 0.0);
  EXPECT_TRUE(std::isnan(series.value(kNaN)));
  EXPECT_THROW((void)integral(empty), InputError);
  EXPECT_TRUE(turning_points(empty).empty());
  for (const double omega : {0.0, -1.0, kNaN, kInfinity}) {
    FourierSeries bad = series;
    bad.omega = omega;
    (void)turning_points(bad);
    (void)peak_to_peak(bad);
    bad.harmonic[0] = kNaN;
    EXPECT_TRUE(turning_points(bad).empty());
  }
  EXPECT_EQ(uneven_axis(3).at(2), 2.0 / 256.0);
  EXPECT_TRUE(std::isnan(uneven_axis(3).at(3)));
  EXPECT_TRUE(std::isnan(uneven_axis(3).at(static_cast<std::size_t>(-1))));
  EXPECT_TRUE(std::isnan(values(series, uneven_axis(3), 5).back()));
}

TEST(AnyArgument, OfFits) {
  const std::vector<double> good = sine();
  const Signals one{good};
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    EXPECT_THROW((void)fit_fourier(even_axis(bad), one), InputError);
    EXPECT_THROW((void)fit_fourier(even_axis(), one, {.frequency_guess = bad}), InputError);
  }
  EXPECT_THROW((void)fit_fourier(even_axis(), Signals{}), InputError);
  EXPECT_THROW((void)fit_fourier(even_axis(), Signals{{}}), InputError);
  EXPECT_THROW((void)fit_fourier(uneven_axis(10), one), InputError);
  for (const int order : {0, -1, 101}) {
    EXPECT_THROW((void)fit_fourier(even_axis(), one, {.order = order}), InputError);
  }
  std::vector<double> broken = good;
  broken[7] = kNaN;
  EXPECT_THROW((void)fit_fourier(even_axis(), Signals{broken}), InputError);
}

TEST(AnyArgument, OfCycles) {
  const std::vector<double> good = sine();
  const Signals one{good};
  const FourierFit fit = fit_fourier(even_axis(), one);
  EXPECT_NO_THROW((void)cycle_series(even_axis(), one, fit));
  const auto refuses = [&](auto spoil) {
    FourierFit bad = fit;
    spoil(bad);
    EXPECT_THROW((void)cycle_series(even_axis(), one, bad), InputError);
  };
  for (const double value : {0.0, -1.0, kNaN, kInfinity}) {
    refuses([&](FourierFit& bad) { bad.omega = value; });
    refuses([&](FourierFit& bad) { bad.cycles = value; });
    EXPECT_THROW((void)cycle_series(even_axis(value), one, fit), InputError);
  }
  refuses([](FourierFit& bad) { bad.points = 0; });
  refuses([](FourierFit& bad) { bad.series.clear(); });
  FourierFit none;
  EXPECT_THROW((void)cycle_series(even_axis(), Signals{}, none), InputError);
  none.omega = none.cycles = 1.0;
  EXPECT_THROW((void)cycle_series(even_axis(), Signals{}, none), InputError);
  EXPECT_THROW((void)cycle_series(uneven_axis(5), one, fit), InputError);
  Axis falling = uneven_axis();
  std::ranges::reverse(falling.values);
  (void)cycle_series(falling, one, fit);
  falling.values[100] = kNaN;
  (void)cycle_series(falling, one, fit);
  (void)cycle_series(even_axis(1e300), one, fit);
  EXPECT_THROW((void)cycle_series(even_axis(), one, fit, {.order = 0}), InputError);
  EXPECT_THROW((void)scatter(std::vector<double>{}), InputError);
  EXPECT_TRUE(std::isnan(scatter(std::vector<double>{kNaN, 1.0, 2.0, 3.0, 4.0}).mean));
}

TEST(AnyArgument, OfEnergies) {
  const std::vector<double> good = sine();
  const FourierSeries series = fit_fourier(even_axis(), Signals{good}).series[0];
  const std::vector<double> errors(3);
  EXPECT_THROW((void)cycle_energy({}, {}), InputError);
  EXPECT_THROW((void)cycle_energy(series, {}), InputError);
  EXPECT_THROW((void)cycle_energy(series, series, errors), InputError);
  EXPECT_THROW((void)cycle_energy(series, series, {}, errors), InputError);
  const auto sampled = [&](const Axis& axis, std::span<const double> signal) {
    return cycle_energy_from_samples(axis, good, signal, series, series);
  };
  EXPECT_NO_THROW((void)sampled(even_axis(), good));
  for (const double step : {0.0, -1.0, kNaN, kInfinity, 1e300, 1.0}) {
    EXPECT_THROW((void)sampled(even_axis(step), good), InputError) << step;
  }
  EXPECT_THROW((void)sampled(uneven_axis(9), good), InputError);
  EXPECT_THROW((void)sampled(even_axis(), std::span(good).first(9)), InputError);
  EXPECT_THROW((void)cycle_energy_from_samples(even_axis(), {}, {}, series, series), InputError);
  EXPECT_THROW((void)linear_dissipation(std::vector{series}, {}, {}), InputError);
  const std::vector<double> bad{kNaN};
  const std::vector<double> fine{1.0};
  EXPECT_THROW((void)linear_dissipation(std::vector{series}, bad, fine), InputError);
  EXPECT_THROW((void)linear_dissipation(std::vector{series}, fine, bad), InputError);
  EXPECT_EQ(linear_dissipation({}, {}, {}).energy, 0.0);
}

TEST(AnyArgument, OfQuality) {
  const std::vector<double> good = sine();
  const Signals one{good};
  const FourierFit fit = fit_fourier(even_axis(), one);
  const CycleSeries cycles = cycle_series(even_axis(), one, fit);
  EXPECT_NO_THROW((void)signal_quality(even_axis(), one, fit, cycles, 0, "x"));
  EXPECT_THROW((void)signal_quality(even_axis(), one, fit, cycles, 1, "x"), InputError);
  FourierFit bad = fit;
  bad.harmonic_std.clear();
  EXPECT_THROW((void)signal_quality(even_axis(), one, bad, cycles, 0, "x"), InputError);
  CycleSeries empty_block = cycles;
  empty_block.block.front().clear();
  EXPECT_THROW((void)signal_quality(even_axis(), one, fit, empty_block, 0, "x"), InputError);

  EXPECT_FALSE(find_clipping({}).clipped);
  EXPECT_FALSE(find_dropouts(even_axis(), {}).found());
  Axis broken = uneven_axis();
  for (const double time : {kNaN, -1.0}) {
    broken.values[9] = time;
    EXPECT_THROW((void)find_dropouts(broken, good), InputError);
  }
  const std::vector<double> all_nan(20, kNaN);
  (void)find_clipping(all_nan);
  (void)find_dropouts(even_axis(), all_nan);
  for (const double factor : {kNaN, kInfinity, -1.0}) {
    EXPECT_THROW((void)reversals(fit.series[0], {}, {.noise_factor = factor}), InputError);
  }
  const std::vector<double> infinite(fit.order(), kInfinity);
  EXPECT_EQ(reversals(fit.series[0], infinite).count(), 0U);
  EXPECT_THROW((void)reversals(fit.series[0], std::vector<double>(1)), InputError);
}

TEST(AnyArgument, OfRingDowns) {
  const std::vector<double> good = sine();
  for (const double rate : {0.0, -1.0, kNaN, kInfinity}) {
    EXPECT_THROW((void)ring_down(good, rate, kLength), InputError);
  }
  EXPECT_THROW((void)ring_down(std::vector<double>{}, 256.0, kLength), InputError);
  EXPECT_THROW((void)ring_down(std::vector<double>(kPoints, kNaN), 256.0, kLength), InputError);
  EXPECT_THROW((void)ring_down(std::vector<double>(kPoints, 0.0), 256.0, kLength), InputError);
  EXPECT_THROW((void)ring_down(good, 256.0, kForce), InputError);
}

}  // namespace
}  // namespace microslip::any_argument_test
