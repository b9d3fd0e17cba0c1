// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"
#include "microslip/workflow/predict/response_draws.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

namespace microslip::prediction_coverage_test {
namespace {

constexpr std::size_t kModes = 7;

/// The rig of seven modes with a joint, without the shortening of its beam, which hardly matters at
/// these levels and takes most of the time.
JointedStructure rig_with(const Joint& joint) {
  const JointedStructure rig = testing::friction_rig(kModes);
  StructuralJoint contact = rig.joints()[0];
  contact.joint = joint;
  contact.shortening.clear();
  return {rig.linear(),
          {std::move(contact)},
          {rig.excitations().begin(), rig.excitations().end()},
          rig.damping()};
}

/// What the maker of the model knows of its modes.
const StructureSpread kSpread{.frequency = std::vector<double>(kModes, 0.0005),
                              .loss_factor = std::vector<double>(kModes, 0.05)};

/// Levels of a joint, from 5 to 300 µm, D with 1 % of scatter.
Levels measured(const Joint& joint, std::uint64_t seed) {
  constexpr int kLevels = 40;
  constexpr double kLowest = 5e-6;
  constexpr double kHighest = 3e-4;
  RandomStream random(seed, 9);
  Levels levels;
  for (int i = 0; i < kLevels; ++i) {
    const double a = kLowest + (kHighest - kLowest) * i / (kLevels - 1);
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(joint, a) * (1.0 + 0.01 * random.normal()));
  }
  return levels;
}

struct Covered {
  std::size_t tests = 0;
  std::size_t frequency = 0;
  std::size_t amplitude = 0;
};

/// One virtual test: a structure that differs from its model as that says, levels of its joint, the
/// joint by these, draws, and the peak of the structure itself.
void add_test(const Joint& truth, double force, std::uint64_t seed, Covered& covered) {
  constexpr std::size_t kDraws = 300;
  const Identification found =
      identify(LevelEvidence(measured(truth, seed)), truth.stiffness(),
               {.bands = BandOptions{.samples = kDraws, .seed = seed, .progress = {}}});
  const auto samples = std::make_shared<const JointSamples>(joint_samples(found, {}));
  const JointedStructure model = rig_with(found.joint);
  const StructureDraws draws(
      model, kSpread,
      {{samples->size(), [samples](std::size_t i) { return DrawnJoint{samples->joint(i)}; }}},
      JointPairing::kIndependent, seed);
  constexpr double kTwoPi = 6.283185307179586;
  const ResponseRange range{{Quantity::kForceAmplitude, force}, kTwoPi * 53.0, kTwoPi * 57.5};
  const ResponsePoint point{"acc1"};
  const HarmonicBalance balance(model, point, {.harmonics = 3, .samples = 128, .accuracy = 0.0});
  const ResponseCurve curve =
      balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to);
  const PeakSpread predicted =
      response_spread(balance, curve, range, draws, {.count = kDraws, .seed = seed}).peaks.at(0);
  constexpr std::uint64_t kOtherSeed = 1'000'003;
  const StructureDraws world(rig_with(truth), kSpread, {}, JointPairing::kIndependent, kOtherSeed);
  const SteadyVibration peak =
      HarmonicBalance(world.draw(seed).structure, point, balance.options())
          .follow(range.kept, Quantity::kAngularFrequency, range.from, range.to)
          .peaks.at(0);
  ++covered.tests;
  const auto within = [](double value, double lower, double upper) {
    return value >= lower && value <= upper ? 1U : 0U;
  };
  covered.frequency +=
      within(peak.frequency(), predicted.frequency_lower, predicted.frequency_upper);
  covered.amplitude += within(peak.response, predicted.height_lower, predicted.height_upper);
}

double share(std::size_t count, const Covered& covered) {
  return static_cast<double>(count) / static_cast<double>(covered.tests);
}

/// Virtual tests of each joint; MICROSLIP_COVERAGE_TESTS sets it, and 25 make a study.
std::uint64_t tests_of_each() {
  const char* set = std::getenv("MICROSLIP_COVERAGE_TESTS");
  return set == nullptr ? 2 : std::strtoull(set, nullptr, 10);
}

/// Of n bands of 95 % that hold what they say so many hold the truth but once in a hundred and
/// fifty studies or less: 2.5 standard deviations below the mean.
std::size_t least_of(std::size_t n) {
  const auto count = static_cast<double>(n);
  return static_cast<std::size_t>(0.95 * count - 2.5 * std::sqrt(0.95 * 0.05 * count));
}

// Four joints, each at a force of its own. In a study of 100 the frequencies were covered 98 times
// and the amplitudes 96.
TEST(PredictionCoverage, OfPeaksIsWhatItSays) {
  MICROSLIP_OF_RELEASE_ALONE();
  Covered covered;
  const std::vector<std::pair<Joint, double>> cases{
      {testing::reference_joint(), 2.0},
      {testing::reference_joint(), 0.5},
      {Joint(1.7e5, SlipDensity({UniformPart{0.0, 40.0, 0.8}})), 1.0},
      {Joint(1.7e5, SlipDensity({PiecewiseLinearPart{{0, 10, 25, 45}, {0.004, 0.03, 0.01, 0.0}}})),
       1.5}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    for (std::uint64_t i = 0; i < tests_of_each(); ++i) {
      add_test(cases[c].first, cases[c].second, 1 + 100 * c + i, covered);
    }
  }
  test::record_smallest("frequency [1]", share(covered.frequency, covered));
  test::record_smallest("amplitude [1]", share(covered.amplitude, covered));
  EXPECT_GE(covered.frequency, least_of(covered.tests));
  EXPECT_GE(covered.amplitude, least_of(covered.tests));
}

}  // namespace
}  // namespace microslip::prediction_coverage_test
