// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/virtual_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace microslip::virtual_record_test {
namespace {

using testing::reference_joint;
using testing::reference_rig;

constexpr RigNoise kNoise{.force = 0.002, .acceleration = 0.005, .vibrometer = 2e-8};

Rig noisy_rig() {
  Rig rig = reference_rig();
  rig.test->frequency_resolution = 0.1;
  rig.noise = kNoise;
  return rig;
}

Rig quiet_rig() {
  Rig rig = noisy_rig();
  rig.noise.reset();
  return rig;
}

const VirtualMeasurement& reference_test() {
  static const VirtualMeasurement kTest = measure_virtually(noisy_rig(), reference_joint());
  return kTest;
}

Recording record_of(const Rig& rig, std::size_t level, std::uint64_t seed = 1) {
  Recording recording =
      virtual_record(rig, stick_state(rig), reference_test().levels[level].controlled, seed, level);
  recording.source = "level " + std::to_string(level + 1);
  return recording;
}

std::vector<double> noise_of(const std::string& channel, std::size_t level, std::uint64_t seed) {
  const Recording noisy = record_of(noisy_rig(), level, seed);
  const Recording quiet = record_of(quiet_rig(), level, seed);
  std::vector<double> noise = noisy.channel(channel).values;
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= quiet.channel(channel).values[i];
  return noise;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());
}

TEST(VirtualRecord, HasTheChannelsAndTheSamplingOfTheRig) {
  const Recording recording = record_of(noisy_rig(), 3);
  EXPECT_NO_THROW(check_recording(recording));
  std::vector<std::string> names;
  for (const Channel& channel : recording.channels) names.push_back(channel.name);
  EXPECT_EQ(names, (std::vector<std::string>{"force", "acc1", "acc2", "acc3", "ldv"}));
  EXPECT_EQ(recording.size(), 8192U);
  EXPECT_EQ(recording.sampling_rate(), 8192.0);
}

// Without noise the Fourier series of the samples is that of the vibration, but for the phase at
// which the record begins; in rounding of 8192 samples.
TEST(VirtualRecord, HoldsTheHarmonicsOfTheVibration) {
  const VirtualLevel& level = reference_test().levels[60];
  const Recording recording = record_of(quiet_rig(), 60);
  const std::vector<std::span<const double>> signals{recording.channel("force").values,
                                                     recording.channel("acc1").values,
                                                     recording.channel("ldv").values};
  const FourierFit fit =
      fit_fourier(recording.axis, signals, {.frequency_guess = level.frequency, .trend_degree = 0});
  EXPECT_NEAR(fit.frequency(), level.frequency, 1e-9 * level.frequency);
  const SteadyVibration& truth = level.controlled.vibration;
  EXPECT_NEAR(std::abs(fit.series[0].c(1)), truth.force_amplitude, 1e-9 * truth.force_amplitude);
  EXPECT_NEAR(std::abs(fit.series[1].c(1)), level.response, 1e-9 * level.response);
  const JointCycle& cycle = truth.joints[0];
  EXPECT_NEAR(fit.series[2].mean, cycle.displacement[0].real(), 1e-9 * cycle.amplitude);
  const double turn = std::arg(fit.series[0].c(1));
  for (std::size_t n = 1; n <= 10; ++n) {
    const auto back = std::polar(1.0, -static_cast<double>(n) * turn);
    EXPECT_LT(std::abs(fit.series[0].c(n) * back - level.controlled.force[n]),
              1e-9 * truth.force_amplitude);
    EXPECT_LT(std::abs(fit.series[2].c(n) * back - cycle.displacement[n]), 1e-9 * cycle.amplitude);
  }
}

// Bounds are four standard errors of N = 8192 independent samples.
TEST(VirtualRecord, HasNoiseAsStated) {
  const double error = 1.0 / std::sqrt(8192.0);
  const std::map<std::string, double> stated{{"force", kNoise.force},
                                             {"acc1", kNoise.acceleration},
                                             {"acc2", kNoise.acceleration},
                                             {"acc3", kNoise.acceleration},
                                             {"ldv", kNoise.vibrometer}};
  std::vector<std::vector<double>> all;
  for (const auto& [channel, std] : stated) {
    std::vector<double> noise = noise_of(channel, 10, 1);
    for (double& value : noise) value /= std;
    const std::vector<double> one(noise.size(), 1.0);
    EXPECT_NEAR(product(noise, one), 0.0, 4.0 * error) << channel;
    EXPECT_NEAR(product(noise, noise), 1.0, 4.0 * std::sqrt(2.0) * error) << channel;
    std::vector<double> later = noise;
    std::ranges::rotate(later, later.begin() + 1);
    EXPECT_NEAR(product(noise, later), 0.0, 4.0 * error) << channel;
    for (const auto& other : all) EXPECT_NEAR(product(noise, other), 0.0, 4.0 * error) << channel;
    all.push_back(std::move(noise));
  }
  std::vector<double> other_level = noise_of("force", 11, 1);
  for (double& value : other_level) value /= kNoise.force;
  for (const auto& noise : all) EXPECT_NEAR(product(noise, other_level), 0.0, 4.0 * error);
}

