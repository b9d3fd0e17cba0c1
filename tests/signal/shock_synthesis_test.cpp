// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/shock_synthesis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "microslip/signal/shock/response_spectrum.hpp"
#include "support/figures.hpp"
#include "support/messages.hpp"

namespace microslip::shock_synthesis_test {
namespace {

using std::numbers::pi;

/// As specifications of functional shock have it: 9 dB per octave, then flat.
const RequiredSpectrum kSpecified{{20.0, 100.0, 1000.0}, {60.0, 500.0, 500.0}};

ShockOptions options_of(const RequiredSpectrum& required) {
  ShockOptions options;
  options.length = 1.2 * shortest_shock(required);
  options.sampling_rate = 20.0 * required.frequency.back();
  return options;
}

/// max |ẍ| of a mass on a base whose acceleration is linear between its times, by the classical
/// Runge–Kutta method, 200 steps in the shorter of a period and ten steps of the table: an error of
/// some (2π/200)⁴; over the shock and a period after it.
double peak_by_runge_kutta(const std::vector<double>& a, double rate, double frequency,
                           double zeta) {
  const double omega = 2.0 * pi * frequency;
  const auto pieces = static_cast<int>(std::ceil(std::max(20.0, 200.0 * frequency / rate)));
  const double h = 1.0 / rate / pieces;
  const auto at = [&](double u) {
    const auto i = static_cast<std::size_t>(u);
    if (i + 1 >= a.size()) return 0.0;
    return a[i] + (u - static_cast<double>(i)) * (a[i + 1] - a[i]);
  };
  const auto pull = [&](double z, double v, double base) {
    return -base - 2.0 * zeta * omega * v - omega * omega * z;
  };
  double z = 0.0;
  double v = 0.0;
  double peak = 0.0;
  const double end = static_cast<double>(a.size() - 1) + rate / frequency;
  for (long i = 0; static_cast<double>(i) < end * pieces; ++i) {
    const double u = static_cast<double>(i) / pieces;
    const double a0 = at(u);
    const double a1 = at(u + 0.5 / pieces);
    const double a2 = at(static_cast<double>(i + 1) / pieces);
    const double v1 = pull(z, v, a0);
    const double v2 = pull(z + 0.5 * h * v, v + 0.5 * h * v1, a1);
    const double v3 = pull(z + 0.5 * h * (v + 0.5 * h * v1), v + 0.5 * h * v2, a1);
    const double v4 = pull(z + h * (v + 0.5 * h * v2), v + h * v3, a2);
    z += h * (v + h / 6.0 * (v1 + v2 + v3));
    v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    peak = std::max(peak, std::abs(omega * (2.0 * zeta * v + omega * z)));
  }
  return peak;
}

// By another integration than that of response_spectrum(), at each frequency of the analysis. Peaks
// between steps of 1/200 of a period are low by up to (π/200)²/2 = 1e-4.
TEST(ShockSynthesis, HasTheSpectrumThatIsAskedFor) {
  for (const double zeta : {0.05, 0.02}) {
    ShockOptions options = options_of(kSpecified);
    options.damping_ratio = zeta;
    const SynthesizedShock shock = synthesize_shock(kSpecified, options);
    ASSERT_TRUE(shock.summary.converged()) << shock.summary.reason;
    ASSERT_EQ(shock.frequency.size(), 69U);  // 12 lg(50)/lg(2) = 67.7 pieces
    double worst = 0.0;
    for (std::size_t j = 0; j < shock.frequency.size(); ++j) {
      const double f = shock.frequency[j];
      // 9 dB per octave is f^(lg(500/60)/lg 5), written out here.
      const double slope = std::log(500.0 / 60.0) / std::log(5.0);
      const double required = f < 100.0 ? 60.0 * std::pow(f / 20.0, slope) : 500.0;
      const double peak = peak_by_runge_kutta(shock.acceleration, options.sampling_rate, f, zeta);
      EXPECT_NEAR(shock.required[j], required, 1e-9 * required);
      EXPECT_NEAR(peak, shock.reached[j], 2e-4 * peak) << f;
      EXPECT_LE(std::abs(20.0 * std::log10(peak / required)), 1.0 + 2e-3) << f;
      worst = std::max(worst, std::abs(20.0 * std::log10(peak / required)));
      test::record_deviation("peak", shock.reached[j], peak);
    }
    test::record_largest("worst [dB]", worst);
    EXPECT_NEAR(std::abs(shock.worst), worst, 2e-3);
  }
}

// Wavelets of whole steps have Σ w = 0 and Σ iw = 0: what is left is rounding of some thousand
// sums.
TEST(ShockSynthesis, LeavesTheBaseAtRestWhereItWas) {
  const ShockOptions options = options_of(kSpecified);
  const SynthesizedShock shock = synthesize_shock(kSpecified, options);
  const std::vector<double>& a = shock.acceleration;
  EXPECT_EQ(a.front(), 0.0);
  EXPECT_EQ(a.back(), 0.0);
  const long double h = 1.0L / static_cast<long double>(options.sampling_rate);
  long double v = 0.0L;
  long double x = 0.0L;
  double most_v = 0.0;
  double most_x = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    // ∫∫ of a straight line over a step, by Taylor's formula.
    const long double slope = (static_cast<long double>(a[i]) - a[i - 1]) / h;
    x += v * h + a[i - 1] * h * h / 2.0L + slope * h * h * h / 6.0L;
    v += a[i - 1] * h + slope * h * h / 2.0L;
    most_v = std::max(most_v, static_cast<double>(std::fabs(v)));
    most_x = std::max(most_x, static_cast<double>(std::fabs(x)));
  }
  EXPECT_LT(std::fabs(v), 1e-12L * most_v);
  EXPECT_LT(std::fabs(x), 1e-12L * most_x);
  test::record_largest("left [1]",
                       static_cast<double>(std::max(std::fabs(v) / most_v, std::fabs(x) / most_x)));
  EXPECT_NEAR(shock.peak_velocity, most_v, 1e-10 * most_v);
  EXPECT_NEAR(shock.peak_displacement, most_x, 1e-10 * most_x);
}

// A specification of pyrotechnic shock, at the lowest rate that is allowed.
TEST(ShockSynthesis, ReachesTighterTolerancesAndHighFrequencies) {
  const RequiredSpectrum high{{100.0, 2000.0, 10000.0}, {100.0, 20000.0, 20000.0}};
  ShockOptions options = options_of(high);
  options.sampling_rate = 1e5;
  EXPECT_TRUE(synthesize_shock(high, options).summary.converged());
  options = options_of(kSpecified);
  options.tolerance = 0.5;
  const SynthesizedShock shock = synthesize_shock(kSpecified, options);
  EXPECT_TRUE(shock.summary.converged()) << shock.summary.reason;
  EXPECT_LE(std::abs(shock.worst), 0.5);
  EXPECT_LE(shock.summary.residual, 1.0);
}

TEST(ShockSynthesis, IsTheSameForTheSameSeed) {
  ShockOptions options = options_of(kSpecified);
  const SynthesizedShock first = synthesize_shock(kSpecified, options);
  EXPECT_EQ(first.acceleration, synthesize_shock(kSpecified, options).acceleration);
  options.seed = 2;
  EXPECT_NE(first.acceleration, synthesize_shock(kSpecified, options).acceleration);
}

// The spectrum of no shock jumps by 20 dB within a twelfth of an octave at Q = 10: that of one
// mass and that of the next are nearly the same.
TEST(ShockSynthesis, TellsWhatItDoesNotReach) {
  const RequiredSpectrum jump{{20.0, 50.0, 51.0, 200.0}, {10.0, 10.0, 100.0, 100.0}};
  ShockOptions options = options_of(jump);
  const SynthesizedShock shock = synthesize_shock(jump, options);
  EXPECT_EQ(shock.summary.stop, Stop::kNoProgress);
  EXPECT_GT(std::abs(shock.worst), 1.0);
  EXPECT_GT(shock.summary.residual, 1.0);
  test::expect_message(shock.summary.reason, "more than the tolerance of 1 dB");
  const std::vector<double> at{shock.worst_frequency};
  std::vector<double> time;
  for (std::size_t i = 0; i < shock.acceleration.size(); ++i) {
    time.push_back(static_cast<double>(i) / options.sampling_rate);
  }
  const double reached = response_spectrum(time, shock.acceleration, at, 0.05).maximax().front();
  EXPECT_NEAR(20.0 * std::log10(reached / jump.at(shock.worst_frequency)), shock.worst, 1e-9);
}

TEST(ShockSynthesis, NamesWhatIsWrong) {
  const auto message = [](const RequiredSpectrum& required, const ShockOptions& options) {
    return test::message_or("", [&] { return synthesize_shock(required, options).worst; });
  };
  const ShockOptions good = options_of(kSpecified);
  test::expect_message(message({{20.0}, {1.0}}, good), "points of a required spectrum");
  test::expect_message(message({{20.0, 20.0}, {1.0, 1.0}}, good), "frequency[1]");
  test::expect_message(message({{20.0, 40.0}, {1.0, 0.0}}, good), "maximax[1]");
  test::expect_message(message({{20.0, 40.0}, {-1.0, 1.0}}, good), "maximax[0]");
  ShockOptions options = good;
  options.sampling_rate = 9999.0;
  test::expect_message(message(kSpecified, options), "must be 10000 Hz or more");
  options = good;
  options.length = 0.07;
  test::expect_message(message(kSpecified, options), "must be 0.075 s or more");
  options = good;
  options.per_octave = 3.0;
  test::expect_message(message(kSpecified, options), "must be from 6 to 48");
  options = good;
  options.tolerance = 0.0;
  test::expect_message(message(kSpecified, options), "must be from 0.1 to 12");
  options = good;
  options.damping_ratio = 1.0;
  test::expect_message(message(kSpecified, options), "damping ratio");
}

}  // namespace
}  // namespace microslip::shock_synthesis_test
