// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/methods/density_comparison.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"
#include "support/rigs.hpp"

namespace microslip::reduction_test {
namespace {

using testing::reference_rig;
using testing::Sampling;
using testing::SolvedRig;
using testing::unseen_rig;

const std::string kData = MICROSLIP_TEST_DATA;

// ---- Six noisy recordings of the reference rig by another program, with their truth. ----

struct TrueLevel {
  double frequency, amplitude, dissipation, input_energy, linear_dissipation;
};

// tests/data/reference_recordings/truth.csv.
constexpr TrueLevel kTruth[] = {{55.8, 3.6213461786651555e-06, 1.988355662871432e-08,
                                 2.1729204152379716e-07, 1.974045858917654e-07},
                                {55.7, 1.4541297759303655e-05, 1.2496322642822062e-06,
                                 4.413175303260139e-06, 3.1635311670027185e-06},
                                {55.6, 4.37926188521894e-05, 3.137441609609935e-05,
                                 5.9884987900297135e-05, 2.8510555762208565e-05},
                                {55.3, 0.0001033353494953558, 0.0003497508388724248,
                                 0.0005057660030750995, 0.00015601018699355496},
                                {55.0, 0.0001943251838876511, 0.0021571277238842915,
                                 0.0026981071588011154, 0.0005409248719936068},
                                {54.6, 0.00029671789813407704, 0.00804275036114863,
                                 0.009269974894001097, 0.001227091318907841}};

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

/// Standard deviation of W_ext by the noise of the samples alone: white, so that |c_1| has the
/// variance 2σ²/N, and W = (π/ω²)|F||A| sin of their phase.
double noise_of_energy(const ReducedLevel& level, std::size_t points) {
  constexpr double kForceNoise = 0.002;
  constexpr double kAccelerationNoise = 0.005;
  const double omega = 2.0 * std::numbers::pi * level.frequency;
  const double share = std::sqrt(2.0 / static_cast<double>(points));
  return std::numbers::pi / (omega * omega) * share *
         std::hypot(level.force_amplitude * kAccelerationNoise,
                    level.response_amplitude * kForceNoise);
}

TEST(Reduction, ReferenceRecordingsWithVibrometer) {
  const Reducer reducer(reference_rig());
  for (int i = 1; i <= 6; ++i) {
    SCOPED_TRACE(i);
    const Recording recording = testing::reference_recording(i);
    const ReducedLevel level = reducer.reduce(recording);
    const TrueLevel& truth = kTruth[i - 1];
    EXPECT_LE(relative(level.frequency, truth.frequency), 5e-5);
    EXPECT_EQ(level.reversals, 2U);
    EXPECT_LE(relative(level.linear_dissipation, truth.linear_dissipation), 2e-3);
    // The noise of the samples decides, at low levels above all.
    EXPECT_LE(std::abs(level.dissipation.value - truth.dissipation), 4.0 * level.dissipation.std);
    EXPECT_LE(std::abs(level.amplitude.value - truth.amplitude),
              std::max(4.0 * level.amplitude.std, 2e-4 * truth.amplitude));
    if (i >= 3) {
      EXPECT_LE(relative(level.amplitude.value, truth.amplitude), 1e-3);
      EXPECT_LE(relative(level.dissipation.value, truth.dissipation), 5e-3);
      test::record_deviation("amplitude", level.amplitude.value, truth.amplitude);
      test::record_deviation("dissipation", level.dissipation.value, truth.dissipation);
    }
    const double noise = noise_of_energy(level, recording.size());
    EXPECT_LE(level.input_energy.std, 1.5 * noise);
    EXPECT_GE(level.input_energy.std, noise / 1.5);
    test::record_largest("scatter over noise [1]", level.input_energy.std / noise);
    test::record_largest("noise over scatter [1]", noise / level.input_energy.std);
    test::record_largest("difference of both energies [standard errors]",
                         std::abs(level.input_energy.value - level.input_energy_by_sum->value) /
                             std::hypot(level.input_energy.std, level.input_energy_by_sum->std));
    EXPECT_LE(std::abs(level.input_energy.value - level.input_energy_by_sum->value),
              3.0 * std::hypot(level.input_energy.std, level.input_energy_by_sum->std));
  }
}

TEST(Reduction, ReferenceRecordingsWithoutVibrometer) {
  Rig rig = reference_rig();
  rig.vibrometer.reset();
  const Reducer reducer(rig);
  for (int i = 1; i <= 6; ++i) {
    SCOPED_TRACE(i);
    const ReducedLevel level = reducer.reduce(testing::reference_recording(i));
    EXPECT_LE(relative(level.amplitude.value, kTruth[i - 1].amplitude), 1e-3);
    if (i >= 3) test::record_deviation("amplitude", level.amplitude.value, kTruth[i - 1].amplitude);
  }
}

TEST(Reduction, ConvergedModesWithoutVibrometer) {
  // The recordings are those of a structure of 7 modes; the deflection of the real beam under the
  // moment of the joint is larger by the modes above, 0.8 % of A at the highest level.
  Rig rig = reference_rig();
  rig.vibrometer.reset();
  rig.test.reset();
  const Reducer reducer(rig);
  EXPECT_EQ(reducer.state().modes(), kBeamModes);
  for (int i = 3; i <= 6; ++i) {
    SCOPED_TRACE(i);
    const ReducedLevel level = reducer.reduce(testing::reference_recording(i));
    EXPECT_LE(relative(level.amplitude.value, kTruth[i - 1].amplitude), 1.2e-2);
    test::record_deviation("amplitude", level.amplitude.value, kTruth[i - 1].amplitude);
    EXPECT_LE(relative(level.dissipation.value, kTruth[i - 1].dissipation), 5e-3);
  }
}

TEST(Reduction, SecantStiffnessIsThatOfTheJoint) {
  const Reducer reducer(reference_rig());
  const Joint joint = testing::reference_joint();
  for (int i = 2; i <= 6; ++i) {
    SCOPED_TRACE(i);
    const ReducedLevel level = reducer.reduce(testing::reference_recording(i));
    const double expected = secant_stiffness(joint, kTruth[i - 1].amplitude);
    EXPECT_LE(std::abs(level.secant_stiffness->value - expected),
              3.0 * level.secant_stiffness->std);
    // 8e-4 at the highest level, where the mean tension, which no sensor sees, stiffens the beam.
    EXPECT_LE(relative(level.secant_stiffness->value, expected), 1e-3);
  }
}

TEST(Reduction, StickFrequencyGivesTheStiffness) {
  Rig rig = reference_rig();
  const Reducer by_stiffness(rig);
  // The frequency of the stuck beam contains the axial compliance in series with the joint:
  // [AR14 (13)], u = r w′(L) − k u c.
  const StickState& state = by_stiffness.state();
  const double k = state.stiffness;
  const double in_series = k / (1.0 + k * state.axial_compliance);
  rig.contact = {.rod_radius = 0.030,
                 .stick_frequency = natural_frequency(stick_state(rig, 60), k - in_series)};
  EXPECT_LE(relative(Reducer(rig).state().stiffness, k), 1e-4);
}

// ---- Sixty records of a rig that nothing was tuned to, in g and µm. ----

/// As a file in these units gives it.
Recording in_g_and_um(Recording recording) {
  for (Channel& channel : recording.channels) {
    const Unit unit = *find_unit(channel.dimension == kForce          ? "N"
                                 : channel.dimension == kAcceleration ? "g"
                                                                      : "um");
    channel.dimension.reset();
    for (double& value : channel.values) value /= unit.factor();
    recording.assume_unit(channel.name, unit);
  }
  return recording;
}

Levels reduced_levels(const Reducer& reducer, const SolvedRig& solved, std::uint64_t seed) {
  Levels levels;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const ReducedLevel level = reducer.reduce(in_g_and_um(solved.record(i, Sampling{}, seed)));
    EXPECT_EQ(level.reversals, 2U) << level.source;
    levels.amplitude.push_back(level.amplitude.value);
    levels.dissipation.push_back(level.dissipation.value);
    levels.amplitude_std.push_back(level.amplitude.std);
    levels.dissipation_std.push_back(level.dissipation.std);
    levels.secant_stiffness.push_back(level.secant_stiffness->value);
    levels.secant_stiffness_std.push_back(level.secant_stiffness->std);
  }
  return levels;
}

double density_error_of(const Rig& rig, std::uint64_t seed) {
  const SolvedRig solved(kData + "/unseen_rig.csv");
  const Levels levels = reduced_levels(Reducer(rig), solved, seed);
  return density_error(identify(levels, 9.0e4), testing::unseen_joint().density(), {0.1, 0.9});
}

TEST(Reduction, UnseenRigWithVibrometer) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const double error = density_error_of(unseen_rig(), seed);
    test::record_largest("density error [1]", error);
    EXPECT_LE(error, 0.04) << seed;
  }
}

TEST(Reduction, UnseenRigWithoutVibrometer) {
  Rig rig = unseen_rig();
  rig.vibrometer.reset();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const double error = density_error_of(rig, seed);
    test::record_largest("density error [1]", error);
    EXPECT_LE(error, 0.10) << seed;
  }
}

}  // namespace
}  // namespace microslip::reduction_test
