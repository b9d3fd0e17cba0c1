// SPDX-License-Identifier: MIT
// Records whose noise is so small that rounding decides the last steps: simulated ones, and those
// of converters. Whatever the last digits are, the search for the frequency ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "signal/synthetic.hpp"
#include "support/effort.hpp"

namespace microslip::attainable_accuracy_test {
namespace {

using test::kTwoPi;
using test::Signals;

constexpr double kRate = 4096.0;
constexpr std::uint64_t kDraws = 8;

/// Changes of a sample on storage in a file.
using Sampler = std::function<double(double value, RandomStream& random)>;

Sampler noise_of(double deviation) {
  return [=](double value, RandomStream& random) { return value + deviation * random.normal(); };
}

/// A converter of ±8.
Sampler converter(int bits) {
  const double steps = std::pow(2.0, bits - 4);
  return [=](double value, RandomStream&) { return std::round(steps * value) / steps; };
}

/// Four signals of order 9 about a frequency, length and phases drawn by the seed.
struct Drawn {
  double frequency = 0.0;
  double guess = 0.0;
  Axis axis;
  Signals signals;
};

Drawn drawn(std::uint64_t seed, const Sampler& sampler, bool even = true) {
  RandomStream random(99, seed);
  Drawn record;
  record.frequency = 20.0 + 80.0 * random.uniform();
  record.guess = record.frequency * (1.0 + 0.01 * (random.uniform() - 0.5));
  const double least = 3.2 * kRate / record.frequency;  // points, for the 3 cycles that are needed
  const auto points = static_cast<std::size_t>(std::max(200.0 + 4000.0 * random.uniform(), least));
  record.axis = test::even_axis(kRate);
  if (!even) record.axis = test::jittered_axis(record.axis, points, 0.45, seed);
  for (int j = 0; j < 4; ++j) {
    const FourierSeries series =
        test::series_of(record.frequency, 9, 1.0, 0.1 + 0.1 * j, j + random.uniform());
    std::vector<double>& x =
        record.signals.emplace_back(test::sampled(series, record.axis, points));
    for (double& value : x) value = sampler(value, random) * (j == 1 ? 1e-9 / 3.0 : 1.0);
  }
  return record;
}

FourierFit fit(const Drawn& record, bool guessed = true) {
  FourierFitOptions options{.order = 9};
  if (guessed) options.frequency_guess = record.guess;
  return fit_fourier(record.axis, test::spans(record.signals), options);
}

/// Within five of its standard errors or, where these are smaller, what rounding of the phases
/// leaves: 1e−13, at which the search ends, and 450 roundings of a double.
void expect_found(const Drawn& record, bool guessed) {
  const FourierFit found = fit(record, guessed);
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  EXPECT_NEAR(found.omega, kTwoPi * record.frequency,
              5.0 * found.omega_std + 2e-13 * kTwoPi * record.frequency);
  EXPECT_LE(found.summary.iterations, 20);
}

void expect_found(const Sampler& sampler) {
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    SCOPED_TRACE(seed);
    expect_found(drawn(seed, sampler), true);
    expect_found(drawn(seed, sampler), false);
    expect_found(drawn(seed, sampler, false), true);
  }
}

TEST(AttainableAccuracyTest, OfNoiseFromNothingToAHundredth) {
  MICROSLIP_OF_RELEASE_ALONE();
  for (int half_decade = -32; half_decade <= -4; ++half_decade) {
    SCOPED_TRACE(half_decade / 2.0);
    expect_found(noise_of(std::pow(10.0, half_decade / 2.0)));
  }
}

TEST(AttainableAccuracyTest, OfRoundedRecords) {
  expect_found([](double value, RandomStream&) { return value; });
  expect_found([](double value, RandomStream&) { return static_cast<double>(float(value)); });
  for (const int bits : {12, 16, 20, 22, 24}) {
    SCOPED_TRACE(bits);
    expect_found(converter(bits));
  }
}

/// Other last digits move the frequency by as little as the search for it leaves: 1e−4 standard
/// errors.
void expect_same(const FourierFit& found, const FourierFit& other) {
  ASSERT_TRUE(other.summary.converged()) << other.summary.reason;
  EXPECT_NEAR(other.omega, found.omega, 2e-4 * found.omega_std + 2e-13 * found.omega);
}

TEST(AttainableAccuracyTest, OtherLastDigitsChangeNothing) {
  for (const double noise : {1e-9, 1e-7, 3e-7, 1e-6, 1e-4}) {
    for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
      SCOPED_TRACE(testing::Message() << "noise " << noise << ", seed " << seed);
      const Drawn record = drawn(seed, noise_of(noise));
      const FourierFit found = fit(record);
      ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
      RandomStream random(7, seed);
      Drawn moved = record;
      for (std::vector<double>& x : moved.signals) {
        for (double& value : x) value *= 1.0 + 1e-16 * random.normal();
      }
      expect_same(found, fit(moved));
      Drawn permuted = record;  // the sums over signals in another order
      std::ranges::reverse(permuted.signals);
      expect_same(found, fit(permuted));
      Drawn backwards = record;  // and those over points
      for (std::vector<double>& x : backwards.signals) std::ranges::reverse(x);
      expect_same(found, fit(backwards));
    }
  }
}

}  // namespace
}  // namespace microslip::attainable_accuracy_test
