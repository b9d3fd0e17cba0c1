// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/load_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "support/effort.hpp"
#include "support/messages.hpp"

namespace microslip::load_shapes_test {
namespace {

using std::numbers::pi;

double mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

/// |∫ x e^{−2πift} dt|²·2/T over a record of T: its density at f.
double density_at(const std::vector<double>& values, double rate, double f) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i] * std::polar(1.0, -2.0 * pi * f * static_cast<double>(i) / rate);
  }
  return 2.0 * std::norm(sum) / (rate * static_cast<double>(values.size()));
}

/// As a specification has it: rising, flat, falling.
const PowerDensity kSpecified{{20.0, 80.0, 350.0, 500.0}, {0.01, 0.04, 0.04, 0.02}};

// ∫ of a straight line in logarithms, by the trapezium rule over 1e6 points: 1e-9 of its error.
TEST(PowerDensity, HasTheAreaOfItsLine) {
  double area = 0.0;
  constexpr int kPieces = 1'000'000;
  const double step = (500.0 - 20.0) / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    area += 0.5 * step * (kSpecified.at(20.0 + step * i) + kSpecified.at(20.0 + step * (i + 1)));
  }
  EXPECT_NEAR(kSpecified.rms(), std::sqrt(area), 1e-8 * std::sqrt(area));
  EXPECT_EQ(kSpecified.at(19.0), 0.0);
  EXPECT_EQ(kSpecified.at(501.0), 0.0);
  EXPECT_NEAR(kSpecified.at(200.0), 0.04, 1e-15);
  const PowerDensity one_over_f{{10.0, 1000.0}, {0.1, 0.001}};  // where the power of f is −1
  EXPECT_NEAR(one_over_f.rms(), std::sqrt(std::log(100.0)), 1e-12);
}

// Over 40 seeds of 2 s: some 2·480·2·40 independent squares, so that the variance is known to
// √(2/76800) = 0.5 %; four deviations. At one frequency 40 squares of two degrees each: 16 %.
TEST(StationaryNoise, HasTheDensityThatIsAskedFor) {
  constexpr double kRate = 2048.0;
  double square = 0.0;
  double at_60 = 0.0;
  double at_450 = 0.0;
  double above = 0.0;
  constexpr int kSeeds = 40;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<double> noise = stationary_noise(4096, kRate, kSpecified, seed, 0);
    ASSERT_EQ(noise.size(), 4096U);
    square += mean_square(noise) / kSeeds;
    at_60 += density_at(noise, kRate, 60.0) / kSeeds;
    at_450 += density_at(noise, kRate, 450.0) / kSeeds;
    above += density_at(noise, kRate, 700.0) / kSeeds;
  }
  EXPECT_NEAR(square / std::pow(kSpecified.rms(), 2), 1.0, 0.02);
  EXPECT_NEAR(at_60 / kSpecified.at(60.0), 1.0, 0.6);
  EXPECT_NEAR(at_450 / kSpecified.at(450.0), 1.0, 0.6);
  EXPECT_LT(above, 1e-6 * at_450);
  EXPECT_EQ(stationary_noise(100, kRate, kSpecified, 7, 1),
            stationary_noise(100, kRate, kSpecified, 7, 1));
  EXPECT_NE(stationary_noise(100, kRate, kSpecified, 7, 1),
            stationary_noise(100, kRate, kSpecified, 7, 2));
}

// A narrow density between the lines of a short record, and one below them: over 400 seeds the
// variance is known to 1/√400 of itself and less. A band of 0.1 Hz in a record of 1 s is one slow
// sine.
TEST(StationaryNoise, OfANarrowBandHasItsVariance) {
  for (const PowerDensity& narrow :
       {PowerDensity{{5.0, 5.1}, {1.0, 1.0}}, PowerDensity{{0.5, 0.55}, {1.0, 1.0}}}) {
    const std::uint64_t seeds = test::draws_of(400, 60);
    double square = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      square += mean_square(stationary_noise(64, 64.0, narrow, seed, 0));
    }
    square /= static_cast<double>(seeds);
    EXPECT_NEAR(square / std::pow(narrow.rms(), 2), 1.0, test::bound_of(0.3));
  }
}

TEST(LoadShapes, AreWhatTheirFormulasSay) {
  const std::vector<double> time = even_times(0.1, 1000.0);
  ASSERT_EQ(time.size(), 101U);
  EXPECT_EQ(time.back(), 0.1);
  const std::vector<std::complex<double>> harmonics{1.0, 0.0, {0.0, 0.2}};
  const std::vector<double> burst = sine_burst(time, harmonics, 50.0, 0.06);
  const std::vector<double> pulse = half_sine(time, 0.01, 0.02);
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double turn = 2.0 * pi * 50.0 * time[i];
    EXPECT_NEAR(burst[i], time[i] < 0.06 ? std::cos(turn) - 0.2 * std::sin(3.0 * turn) : 0.0,
                1e-12);
    const double share = (time[i] - 0.01) / 0.02;
    EXPECT_NEAR(pulse[i], share > 0.0 && share < 1.0 ? std::sin(pi * share) : 0.0, 1e-12);
  }
}

// The frequency at half of the time, from the turns between two times near it: the mean of the two
// ends, or their geometric mean.
TEST(SineSweep, PassesItsFrequenciesLinearlyOrByRatios) {
  for (const bool logarithmic : {false, true}) {
    const double half = logarithmic ? std::sqrt(10.0 * 160.0) : 85.0;
    const std::vector<double> time{0.0, 0.5 - 1e-4, 0.5, 0.5 + 1e-4, 1.0};
    const std::vector<double> x = sine_sweep(time, 10.0, 160.0, logarithmic);
    const double curvature = (x[1] - 2.0 * x[2] + x[3]) / 1e-8;
    const double slope = (x[3] - x[1]) / 2e-4;
    EXPECT_NEAR(
        std::sqrt(slope * slope + std::pow(curvature / (2.0 * pi * half), 2)) / (2.0 * pi * half),
        1.0, 1e-2);
  }
}

TEST(LoadShapes, NameWhatIsWrong) {
  const auto message = [](const auto& call) { return test::message_or("", call); };
  test::expect_message(message([] { return even_times(0.0, 1.0); }), "duration");
  test::expect_message(message([] { return even_times(1e9, 1e9); }), "number of times");
  test::expect_message(message([] { return stationary_noise(8, 900.0, kSpecified, 1, 1); }),
                       "twice the highest frequency, 500 Hz");
  PowerDensity falling = kSpecified;
  falling.frequency[2] = 70.0;
  test::expect_message(message([&] {
                         falling.check();
                         return 0;
                       }),
                       "frequency[2]");
  PowerDensity empty = kSpecified;
  empty.density[1] = 0.0;
  test::expect_message(message([&] {
                         empty.check();
                         return 0;
                       }),
                       "density[1]");
  const std::vector<double> time{0.0, 1.0};
  test::expect_message(message([&] { return sine_sweep(time, 10.0, 10.0, true); }),
                       "must differ from the first");
  test::expect_message(message([&] { return half_sine(time, 0.0, 0.0); }), "duration of a pulse");
}

}  // namespace
}  // namespace microslip::load_shapes_test
