// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/modal_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/jointed_records.hpp"
#include "support/messages.hpp"
#include "support/reference_csv.hpp"

namespace microslip::modal_reduction_test {
namespace {

using testing::JointedSampling;
using testing::random_chain;
using testing::record_of;

constexpr JointedSampling kQuiet{.force_noise = 0.0, .acceleration_noise = 0.0};

std::vector<std::string> all_points(const JointedStructure& structure) {
  std::vector<std::string> names;
  for (const ModalPoint& point : structure.linear().points()) names.push_back(point.name);
  return names;
}

StructureTest test_with(const JointedStructure& structure, const std::vector<std::string>& points) {
  StructureTest test{structure, structure.excitations().front().point, "force", {}};
  for (const std::string& point : points) test.accelerometers.push_back({point, point});
  return test;
}

/// Joints that are not known but for their stiffness and place, as who observes them has them.
JointedStructure without_slip(const JointedStructure& structure) {
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  for (StructuralJoint& joint : joints) joint.joint = Joint(joint.joint.stiffness(), SlipDensity());
  return JointedStructure(structure.linear(), joints,
                          {structure.excitations().begin(), structure.excitations().end()},
                          structure.damping());
}

double moved_by(const std::vector<double>& shape, std::span<const double> place) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) sum += place[i] * shape[i];
  return std::abs(sum);
}

/// Of the first four modes those that move the exciter most: the first of them, or the second.
std::size_t driven_mode(const JointedStructure& structure, std::size_t rank = 0) {
  std::vector<std::pair<double, std::size_t>> modes;
  for (std::size_t mode = 0; mode < 4; ++mode) {
    modes.emplace_back(moved_by(structure.stuck_mode(mode), structure.linear().shape("p1")), mode);
  }
  std::ranges::sort(modes, std::greater());
  return modes[rank].second;
}

/// The response at the exciter at which the largest force of a stuck joint would be this, N.
double response_at(const JointedStructure& structure, std::size_t mode, double force) {
  const std::vector<double> shape = structure.stuck_mode(mode);
  double largest = 0.0;
  for (const StructuralJoint& joint : structure.joints()) {
    largest = std::max(largest, joint.joint.stiffness() * moved_by(shape, joint.shape));
  }
  return moved_by(shape, structure.linear().shape("p1")) * force / largest;
}

/// At phase resonance of a mode; joints slip up to 30 to 120 N.
SteadyVibration resonance(const JointedStructure& structure, std::size_t mode,
                          double force = 15.0) {
  const HarmonicBalance balance(structure, {"p1"}, {.harmonics = 7});
  const VibrationResult result = balance.solve(
      kPhaseResonance, {Quantity::kResponse, response_at(structure, mode, force)}, mode);
  EXPECT_TRUE(result.summary.converged()) << result.summary.full();
  return result.vibration;
}

/// With modes of softer joints than those that are there, and something in series with the first.
JointedStructure with_other_modes(const JointedStructure& structure) {
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  joints[0].series_compliance = 0.2 / joints[0].joint.stiffness();
  joints[1].spring_in_modes *= 0.8;
  return JointedStructure(structure.linear(), joints,
                          {structure.excitations().begin(), structure.excitations().end()},
                          structure.damping());
}

const Warning* flag_of(const ModalLevel& level, const std::string& code) {
  const auto found = std::ranges::find(level.flags, code, &Warning::code);
  return found == level.flags.end() ? nullptr : &*found;
}

/// One of tests/data/two_joints.
ModalLevel reference_level(const std::string& name) {
  const std::string folder = std::string(MICROSLIP_TEST_DATA) + "/two_joints/";
  ModelFile model = read_model(folder + "model.toml", JointsToFind::kAllowed);
  StructureTest test{model.structure, model.response, "", {}};
  for (int i = 1; i <= 6; ++i) {
    test.accelerometers.push_back(
        {"acc" + std::to_string(i), i == 1 ? "drive" : "p" + std::to_string(i)});
  }
  const Recordings file = read_recordings(folder + "recordings/" + name + ".csv", {});
  return ModalReducer(test).reduce(file.recordings.front());
}

