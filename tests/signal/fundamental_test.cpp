// SPDX-License-Identifier: MIT
// Which line is the fundamental, and when there is none.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "signal/synthetic.hpp"
#include "support/effort.hpp"

namespace microslip::fundamental_test {
namespace {

using test::kTwoPi;
using test::Signals;

constexpr double kFrequency = 40.3;
constexpr std::size_t kPoints = 4096;

const Axis& axis() {
  static const Axis axis = test::even_axis(4096.0);
  return axis;
}

/// A signal of the given amplitudes of harmonics 1, 2, …
std::vector<double> signal(const std::vector<double>& amplitudes, double noise = 0.01,
                           std::uint64_t stream = 0) {
  FourierSeries series;
  series.omega = kTwoPi * kFrequency;
  for (std::size_t n = 0; n < amplitudes.size(); ++n) {
    series.harmonic.push_back(std::polar(amplitudes[n], 0.4 + 1.7 * static_cast<double>(n)));
  }
  return test::sampled(series, axis(), kPoints, noise, 3, stream);
}

FourierFit fit(const Signals& signals, const FourierFitOptions& options = {}) {
  return fit_fourier(axis(), test::spans(signals), options);
}

void expect_fundamental(const FourierFit& fit) {
  ASSERT_TRUE(fit.summary.converged()) << fit.summary.reason;
  EXPECT_NEAR(fit.frequency(), kFrequency, 5.0 * fit.omega_std / kTwoPi);
}

void expect_failure(const FourierFit& fit, const std::string& reason) {
  EXPECT_FALSE(fit.summary.converged());
  EXPECT_NE(fit.summary.reason.find(reason), std::string::npos) << fit.summary.reason;
}

TEST(FundamentalTest, SecondHarmonicLargerThanTheFirst) {
  expect_fundamental(fit({signal({0.1, 1.0})}));
  expect_fundamental(fit({signal({0.1, 1.0, 0.0, 0.3})}));
  expect_fundamental(fit({signal({0.1, 1.0})}, {.frequency_guess = 40.0}));
}

TEST(FundamentalTest, ThirdAndFifthHarmonicLargest) {
  expect_fundamental(fit({signal({0.2, 0.1, 1.0})}));
  expect_fundamental(fit({signal({0.2, 0.0, 0.1, 0.0, 1.0})}));
}

TEST(FundamentalTest, FourthLargestIsDividedTwice) {
  expect_fundamental(fit({signal({0.3, 0.2, 0.0, 1.0})}));
  expect_fundamental(fit({signal({0.3, 0.0, 0.0, 1.0})}));
}

TEST(FundamentalTest, FundamentalMissing) { expect_fundamental(fit({signal({0.0, 1.0, 0.8})})); }

TEST(FundamentalTest, ForceOfHarmonicsBesideAPureResponse) {
  // The force has its power in harmonics 2 and 3, the responses in the first.
  const Signals signals{signal({0.05, 1.0, 0.7}, 0.01, 0), signal({1.0, 0.01}, 0.01, 1),
                        signal({1.0}, 0.01, 2)};
  expect_fundamental(fit(signals));
  expect_fundamental(fit(signals, {.frequency_guess = 40.8}));
}

TEST(FundamentalTest, NoHalfOfThePureSine) {
  // Noise at ω/2, ω/3 … must not make a longer period; many noises.
  for (std::uint64_t stream = 0; stream < test::draws_of(40, 20); ++stream) {
    expect_fundamental(fit({signal({1.0}, 0.5, stream)}));
  }
}

TEST(FundamentalTest, GuessFarOffFails) {
  const Signals signals{signal({1.0, 0.3})};
  expect_failure(fit(signals, {.frequency_guess = 50.0}), "within 3 % of the guess 50 Hz");
  expect_failure(fit(signals, {.frequency_guess = 2.0 * kFrequency}), "no periodic content");
  expect_failure(fit(signals, {.frequency_guess = 0.5 * kFrequency}), "the fundamental is 40.3 Hz");
}

TEST(FundamentalTest, FewerThanThreeCyclesFail) {
  const std::vector<double> whole = signal({1.0, 0.2}, 0.001);
  const Signals part{{whole.begin(), whole.begin() + 240}};  // 2.4 cycles
  expect_failure(fit(part), "fewer than 3");
  expect_failure(fit(part, {.frequency_guess = kFrequency}), "fewer than 3");
}

TEST(FundamentalTest, ConstantSignalsFail) {
  const FourierFit constant = fit({std::vector<double>(100, 2.5)});
  expect_failure(constant, "constant");
  EXPECT_EQ(constant.series.at(0).mean, 2.5);
}

TEST(FundamentalTest, NoiseAloneFails) {
  for (std::uint64_t stream = 0; stream < test::draws_of(20, 10); ++stream) {
    // Its strongest line may lie next to the Nyquist frequency: another reason, the same end.
    EXPECT_FALSE(fit({signal({}, 1.0, stream)}).summary.converged());
    expect_failure(fit({signal({}, 1.0, stream)}, {.frequency_guess = 40.0}),
                   "no periodic content");
  }
}

TEST(FundamentalTest, RandomWalkSeldomLooksPeriodic) {
  MICROSLIP_OF_RELEASE_ALONE();
  int taken = 0;
  for (std::uint64_t stream = 0; stream < 20; ++stream) {
    RandomStream random(8, stream);
    std::vector<double> walk(kPoints, 0.0);
    for (std::size_t i = 1; i < kPoints; ++i) walk[i] = walk[i - 1] + random.normal();
    taken += fit({walk}).summary.converged() ? 1 : 0;
  }
  EXPECT_LE(taken, 2);  // one with three oscillations cannot be distinguished from a vibration
}

TEST(FundamentalTest, TooFewPointsACycleFail) {
  const Axis slow = test::even_axis(4.0);
  const FourierSeries series = test::series_of(1.9, 1, 1.0, 1.0, 0.0);
  const Signals signals{test::sampled(series, slow, 400)};
  expect_failure(fit_fourier(slow, test::spans(signals), {.frequency_guess = 1.9}),
                 "points per cycle");
  expect_failure(fit_fourier(slow, test::spans(signals)), "points per cycle");
}

TEST(FundamentalTest, GivenFrequencyIsHeld) {
  const FourierFit held =
      fit({signal({1.0, 0.2})}, {.frequency_guess = kFrequency, .fit_frequency = false});
  ASSERT_TRUE(held.summary.converged());
  EXPECT_NEAR(held.frequency(), kFrequency, 1e-13);
  EXPECT_EQ(held.omega_std, 0.0);
}

}  // namespace
}  // namespace microslip::fundamental_test