TEST(VirtualRecord, IsThatOfItsSeed) {
  const std::vector<Channel> channels = record_of(noisy_rig(), 5).channels;
  EXPECT_EQ(channels, record_of(noisy_rig(), 5).channels);
  EXPECT_NE(channels, record_of(noisy_rig(), 5, 2).channels);
  // The phase too: no two records begin alike.
  EXPECT_NE(record_of(quiet_rig(), 5).channels, record_of(quiet_rig(), 5, 2).channels);
  // A channel more or less leaves the others as they are.
  Rig fewer = noisy_rig();
  fewer.vibrometer.reset();
  const Recording without = record_of(fewer, 5);
  ASSERT_EQ(without.channels.size(), 4U);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(without.channels[c], channels[c]);
  }
}

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

void expect_reduced(const Rig& rig, const ReductionOptions& options, double amplitude_tolerance,
                    double dissipation_tolerance) {
  const Reducer reducer(rig, options);
  for (std::size_t i = 0; i < reference_test().levels.size(); i += 8) {
    const ReducedLevel level = reducer.reduce(record_of(rig, i));
    const JointCycle& truth = reference_test().levels[i].controlled.vibration.joints[0];
    EXPECT_LT(relative(level.amplitude.value, truth.amplitude), amplitude_tolerance) << i + 1;
    EXPECT_LT(relative(level.dissipation.value, truth.dissipation), dissipation_tolerance) << i + 1;
  }
}

// Ten harmonics of the record, as the fit has them, and a modal model that is that of the test:
// what is left is the shortening, whose mean tension no sensor sees, 0.05 % of the energy.
TEST(VirtualRecord, ReducesToItsTruthWithoutNoise) { expect_reduced(quiet_rig(), {}, 1e-6, 5e-4); }

// The axial motion of the beam and r w′(L), found from the accelerometers, make u again.
TEST(VirtualRecord, ReducesFromTheAxialMotion) {
  Rig rig = quiet_rig();
  rig.vibrometer->measures = RigVibrometer::Measures::kAxial;
  const Recording axial = record_of(rig, 60);
  // The rotation makes most of u: the axial motion is another signal.
  EXPECT_NE(axial.channel("ldv").values, record_of(quiet_rig(), 60).channel("ldv").values);
  expect_reduced(rig, {}, 1e-3, 5e-4);
}

// From the kinematics alone.
TEST(VirtualRecord, ReducesWithoutVibrometer) {
  Rig rig = quiet_rig();
  rig.vibrometer.reset();
  expect_reduced(rig, {}, 1e-3, 5e-4);
}

// The noise of the published experiment's sensors: D stands out of it where it is known to 0.1 %;
// five standard deviations, of 90 levels, elsewhere.
TEST(VirtualRecord, ReducesToItsTruthWithNoise) {
  const Rig rig = noisy_rig();
  const Reducer reducer(rig);
  std::size_t certain = 0;
  for (std::size_t i = 0; i < 90; ++i) {
    const ReducedLevel level = reducer.reduce(record_of(rig, i));
    const JointCycle& truth = reference_test().levels[i].controlled.vibration.joints[0];
    EXPECT_NEAR(level.amplitude.value, truth.amplitude,
                1e-3 * truth.amplitude + 5.0 * level.amplitude.std)
        << i + 1;
    EXPECT_NEAR(level.dissipation.value, truth.dissipation,
                1e-3 * truth.dissipation + 5.0 * level.dissipation.std)
        << i + 1;
    EXPECT_LT(level.force_distortion, 0.01) << i + 1;
    if (level.dissipation.std > 1e-3 * truth.dissipation) continue;
    ++certain;
    EXPECT_LT(relative(level.amplitude.value, truth.amplitude), 1e-3) << i + 1;
    EXPECT_LT(relative(level.dissipation.value, truth.dissipation), 5e-3) << i + 1;
  }
  EXPECT_GT(certain, 45U);
}

// 2(l − 1) and 2(l − 1) + 1: no two records of a test draw the same noise.
TEST(VirtualRecord, NumbersTheRecordsOfATest) {
  VirtualLevel level;
  level.number = 1;
  EXPECT_EQ(record_number(level), 0U);
  EXPECT_EQ(record_number(level, true), 1U);
  level.number = 90;
  EXPECT_EQ(record_number(level), 178U);
  EXPECT_EQ(record_number(level, true), 179U);
}

TEST(VirtualRecord, RefusesTooManySamples) {
  Rig rig = noisy_rig();
  const StickState state = stick_state(rig);
  rig.test->duration = 1e6;
  EXPECT_THROW((void)virtual_record(rig, state, reference_test().levels[0].controlled, 1, 0),
               InputError);
}

TEST(VirtualRecord, NeedsATest) {
  Rig rig = noisy_rig();
  const StickState state = stick_state(rig);
  rig.test.reset();
  EXPECT_THROW((void)virtual_record(rig, state, reference_test().levels[0].controlled, 1, 0),
               InputError);
}

}  // namespace
}  // namespace microslip::virtual_record_test