// Against an independent harmonic balance, exact to 3e-6; sensors with noise of 2 mN and 5 mm/s².
// The noise of these coefficients, 6e-5 N and 1.6e-4 m/s², makes what is allowed: 1 % of the joint
// amplitudes, and 2 % of D of each joint, which all have more than a tenth of the loss.
TEST(ModalReducer, FindsTheReferenceStructure) {
  const testing::ReferenceTable truth = testing::reference_table("two_joints/truth.csv");
  struct Case {
    const char* name;
    std::size_t mode;
    std::size_t row;
  };
  for (const Case& record :
       {Case{"mode1_level16", 1, 15}, {"mode2_level10", 2, 34}, {"mode3_level22", 3, 71}}) {
    SCOPED_TRACE(record.name);
    ASSERT_EQ(truth["mode [1]"][record.row], static_cast<double>(record.mode));
    const ModalLevel level = reference_level(record.name);
    EXPECT_EQ(level.mode, record.mode);
    const double x = truth["displacement [m]"][record.row];
    const double f = truth["frequency [Hz]"][record.row];
    EXPECT_NEAR(level.displacement.value, x, 1e-3 * x);
    EXPECT_NEAR(level.frequency.value, f, 5e-6 * f);
    double sum = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const std::string name = "joint" + std::to_string(j + 1);
      const double a = truth["amplitude_" + name + " [m]"][record.row];
      const double d = truth["dissipation_" + name + " [J]"][record.row];
      const JointLevel& joint = level.joints[j];
      EXPECT_NEAR(joint.amplitude.value, a, 1e-3 * a);
      EXPECT_NEAR(joint.dissipation.value, d, 0.02 * d);
      EXPECT_NEAR(joint.dissipation.value, d, 4.0 * joint.dissipation.std);
      EXPECT_LE(joint.dissipation.std, 0.03 * d);
      test::record_deviation("amplitude", joint.amplitude.value, a);
      test::record_deviation("dissipation", joint.dissipation.value, d);
      sum += d;
    }
    EXPECT_NEAR(level.dissipation.value, sum, 5e-3 * sum);
    EXPECT_LE(std::abs(level.energy_difference.value), 4.0 * level.energy_difference.std);
  }
}

// Without noise all that is left is what harmonics above the order of the fit do, and the 7 of the
// balance: the whole of each joint's motion, force and loss is found, in each mode.
TEST(ModalReducer, IsExactWithoutNoise) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const DampingLaw damping = seed % 2 == 0 ? DampingLaw::kHysteretic : DampingLaw::kViscous;
    const JointedStructure chain = random_chain(seed, 2 + seed % 2, damping);
    const JointedStructure structure = seed > 3 ? with_other_modes(chain) : chain;
    const ModalReducer reducer(test_with(without_slip(structure), all_points(structure)));
    const std::size_t mode = driven_mode(structure, seed % 2);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SteadyVibration truth = resonance(structure, mode);
    const ModalLevel level =
        reducer.reduce(record_of(structure, truth, all_points(structure), seed, kQuiet));
    EXPECT_EQ(level.mode, mode + 1);
    EXPECT_NEAR(level.frequency.value, truth.frequency(), 1e-7 * truth.frequency());
    EXPECT_NEAR(level.input_energy, truth.input_energy, 1e-6 * truth.input_energy);
    EXPECT_NEAR(level.linear_dissipation, truth.linear_dissipation,
                1e-6 * truth.linear_dissipation);
    for (std::size_t j = 0; j < level.joints.size(); ++j) {
      const JointCycle& joint = truth.joints[j];
      EXPECT_NEAR(level.joints[j].amplitude.value, joint.amplitude, 1e-5 * joint.amplitude);
      EXPECT_NEAR(level.joints[j].dissipation.value, joint.dissipation,
                  1e-5 * level.dissipation.value);
      EXPECT_EQ(level.joints[j].unseen, 0.0);
    }
    EXPECT_EQ(flag_of(level, "joint_not_seen"), nullptr);
    EXPECT_EQ(flag_of(level, "secant_above_stuck"), nullptr);
    EXPECT_EQ(flag_of(level, "model_misfit"), nullptr);
    EXPECT_EQ(flag_of(level, "energies_differ"), nullptr);
  }
}

