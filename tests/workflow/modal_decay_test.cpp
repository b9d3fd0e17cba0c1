// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/modal_decay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/jointed_records.hpp"
#include "support/messages.hpp"

namespace microslip::modal_decay_test {
namespace {

const std::string kModel = MICROSLIP_TEST_DATA "/two_joints/model.toml";
const std::vector<std::string> kPoints{"drive", "p4"};

/// That model with joints that slip.
const JointedStructure& structure() {
  static const JointedStructure kStructure = [] {
    const ModelFile model = read_model(kModel, JointsToFind::kAllowed);
    std::vector<StructuralJoint> joints(model.structure.joints().begin(),
                                        model.structure.joints().end());
    joints[0].joint =
        Joint(joints[0].joint.stiffness(), SlipDensity({FourParameterPart{300.0, 9e5, -0.5, 0.4}}));
    joints[1].joint = testing::humped_joint(joints[1].joint.stiffness(), 60.0, 0.002);
    return JointedStructure(model.structure.linear(), joints, {{.point = "drive"}},
                            DampingLaw::kHysteretic);
  }();
  return kStructure;
}

/// The nonlinear mode at a response.
SteadyVibration mode_at(std::size_t mode, double response) {
  const HarmonicBalance balance(structure(), {"drive"},
                                {.harmonics = 5, .forcing = Forcing::kModal});
  const VibrationResult result =
      balance.solve(kPhaseResonance, {Quantity::kResponse, response}, mode);
  EXPECT_TRUE(result.summary.converged()) << result.summary.full();
  return result.vibration;
}

/// Where the displacement is largest, so that joints that come there from rest are on the loop.
void add_start(const SteadyVibration& vibration, InitialState& start) {
  start.displacement.resize(vibration.modal.size());
  start.velocity.resize(vibration.modal.size());
  for (std::size_t i = 0; i < vibration.modal.size(); ++i) {
    for (std::size_t n = 1; n < vibration.modal[i].size(); ++n) {
      const std::complex<double> q =
          vibration.modal[i][n] * std::polar(1.0, static_cast<double>(n) * vibration.phase_lag);
      start.displacement[i] += q.real();
      start.velocity[i] -= static_cast<double>(n) * vibration.angular_frequency * q.imag();
    }
  }
}

/// The free decay from there as accelerometers at points see it, with noise of 1 mm/s².
std::string decay_of(const InitialState& start, double seconds) {
  constexpr double kStep = 1.0 / 4096.0;
  constexpr std::size_t kEvery = 4;
  LoadHistory loads;
  for (double t = 0.0; t < seconds; t += kStep) loads.time.push_back(t);
  const MarchResult found =
      march(structure(), loads,
            {.every = kEvery, .points = kPoints, .start = start, .estimate_error = false});
  EXPECT_TRUE(found.summary.converged()) << found.summary.full();
  RandomStream random(1, 5);
  Recording recording{.source = "decay", .axis = {}, .channels = {}, .attributes = {}};
  recording.axis.step = kStep * static_cast<double>(kEvery);
  for (const PointMotion& point : found.points) {
    Channel& channel = recording.channels.emplace_back();
    channel.name = "a_" + point.point;
    channel.dimension = kAcceleration;
    for (const double a : point.acceleration) channel.values.push_back(a + 1e-3 * random.normal());
  }
  // The last row is that of the last time, whatever the distance.
  for (Channel& channel : recording.channels) channel.values.pop_back();
  return format_recording_csv(recording);
}

std::vector<std::string> sensors_at(const std::vector<std::string>& points) {
  std::vector<std::string> sensors;
  for (const std::string& point : points) sensors.push_back("a_" + point + "=" + point);
  return sensors;
}

/// Largest relative differences from the nonlinear mode, of levels with and without a flag.
struct Errors {
  double frequency = 0.0;
  double damping = 0.0;
  double flagged_damping = 0.0;
  std::size_t levels = 0;
  std::size_t flagged = 0;
};

Errors errors_of(const ModalDecay& found) {
  Errors errors;
  for (std::size_t i = 0; i < found.levels.amplitude.size(); ++i) {
    const SteadyVibration truth = mode_at(found.mode - 1, found.levels.amplitude[i]);
    const double damping = std::abs(found.levels.damping_ratio[i] / truth.damping_ratio() - 1.0);
    if (found.levels.flags[i].find("modes_modulate") != std::string::npos) {
      errors.flagged_damping = std::max(errors.flagged_damping, damping);
      ++errors.flagged;
      continue;
    }
    errors.frequency =
        std::max(errors.frequency, std::abs(found.levels.frequency[i] / truth.frequency() - 1.0));
    errors.damping = std::max(errors.damping, damping);
    ++errors.levels;
  }
  return errors;
}

// One mode alone goes along the nonlinear mode, which another method finds: the harmonic balance
// with modal forcing. A window takes the mean over a fall of the amplitude by a third or more, and
// two sensors see a shape that slip changes: 1.5 % of ζ, as with one joint and one sensor.
TEST(ModalDecay, OfOneModeIsItsBackbone) {
  const test::TemporaryFolder folder;
  for (const std::size_t mode : {0U, 1U, 2U}) {
    SCOPED_TRACE("mode " + std::to_string(mode + 1));
    InitialState start;
    add_start(mode_at(mode, mode == 0 ? 6e-5 : 3e-5), start);
    test::put(folder.file("decay.csv"), decay_of(start, mode == 0 ? 4.0 : 2.0));
    const ReducedModalDecay reduced = reduce_modal_decay({.recording = folder.file("decay.csv"),
                                                          .model = kModel,
                                                          .sensors = sensors_at(kPoints),
                                                          .modes = {mode + 1}});
    ASSERT_EQ(reduced.modes.size(), 1U);
    EXPECT_EQ(reduced.modes[0].mode, mode + 1);
    const Errors errors = errors_of(reduced.modes[0]);
    EXPECT_GE(errors.levels, 5U);
    EXPECT_EQ(errors.flagged, 0U);
    EXPECT_LE(errors.frequency, 2e-4);
    EXPECT_LE(errors.damping, 0.03);
  }
}

// Of three modes at once the first is alone after some time; before, and all along in the others,
// the damping is off by up to its double: that is what the flag is for.
TEST(ModalDecay, OfThreeModesAtOnceIsFlaggedWhereTheyModulate) {
  const test::TemporaryFolder folder;
  InitialState start;
  add_start(mode_at(0, 5e-5), start);
  add_start(mode_at(1, 2e-5), start);
  add_start(mode_at(2, 1e-5), start);
  test::put(folder.file("decay.csv"), decay_of(start, 4.0));
  const ReducedModalDecay reduced = reduce_modal_decay(
      {.recording = folder.file("decay.csv"), .model = kModel, .sensors = sensors_at(kPoints)});
  ASSERT_GE(reduced.modes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(reduced.modes[i].mode, i + 1);
  const Errors first = errors_of(reduced.modes[0]);
  EXPECT_GE(first.levels, 3U);
  EXPECT_LE(first.frequency, 1e-4);
  EXPECT_LE(first.damping, 0.02);
  EXPECT_GE(first.flagged, 3U);
  EXPECT_GE(first.flagged_damping, 0.1);
  for (const std::size_t i : {1U, 2U}) {
    const Errors errors = errors_of(reduced.modes[i]);
    EXPECT_EQ(errors.levels, 0U);
    EXPECT_GE(errors.flagged_damping, 0.3);
  }
  const std::string text = modal_levels_text(reduced, "call");
  EXPECT_NE(text.find("# warning: modes_modulate: mode 2: at"), std::string::npos);
  const CsvTable table(text, "m.csv");
  const std::vector<double> mode = table.numbers("mode", kDimensionless);
  EXPECT_EQ(mode.front(), 1.0);
  EXPECT_GE(mode.back(), 3.0);
  for (const char* name : {"damping_ratio", "damping_ratio_std"}) {
    EXPECT_EQ(table.numbers(name, kDimensionless).size(), mode.size());
  }
}

// Without a sensor at the response point the shape with stuck joints stands for it.
TEST(ModalDecay, SaysThatAShapeIsAssumed) {
  const test::TemporaryFolder folder;
  InitialState start;
  add_start(mode_at(1, 5e-6), start);
  test::put(folder.file("decay.csv"), decay_of(start, 1.5));
  const auto reduce = [&](const std::vector<std::string>& sensors) {
    return reduce_modal_decay(
        {.recording = folder.file("decay.csv"), .model = kModel, .sensors = sensors, .modes = {2}});
  };
  const ReducedModalDecay there = reduce({"a_drive=drive"});
  const ReducedModalDecay elsewhere = reduce({"a_p4=p4"});
  ASSERT_FALSE(elsewhere.modes[0].levels.flags.empty());
  for (const std::string& flags : elsewhere.modes[0].levels.flags) {
    EXPECT_NE(flags.find("shape_assumed"), std::string::npos);
  }
  for (const std::string& flags : there.modes[0].levels.flags) {
    EXPECT_EQ(flags.find("shape_assumed"), std::string::npos);
  }
  // At this level the shape is that of the stuck structure to 2 %.
  EXPECT_NEAR(elsewhere.modes[0].levels.amplitude.front(), there.modes[0].levels.amplitude.front(),
              0.05 * there.modes[0].levels.amplitude.front());
}

TEST(ModalDecay, NamesWhatIsWrong) {
  const test::TemporaryFolder folder;
  InitialState start;
  add_start(mode_at(1, 5e-6), start);
  const std::string file = folder.file("decay.csv");
  test::put(file, decay_of(start, 1.0));
  const auto message = [&](const ModalDecayReduction& options) {
    return test::message_or("none", [&] { return reduce_modal_decay(options); });
  };
  const std::vector<std::string> sensors{"a_drive=drive"};
  test::expect_message(message({.recording = file, .model = kModel}), "[[accelerometer]]");
  test::expect_message(message({.recording = file, .model = kModel, .sensors = {"b=drive"}}),
                       "'b'");
  test::expect_message(message({.recording = file, .model = kModel, .sensors = {"a_drive=p9"}}),
                       "'p9'; must be the name of a structure.point");
  test::expect_message(
      message({.recording = file, .model = kModel, .sensors = sensors, .modes = {7}}),
      "mode = 7; must be from 1 to 6");
  // Mode 5 is not in the record.
  EXPECT_NE(message({.recording = file, .model = kModel, .sensors = sensors, .modes = {5}}),
            "none");
  test::expect_message(message({.recording = file, .channels = {"a_drive"}}),
                       "must be one without a model");
  EXPECT_EQ(message({.recording = file, .channels = {"a_drive"}, .modes = {2}}), "none");
}

}  // namespace
}  // namespace microslip::modal_decay_test
