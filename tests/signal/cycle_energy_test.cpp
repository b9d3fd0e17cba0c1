// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/cycle_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/base/error.hpp"
#include "signal/synthetic.hpp"

namespace microslip::cycle_energy_test {
namespace {

using test::Signals;

constexpr double kMass = 0.8;        // kg
constexpr double kViscosity = 3.0;   // N s/m
constexpr double kStiffness = 9000;  // N/m

/// An oscillator with viscous damping, of which force and work are known: f = mẅ + cẇ + kw.
struct Oscillator {
  FourierSeries force;
  FourierSeries acceleration;
  double work = 0.0;  ///< ∮ c ẇ² dt = T c rms(ẇ)²
};

Oscillator oscillator(double frequency) {
  const FourierSeries displacement = test::series_of(frequency, 4, 1e-3, 0.3, 0.2);
  const FourierSeries velocity = derivative(displacement);
  Oscillator result;
  result.acceleration = derivative(velocity);
  result.force = displacement;
  for (std::size_t n = 1; n <= 4; ++n) {
    result.force.harmonic[n - 1] = kMass * result.acceleration.c(n) + kViscosity * velocity.c(n) +
                                   kStiffness * displacement.c(n);
  }
  result.work = displacement.period() * kViscosity * std::pow(rms(velocity), 2);
  return result;
}

TEST(CycleEnergyTest, WorkOfAViscousDamper) {
  const Oscillator o = oscillator(17.3);
  EXPECT_NEAR(cycle_energy(o.force, o.acceleration).energy / o.work, 1.0, 1e-13);
}

TEST(CycleEnergyTest, ZeroOfTimeDoesNotMatter) {
  const Oscillator o = oscillator(17.3);
  const double moved = cycle_energy(shifted(o.force, 3.1), shifted(o.acceleration, 3.1)).energy;
  EXPECT_NEAR(moved / o.work, 1.0, 1e-12);
}

TEST(CycleEnergyTest, StandardErrorIsTheScatterOfNoisyCoefficients) {
  const Oscillator o = oscillator(17.3);
  const std::vector<double> force_std(4, 0.03);
  const std::vector<double> acceleration_std(4, 0.2);
  RandomStream random(4, 0);
  double square = 0.0;
  constexpr int kSamples = 4000;
  for (int k = 0; k < kSamples; ++k) {
    FourierSeries f = o.force;
    FourierSeries a = o.acceleration;
    for (std::size_t n = 0; n < 4; ++n) {
      f.harmonic[n] += 0.03 * std::complex<double>(random.normal(), random.normal());
      a.harmonic[n] += 0.2 * std::complex<double>(random.normal(), random.normal());
    }
    square += std::pow(cycle_energy(f, a).energy - o.work, 2) / kSamples;
  }
  // 4000 samples give the deviation to 1.1 %; 5 % is over four of that.
  EXPECT_NEAR(cycle_energy(o.force, o.acceleration, force_std, acceleration_std).std_error /
                  std::sqrt(square),
              1.0, 0.05);
}

TEST(CycleEnergyTest, SumOverSamplesIsExactForWholeCycles) {
  const Oscillator o = oscillator(16.0);
  const Axis axis = test::even_axis(1024.0, -0.3);  // 64 points per cycle
  FourierSeries offset = o.force;
  offset.mean = 7.0;
  const std::vector<double> f = values(offset, axis, 1024);
  const std::vector<double> a = values(o.acceleration, axis, 1024);
  const SampledEnergy sum = cycle_energy_from_samples(axis, f, a, offset, o.acceleration);
  EXPECT_EQ(sum.per_cycle.size(), 15U);  // the last would end with the last step
  // The elastic and inertial power, 100 times what is lost, cancels to rounding.
  EXPECT_NEAR(sum.energy / cycle_energy(o.force, o.acceleration).energy, 1.0, 1e-12);
  EXPECT_LT(sum.std_error / o.work, 1e-12);
}

TEST(CycleEnergyTest, OrderOfTheSumOverSamples) {
  // 41.3 points per cycle and then twice as many: the error falls by 2⁴ or more.
  const Oscillator o = oscillator(16.0);
  for (const VelocityFrom from : {VelocityFrom::kSeries, VelocityFrom::kSamples}) {
    double before = 0.0;
    for (const double rate : {16.0 * 41.3, 32.0 * 41.3}) {
      const Axis axis = test::even_axis(rate);
      const auto points = static_cast<std::size_t>(rate * 1.2);
      const std::vector<double> f = values(o.force, axis, points);
      const std::vector<double> a = values(o.acceleration, axis, points);
      const double error = std::abs(
          cycle_energy_from_samples(axis, f, a, o.force, o.acceleration, from).energy / o.work -
          1.0);
      EXPECT_LT(error, 2e-2);
      if (before > 1e-9) {
        EXPECT_LT(error, before / 8.0);
      }
      before = error;
    }
  }
}

TEST(CycleEnergyTest, CoefficientsAndSamplesAgreeWithinNoise) {
  const Oscillator o = oscillator(17.3);
  const Axis axis = test::even_axis(2048.0);
  int beyond = 0;
  constexpr int kRecords = 40;
  for (std::uint64_t k = 0; k < kRecords; ++k) {
    const Signals signals{test::sampled(o.force, axis, 4000, 0.2, 5, k),
                          test::sampled(o.acceleration, axis, 4000, 0.5, 6, k)};
    const FourierFit fit = fit_fourier(axis, test::spans(signals));
    ASSERT_TRUE(fit.summary.converged());
    const EnergyEstimate series =
        cycle_energy(fit.series[0], fit.series[1], fit.harmonic_std[0], fit.harmonic_std[1]);
    EXPECT_NEAR(series.energy, o.work, 4.5 * series.std_error);
    for (const VelocityFrom from : {VelocityFrom::kSeries, VelocityFrom::kSamples}) {
      const SampledEnergy sum = cycle_energy_from_samples(axis, signals[0], signals[1],
                                                          fit.series[0], fit.series[1], from);
      const double error = std::hypot(sum.std_error, series.std_error);
      beyond += std::abs(sum.energy - series.energy) > 3.0 * error ? 1 : 0;
    }
  }
  // 3 standard errors, and both come from the same noise: once in 300 at the most.
  EXPECT_LE(beyond, 1);
}

TEST(CycleEnergyTest, LinearDissipationOfTwoModes) {
  FourierSeries first = test::series_of(55.0, 3, 2e-4, 0.1, 0.3);
  FourierSeries second = test::series_of(55.0, 3, 1e-5, 0.8, 1.3);
  double expected = 0.0;
  for (std::size_t n = 1; n <= 3; ++n) {
    expected += static_cast<double>(n) * std::numbers::pi *
                (0.0028 * 350.0 * 350.0 * std::norm(first.c(n)) +
                 0.0018 * 1700.0 * 1700.0 * std::norm(second.c(n)));
  }
  const std::vector<FourierSeries> modal{first, second};
  const std::vector<double> loss{0.0028, 0.0018};
  const std::vector<double> omega{350.0, 1700.0};
  const EnergyEstimate estimate = linear_dissipation(modal, loss, omega);
  EXPECT_NEAR(estimate.energy / expected, 1.0, 1e-14);
  EXPECT_EQ(estimate.std_error, 0.0);
  // Relative errors of q double in |q|².
  const std::vector<std::vector<double>> errors{{2e-6, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  EXPECT_NEAR(linear_dissipation(modal, loss, omega, errors).std_error,
              0.02 * std::numbers::pi * 0.0028 * 350.0 * 350.0 * std::norm(first.c(1)),
              1e-12 * expected);
}

TEST(CycleEnergyTest, InputIsChecked) {
  const Oscillator o = oscillator(17.3);
  FourierSeries other = o.acceleration;
  other.omega *= 1.0 + 1e-9;
  EXPECT_THROW((void)cycle_energy(o.force, other), InputError);
  const std::vector<double> three(3, 0.1);
  EXPECT_THROW((void)cycle_energy(o.force, o.acceleration, three), InputError);
  const std::vector<FourierSeries> modal{o.force};
  const std::vector<double> one{1.0};
  const std::vector<double> negative{-1.0};
  EXPECT_THROW((void)linear_dissipation(modal, one, {}), InputError);
  EXPECT_THROW((void)linear_dissipation(modal, negative, one), InputError);
  const std::vector<double> few(20, 0.0);
  EXPECT_THROW(
      (void)cycle_energy_from_samples(test::even_axis(1000.0), few, few, o.force, o.acceleration),
      InputError);
}

}  // namespace
}  // namespace microslip::cycle_energy_test
