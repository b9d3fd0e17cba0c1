// SPDX-License-Identifier: MIT
#include "microslip/observe/record_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"
#include "support/force_records.hpp"

namespace microslip::record_cycles_test {
namespace {

using testing::forces_on;
using testing::simulated_record;

constexpr double kNone = 0.0;
const testing::RecordNoise kExact{kNone, kNone, kNone};

/// A path from turn to turn by half cosines, of so many samples each.
std::vector<double> path_through(const std::vector<double>& turns, std::size_t samples) {
  std::vector<double> path;
  for (std::size_t k = 1; k < turns.size(); ++k) {
    for (std::size_t i = 0; i < samples; ++i) {
      const double phase = std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
      path.push_back(turns[k] + (turns[k - 1] - turns[k]) * (0.5 + 0.5 * std::cos(phase)));
    }
  }
  path.push_back(turns.back());
  return path;
}

RecordCycles cycles_of(const ForceRecord& record) {
  return record_cycles(RecordEvidence(record, PathStart::kVirgin));
}

RecordCycles exact_cycles(const Joint& joint, const std::vector<double>& path) {
  return cycles_of(simulated_record(joint, path, 1, kExact));
}

void expect_levels_of(const Joint& joint, const RecordCycle& cycle, double relative) {
  const double a = cycle.amplitude;
  EXPECT_NEAR(cycle.dissipation / dissipation(joint, a), 1.0, relative) << a;
  EXPECT_NEAR(cycle.secant_stiffness / secant_stiffness(joint, a), 1.0, relative) << a;
}

// Chords of 800 samples per cycle cut 2(π/800)² or so off a loop.
TEST(RecordCycles, AreLevelsOfTheJoint) {
  const Joint joint = testing::reference_joint();
  const RecordCycles found = exact_cycles(
      joint, path_through({0, 1e-4, -1e-4, 1e-4, -1e-4, 2e-4, -2e-4, 2e-4, -2e-4}, 400));
  ASSERT_EQ(found.cycles.size(), 2U);
  EXPECT_NEAR(found.cycles[0].amplitude, 1e-4, 1e-12);
  EXPECT_NEAR(found.cycles[1].amplitude, 2e-4, 1e-12);
  for (const RecordCycle& cycle : found.cycles) {
    expect_levels_of(joint, cycle, 5e-5);
    EXPECT_TRUE(cycle.flags.empty());
    EXPECT_EQ(cycle.inner, 0U);
  }
}

// k_eq is that of a sine whatever the waveform: here triangles and a path with flat tops.
TEST(RecordCycles, DoNotDependOnTheWaveform) {
  const Joint joint = testing::power_law();
  const std::vector<double> sine = path_through({0, 1.5e-4, -1.5e-4, 1.5e-4, -1.5e-4}, 500);
  for (const double power : {1.0, 0.4}) {
    std::vector<double> path = sine;
    for (double& u : path) {
      const double x = std::asin(std::clamp(u / 1.5e-4, -1.0, 1.0)) / (0.5 * std::numbers::pi);
      u = 1.5e-4 * std::copysign(std::pow(std::abs(x), power), x);
    }
    const RecordCycles found = exact_cycles(joint, path);
    ASSERT_EQ(found.cycles.size(), 1U);
    expect_levels_of(joint, found.cycles[0], 2e-3);
  }
}

// Two inner cycles are levels of their own, and the outer one is one without them.
TEST(RecordCycles, TakeInnerCyclesOut) {
  const Joint joint = testing::reference_joint();
  const std::vector<double> turns{0, 3e-4, -3e-4, 1e-4, -0.5e-4, 2e-4, 1.2e-4, 3e-4, -3e-4};
  const RecordCycles found = exact_cycles(joint, path_through(turns, 400));
  ASSERT_EQ(found.cycles.size(), 3U);
  EXPECT_EQ(found.cycles[0].inner, 2U);
  EXPECT_NEAR(found.cycles[0].amplitude, 3e-4, 1e-12);
  EXPECT_NEAR(found.cycles[1].amplitude, 0.75e-4, 1e-12);
  EXPECT_NEAR(found.cycles[2].amplitude, 0.4e-4, 1e-12);
  EXPECT_NEAR(found.cycles[2].mean_displacement, 1.6e-4, 1e-12);
  for (const RecordCycle& cycle : found.cycles) expect_levels_of(joint, cycle, 2e-4);
}

// In a decay no cycle comes back to where it began: the gap is closed.
TEST(RecordCycles, CloseThoseOfADecay) {
  const Joint joint = testing::reference_joint();
  std::vector<double> turns{0.0};
  for (int k = 0; k < 20; ++k) turns.push_back((k % 2 == 0 ? 3e-4 : -3e-4) * std::pow(0.985, k));
  const RecordCycles found = exact_cycles(joint, path_through(turns, 300));
  ASSERT_GE(found.cycles.size(), 8U);
  for (const RecordCycle& cycle : found.cycles) {
    expect_levels_of(joint, cycle, 1e-3);
    EXPECT_TRUE(cycle.flags.empty());
  }
}

// Where the amplitude grows by a third no slider of the largest slip displacement had slipped
// before.
TEST(RecordCycles, AreNotWhatDoesNotClose) {
  const Joint joint = testing::uniform_to_range_end();
  const RecordCycles found =
      exact_cycles(joint, path_through({0, 1e-4, -1.4e-4, 1.9e-4, -2.5e-4, 3e-4}, 300));
  EXPECT_EQ(found.cycles.size(), 0U);
}

TEST(RecordCycles, TakeOneLoopFromTipToTip) {
  const Joint joint = testing::reference_joint();
  std::vector<double> path = path_through({0, 2e-4, -2e-4, 2e-4}, 400);
  ForceRecord record = simulated_record(joint, path, 1, kExact);
  record.displacement.erase(record.displacement.begin(), record.displacement.begin() + 400);
  record.force.erase(record.force.begin(), record.force.begin() + 400);
  const RecordCycles found = cycles_of(record);
  ASSERT_EQ(found.cycles.size(), 1U);
  expect_levels_of(joint, found.cycles[0], 1e-4);
  EXPECT_TRUE(found.cycles[0].has_flag(kOneLoop));
}

/// Standardised errors of the levels of random records.
struct Errors {
  std::vector<double> dissipation;
  std::vector<double> secant;
};

Errors errors_of(const Joint& joint, const RecordCycles& found) {
  Errors errors;
  for (const RecordCycle& cycle : found.cycles) {
    const double a = cycle.amplitude;
    errors.dissipation.push_back((cycle.dissipation - dissipation(joint, a)) /
                                 cycle.dissipation_std);
    errors.secant.push_back((cycle.secant_stiffness - secant_stiffness(joint, a)) /
                            cycle.secant_stiffness_std);
  }
  return errors;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// 30 cycles of each of five amplitudes: the deviations are those that the errors have. A tenth of a
// hundred errors' rms is 7 %.
TEST(RecordCycles, KnowTheirNoise) {
  const Joint joint = testing::reference_joint();
  std::vector<double> turns{0.0};
  for (const double a : {0.4e-4, 1e-4, 1.6e-4, 2.2e-4, 2.8e-4}) {
    for (int k = 0; k < 60; ++k) turns.push_back(k % 2 == 0 ? a : -a);
  }
  const ForceRecord record = simulated_record(joint, path_through(turns, 100), 7);
  const RecordCycles found = cycles_of(record);
  EXPECT_NEAR(static_cast<double>(found.cycles.size()), 145.0, 3.0);
  const Errors errors = errors_of(joint, found);
  EXPECT_NEAR(rms(errors.dissipation), 1.0, 0.2);
  EXPECT_NEAR(rms(errors.secant), 1.0, 0.2);
}

// Cycles of one amplitude have one deviation of k_eq, wherever their last vertex lies beside the
// turn: ∂S/∂x, S = √(1 − x²), has no end there. By single samples the deviations differ by a few
// per cent.
TEST(RecordCycles, HaveLikeDeviationsWhereTheyAreAlike) {
  std::vector<double> turns{0.0};
  for (int k = 0; k < 120; ++k) turns.push_back(k % 2 == 0 ? 1e-4 : -1e-4);
  const RecordCycles found =
      cycles_of(simulated_record(testing::reference_joint(), path_through(turns, 100), 7));
  ASSERT_GT(found.cycles.size(), 40U);
  std::vector<double> deviations;
  for (const RecordCycle& cycle : found.cycles) deviations.push_back(cycle.secant_stiffness_std);
  const auto [low, high] = std::ranges::minmax(deviations);
  EXPECT_LT(high, 1.5 * low);
}

/// A cycle of each amplitude, measured many times.
struct Repeated {
  std::vector<double> dissipation, dissipation_std, secant, secant_std, amplitude, amplitude_std;
};

std::vector<Repeated> repeated_cycles(const Joint& joint, std::size_t samples,
                                      const testing::RecordNoise& noise) {
  constexpr std::uint64_t kRecords = 200;
  constexpr std::size_t kCycles = 4;
  const std::vector<double> amplitudes{0.4e-4, 1e-4, 1.6e-4, 2.2e-4, 2.8e-4};
  std::vector<double> turns{0.0};
  for (const double a : amplitudes) {
    for (std::size_t k = 0; k < 2 * kCycles; ++k) turns.push_back(k % 2 == 0 ? a : -a);
  }
  const std::vector<double> path = path_through(turns, samples);
  std::vector<Repeated> repeated(amplitudes.size());
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {
    const RecordCycles found = cycles_of(simulated_record(joint, path, seed, noise));
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      const auto first = std::ranges::find_if(found.cycles, [&](const RecordCycle& cycle) {
        return std::abs(cycle.amplitude / amplitudes[i] - 1.0) < 0.1;
      });
      if (first == found.cycles.end()) continue;
      repeated[i].dissipation.push_back(first->dissipation);
      repeated[i].dissipation_std.push_back(first->dissipation_std);
      repeated[i].secant.push_back(first->secant_stiffness);
      repeated[i].secant_std.push_back(first->secant_stiffness_std);
      repeated[i].amplitude.push_back(first->amplitude);
      repeated[i].amplitude_std.push_back(first->amplitude_std);
    }
  }
  return repeated;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Standard deviation of the values over the mean of those stated.
double pull(const std::vector<double>& values, const std::vector<double>& stated) {
  double squares = 0.0;
  for (const double value : values) squares += std::pow(value - mean(values), 2);
  return std::sqrt(squares / static_cast<double>(values.size() - 1)) / mean(stated);
}

void expect_stated_scatter(const Joint& joint, std::size_t samples,
                           const testing::RecordNoise& noise) {
  for (const Repeated& cycle : repeated_cycles(joint, samples, noise)) {
    ASSERT_GE(cycle.secant.size(), 150U);
    EXPECT_GT(pull(cycle.secant, cycle.secant_std), 0.8);
    EXPECT_LT(pull(cycle.secant, cycle.secant_std), 1.3);
    EXPECT_GT(pull(cycle.dissipation, cycle.dissipation_std), 0.75);
    EXPECT_LT(pull(cycle.dissipation, cycle.dissipation_std), 1.3);
    if (noise.displacement == 0.0) continue;
    EXPECT_GT(pull(cycle.amplitude, cycle.amplitude_std), 0.7);
    EXPECT_LT(pull(cycle.amplitude, cycle.amplitude_std), 1.3);
  }
}

// Of 200 records a standard deviation is known to 5 %; the rest is for the flat spectrum assumed of
// the noise, and for the approximation of the filter of the path. Noise of the force alone, of the
// path alone, of both beside an offset; a joint that slips in part, and one all of which slips at
// the least amplitude, whose k_eq is a twentieth of the stiffness that an error of u acts by behind
// a turn. Of a path as noisy as that no force is straight in u in between: few samples cut loops
// short, which is a bias and no scatter.
TEST(RecordCycles, ScatterAsTheySay) {
  MICROSLIP_OF_RELEASE_ALONE();
  const Joint all_slips = testing::joint_of({UniformPart{0, 8, 1}});
  const testing::RecordNoise of_force{kNone, 4e-3, kNone};
  const testing::RecordNoise of_path{1e-3, kNone, kNone};
  const testing::RecordNoise of_both{1e-3, 4e-3, 0.02};
  expect_stated_scatter(testing::reference_joint(), 100, of_force);
  expect_stated_scatter(all_slips, 100, of_both);
  if (!test::in_studies()) return;
  expect_stated_scatter(testing::reference_joint(), 100, of_path);
  expect_stated_scatter(testing::reference_joint(), 100, of_both);
  expect_stated_scatter(all_slips, 100, of_force);
  expect_stated_scatter(all_slips, 100, of_path);
  expect_stated_scatter(all_slips, 40, of_both);
  expect_stated_scatter(all_slips, 400, of_both);
}

TEST(RecordCycles, OfRandomPathsAreLevelsOfTheJoint) {
  const Joint joint = testing::reference_joint();
  for (std::uint64_t seed = 1; seed <= test::draws_of(4, 2); ++seed) {
    const std::vector<double> path = testing::random_motion(16000, 3e-4, seed, 4);
    const RecordCycles found = cycles_of(simulated_record(joint, path, seed));
    EXPECT_GE(found.cycles.size(), 20U);
    const Errors errors = errors_of(joint, found);
    EXPECT_NEAR(rms(errors.dissipation), 1.0, 0.4) << seed;
    EXPECT_NEAR(rms(errors.secant), 1.0, 0.4) << seed;
  }
}

// Records of another program, virgin at the start, of a joint whose D and k_eq are in closed form.
TEST(RecordCycles, OfIndependentRecordsAreLevelsOfTheirJoint) {
  const Joint joint = testing::record_joint();
  for (const auto& [name, count] : std::vector<std::pair<std::string, std::size_t>>{
           {"sines", 16}, {"random", 30}, {"earthquake", 60}}) {
    const RecordCycles found = cycles_of(testing::reference_record(name));
    EXPECT_GE(found.cycles.size(), count) << name;
    const Errors errors = errors_of(joint, found);
    EXPECT_NEAR(rms(errors.dissipation), 1.0, 0.35) << name;
    EXPECT_NEAR(rms(errors.secant), 1.0, 0.35) << name;
  }
}

TEST(RecordCycles, AreLevelsOfSeveralRecords) {
  const Joint joint = testing::reference_joint();
  const ForceRecord exact =
      simulated_record(joint, path_through({0, 1e-4, -1e-4, 1e-4, -1e-4}, 100), 1, kExact);
  const ForceRecord noisy =
      simulated_record(joint, path_through({0, 2e-4, -2e-4, 2e-4, -2e-4}, 100), 1);
  const std::vector<RecordCycles> both{cycles_of(exact), cycles_of(noisy)};
  EXPECT_TRUE(levels_of_cycles(both).dissipation_std.empty());
  const std::vector<RecordCycles> one{cycles_of(noisy)};
  const Levels levels = levels_of_cycles(one);
  EXPECT_EQ(levels.dissipation_std.size(), levels.size());
  EXPECT_EQ(levels.amplitude_std.size(), levels.size());
  check_levels(levels);
}

TEST(RecordCycles, FlagWhatMoves) {
  const Joint joint = testing::reference_joint();
  std::vector<double> turns{0.0};
  for (int k = 0; k < 12; ++k) turns.push_back((k % 2 == 0 ? 2e-4 : -2e-4) + 1.2e-5 * k);
  const RecordCycles moving = exact_cycles(joint, path_through(turns, 100));
  ASSERT_GE(moving.cycles.size(), 4U);
  // Each of them is biased, the first as well.
  for (const RecordCycle& cycle : moving.cycles) EXPECT_TRUE(cycle.has_flag(kMeanMoves));

  ForceRecord drifting = simulated_record(
      joint, path_through({0, 2e-4, -2e-4, 2e-4, -2e-4, 2e-4, -2e-4}, 100), 1, kExact);
  for (std::size_t i = 0; i < drifting.size(); ++i)
    drifting.force[i] += 0.01 * static_cast<double>(i);
  const RecordCycles open = cycles_of(drifting);
  ASSERT_EQ(open.cycles.size(), 2U);
  for (const RecordCycle& cycle : open.cycles) {
    EXPECT_TRUE(cycle.has_flag(kNotClosed));
    EXPECT_NEAR(cycle.gap, 2.0, 0.05);
  }
}

// A cycle of x = u + δt/T that goes up to its turn ends where u is δ short of it: D misses Fδ, much
// of a slim loop though δ is 1 % of the amplitude. All cycles are biased; without the drift none
// is flagged.
TEST(RecordCycles, FlagADriftOfTheSensorThatChangesTheLoss) {
  const Joint joint = testing::reference_joint();
  constexpr double kAmplitude = 1e-4;
  constexpr double kDrift = 1e-6;  // m per cycle
  std::vector<double> turns{0.0};
  for (int k = 0; k < 40; ++k) turns.push_back(k % 2 == 0 ? kAmplitude : -kAmplitude);
  const std::vector<double> path = path_through(turns, 200);
  for (const testing::RecordNoise& noise : {kExact, testing::RecordNoise{2e-4, 1e-4, kNone}}) {
    ForceRecord record = simulated_record(joint, path, 1, noise);
    for (const RecordCycle& cycle : cycles_of(record).cycles) {
      EXPECT_FALSE(cycle.has_flag(kMeanMoves)) << cycle.first;
    }
    for (std::size_t i = 0; i < record.size(); ++i) {
      record.displacement[i] += kDrift * static_cast<double>(i) / 400.0;
    }
    const RecordCycles drifting = cycles_of(record);
    ASSERT_GE(drifting.cycles.size(), 17U);
    const double turn_force = secant_stiffness(joint, kAmplitude) * kAmplitude;
    const double missing = turn_force * kDrift;
    EXPECT_GT(missing, 0.02 * dissipation(joint, kAmplitude));
    for (const RecordCycle& cycle : drifting.cycles) {
      EXPECT_TRUE(cycle.has_flag(kMeanMoves)) << cycle.first;
      EXPECT_NEAR(dissipation(joint, kAmplitude) - cycle.dissipation, missing, 0.25 * missing);
    }
  }
}

TEST(RecordCycles, LeaveOutWhatIsInTheNoise) {
  const Joint joint = testing::reference_joint();
  std::vector<double> turns{0.0};
  for (const double a : {2e-6, 2e-4}) {
    for (int k = 0; k < 20; ++k) turns.push_back(k % 2 == 0 ? a : -a);
  }
  const RecordCycles found =
      cycles_of(simulated_record(joint, path_through(turns, 100), 3, {.displacement = 1e-4}));
  EXPECT_EQ(found.cycles.size(), 9U);
  EXPECT_GE(found.unresolved, 8U);
  EXPECT_NEAR(found.smallest, 2e-6, 1e-7);
}

TEST(RecordCycles, SayHowFewSamplesTheyHave) {
  const Joint joint = testing::reference_joint();
  const std::vector<double> turns{0, 2e-4, -2e-4, 2e-4, -2e-4, 2e-4};
  EXPECT_TRUE(exact_cycles(joint, path_through(turns, 10)).cycles.front().has_flag(kFewSamples));
  EXPECT_GE(exact_cycles(joint, path_through(turns, 5)).coarse, 1U);
}

}  // namespace
}  // namespace microslip::record_cycles_test