// The standard deviations are those of the errors: of all joints of many noisy records, errors over
// standard deviations have a mean square of 1, to what 120 to 180 of them scatter (4 standard
// deviations of 1 ± √(2/120), and t-distributed with the cycles of a record).
TEST(ModalReducer, StandardDeviationsAreThoseOfTheErrors) {
  MICROSLIP_OF_RELEASE_ALONE();
  double dissipation = 0.0;
  double amplitude = 0.0;
  double total = 0.0;
  double balance = 0.0;
  std::size_t records = 0;
  std::size_t joints = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const JointedStructure structure = random_chain(seed, 2 + seed % 2, DampingLaw::kHysteretic);
    const ModalReducer reducer(test_with(without_slip(structure), all_points(structure)));
    const SteadyVibration truth = resonance(structure, driven_mode(structure, seed % 2), 8.0);
    for (std::uint64_t draw = 0; draw < 10; ++draw) {
      const ModalLevel level =
          reducer.reduce(record_of(structure, truth, all_points(structure), 100 * seed + draw));
      double sum = 0.0;
      for (std::size_t j = 0; j < level.joints.size(); ++j) {
        const JointLevel& found = level.joints[j];
        sum += truth.joints[j].dissipation;
        dissipation += std::pow(
            (found.dissipation.value - truth.joints[j].dissipation) / found.dissipation.std, 2);
        amplitude +=
            std::pow((found.amplitude.value - truth.joints[j].amplitude) / found.amplitude.std, 2);
        ++joints;
      }
      total += std::pow((level.dissipation.value - sum) / level.dissipation.std, 2);
      balance += std::pow(level.energy_difference.value / level.energy_difference.std, 2);
      ++records;
    }
  }
  EXPECT_NEAR(dissipation / static_cast<double>(joints), 1.0, 0.5);
  EXPECT_NEAR(amplitude / static_cast<double>(joints), 1.0, 0.5);
  EXPECT_NEAR(total / static_cast<double>(records), 1.0, 0.7);
  EXPECT_NEAR(balance / static_cast<double>(records), 1.0, 0.7);
}

// Off resonance by a third of the half-power width the frequency is that of the resonance all the
// same, and the flag says so. At the same response the other modes carry more of it there, so that
// the joints slip otherwise: that is a tenth of the offset here.
TEST(ModalReducer, FindsTheResonanceBesideTheDrive) {
  const JointedStructure structure = random_chain(2, 2, DampingLaw::kHysteretic);
  const ModalReducer reducer(test_with(without_slip(structure), all_points(structure)));
  const HarmonicBalance balance(structure, {"p1"}, {.harmonics = 7});
  const SteadyVibration peak = resonance(structure, driven_mode(structure));
  const double width = 2.0 * peak.damping_ratio() * peak.angular_frequency;
  for (const double share : {-0.3, 0.3}) {
    const VibrationResult off =
        balance.solve({Quantity::kAngularFrequency, peak.angular_frequency + share * width},
                      {Quantity::kResponse, peak.response}, peak);
    ASSERT_TRUE(off.summary.converged());
    const ModalLevel level =
        reducer.reduce(record_of(structure, off.vibration, all_points(structure), 1, kQuiet));
    EXPECT_NEAR(level.frequency.value, peak.frequency(),
                0.15 * std::abs(level.drive_frequency - peak.frequency()));
    EXPECT_NE(flag_of(level, "off_resonance"), nullptr);
  }
  const ModalLevel level = reducer.reduce(record_of(structure, peak, all_points(structure), 1));
  EXPECT_EQ(flag_of(level, "off_resonance"), nullptr);
}

// One accelerometer for two joints shows one combination of them. The unobserved is reported, its
// standard deviation covers the error, and what all lose together is right.
TEST(ModalReducer, SaysWhatTooFewSensorsDoNotShow) {
  const JointedStructure structure = random_chain(2, 2, DampingLaw::kHysteretic);
  const ModalReducer reducer(test_with(without_slip(structure), {"p1"}));
  const SteadyVibration truth = resonance(structure, driven_mode(structure));
  const ModalLevel level = reducer.reduce(record_of(structure, truth, {"p1"}, 1));
  const Warning* flag = flag_of(level, "joint_not_seen");
  ASSERT_NE(flag, nullptr);
  test::expect_message(flag->text, "of 'j");
  double sum = 0.0;
  double shares = 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    const JointLevel& found = level.joints[j];
    sum += truth.joints[j].dissipation;
    shares += found.unseen * found.unseen;
    EXPECT_LE(std::abs(found.amplitude.value - truth.joints[j].amplitude), found.amplitude.std);
    EXPECT_LE(std::abs(found.dissipation.value - truth.joints[j].dissipation),
              found.dissipation.std);
  }
  EXPECT_NEAR(shares, 1.0, 1e-9);
  EXPECT_NEAR(level.dissipation.value, sum, 0.03 * sum);
}

// A sensor at a node of the mode adds little and harms nothing; where all are, nothing is seen.
TEST(ModalReducer, BearsASensorAtANode) {
  const JointedStructure given = random_chain(4, 2, DampingLaw::kHysteretic);
  std::vector<ModalPoint> points(given.linear().points().begin(), given.linear().points().end());
  const std::vector<double> shape = given.stuck_mode(1);
  // A share of p2 and p3 that the second mode does not move.
  std::vector<double> node = points[1].shape;
  double moved[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < shape.size(); ++i) {
    moved[0] += points[1].shape[i] * shape[i];
    moved[1] += points[2].shape[i] * shape[i];
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    node[i] -= moved[0] / moved[1] * points[2].shape[i];
  }
  points.push_back({"node", node});
  const JointedStructure structure(
      ModalModel({given.linear().modes().begin(), given.linear().modes().end()}, points),
      {given.joints().begin(), given.joints().end()},
      {given.excitations().begin(), given.excitations().end()}, given.damping());
  const SteadyVibration truth = resonance(structure, 1);
  std::vector<std::string> sensors = all_points(structure);
  const ModalLevel level = ModalReducer(test_with(without_slip(structure), sensors))
                               .reduce(record_of(structure, truth, sensors, 1));
  EXPECT_EQ(level.mode, 2U);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(level.joints[j].dissipation.value, truth.joints[j].dissipation,
                4.0 * level.joints[j].dissipation.std);
  }
  const Recording record = record_of(structure, truth, {"node"}, 1);
  test::expect_message(
      test::message_or(
          "none",
          [&] {
            return ModalReducer(test_with(without_slip(structure), {"node"})).reduce(record);
          }),
      "all at nodes of mode 2");
}

TEST(ModalReducer, SaysThatTheModelIsAnother) {
  const JointedStructure structure = random_chain(2, 2, DampingLaw::kHysteretic);
  const SteadyVibration truth = resonance(structure, driven_mode(structure));
  Recording record = record_of(structure, truth, all_points(structure), 1);
  for (double& value : record.channels[3].values) value *= -1.0;
  const ModalReducer reducer(test_with(without_slip(structure), all_points(structure)));
  const ModalLevel level = reducer.reduce(record);
  const Warning* flag = flag_of(level, "model_misfit");
  ASSERT_NE(flag, nullptr);
  test::expect_message(flag->text, "of channel 'p");
}

TEST(ModalReducer, NamesWhatIsWrong) {
  const JointedStructure structure = without_slip(random_chain(2, 2, DampingLaw::kHysteretic));
  const auto message = [&](const StructureTest& test, const ModalReductionOptions& options = {}) {
    return test::message_or("none", [&] { return ModalReducer(test, options); });
  };
  StructureTest test = test_with(structure, {"p1", "p2"});
  test::expect_message(message(test, {.mode = 9}), "mode = 9; must be from 1 to");
  test::expect_message(message(test, {.most_misfit = 0.0}), "most_misfit");
  test.accelerometers[1].point = "p99";
  test::expect_message(message(test), "p99");
  test = test_with(structure, {"p1", "p2"});
  test.accelerometers[1].channel = "p1";
  test::expect_message(message(test), "p1; must differ");
  test = test_with(structure, {});
  test::expect_message(message(test), "accelerometers = none");
  test = test_with(structure, {"p1"});
  test.response = "p77";
  test::expect_message(message(test), "p77");
  const JointedStructure bare(structure.linear(), {}, {{.point = "p1"}});
  test::expect_message(message(test_with(bare, {"p1"})), "joint is missing");
}

TEST(ModalReducer, NamesWhatTheRecordLacks) {
  const JointedStructure structure = random_chain(2, 2, DampingLaw::kHysteretic);
  const SteadyVibration truth = resonance(structure, driven_mode(structure));
  const Recording record = record_of(structure, truth, {"p1", "p2"}, 1);
  const auto message = [&](StructureTest test, const Recording& of) {
    return test::message_or("none", [&] { return ModalReducer(test).reduce(of); });
  };
  test::expect_message(message(test_with(without_slip(structure), {"p1", "p3"}), record),
                       "record 1: channel 'p3' is missing");
  Recording wrong = record;
  wrong.channels[2].dimension = kVelocity;
  test::expect_message(message(test_with(without_slip(structure), {"p1", "p2"}), wrong),
                       "channel 'p2' = velocity; must be acceleration");
  StructureTest any = test_with(without_slip(structure), {"p1", "p2"});
  any.force_channel.clear();
  EXPECT_NO_THROW((void)ModalReducer(any).reduce(record));
  wrong = record;
  wrong.channels[0].dimension = kAcceleration;
  test::expect_message(message(any, wrong), "channel of the force is missing");
}

}  // namespace
}  // namespace microslip::modal_reduction_test
