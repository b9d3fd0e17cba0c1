// SPDX-License-Identifier: MIT
// A structure with two joints whose truth is known, by an independent harmonic balance
// (tests/data/two_joints).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"

namespace microslip::two_joints_test {
namespace {

const std::string kFolder = MICROSLIP_TEST_DATA "/two_joints/";

struct TwoJoints {
  ModelFile model = read_model(kFolder + "model.toml", JointsToFind::kAllowed);
  testing::ReferenceTable truth = testing::reference_table("two_joints/truth.csv");
  ModalLevels levels = measured();

  static ModalLevels measured() {
    const testing::ReferenceTable table = testing::reference_table("two_joints/modal_levels.csv");
    ModalLevels levels;
    for (const double mode : table["mode [1]"]) {
      levels.mode.push_back(static_cast<std::size_t>(mode) - 1);
    }
    levels.displacement = table["displacement [m]"];
    levels.frequency = table["frequency [Hz]"];
    levels.dissipation = table["dissipation [J]"];
    levels.dissipation_std = table["dissipation_std [J]"];
    return levels;
  }

  [[nodiscard]] CalibrationResult calibrated(const CalibrationOptions& options = {}) const {
    return calibrate(model.structure, model.to_find, model.response, levels, options);
  }

  [[nodiscard]] const std::vector<double>& of_joint(const std::string& what,
                                                    std::size_t joint) const {
    return truth[what + "_joint" + std::to_string(joint + 1) +
                 (what == "amplitude" ? " [m]" : " [J]")];
  }

  /// Largest relative error of a joint's amplitude.
  [[nodiscard]] double amplitude_error(const CalibrationResult& found, std::size_t joint) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double error =
          found.levels[i].joints[joint].amplitude / of_joint("amplitude", joint)[i] - 1.0;
      worst = std::max(worst, std::abs(error));
    }
    return worst;
  }

  /// Largest relative error of a joint's D where its share of the loss is above `share`.
  [[nodiscard]] double loss_error(const CalibrationResult& found, std::size_t joint,
                                  double share) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double own = of_joint("dissipation", joint)[i];
      const double all = of_joint("dissipation", 0)[i] + of_joint("dissipation", 1)[i];
      if (own < share * all) continue;
      worst =
          std::max(worst, std::abs(found.levels[i].joints[joint].dissipation.value / own - 1.0));
    }
    return worst;
  }

  [[nodiscard]] double true_density(std::size_t joint, double x) const {
    const Joint true_joint =
        read_joint(kFolder + "truth_joint" + std::to_string(joint + 1) + ".json").joint;
    const double k = true_joint.stiffness();
    return k * k * true_joint.density().density(k * x);
  }

  /// Relative L2 error of ψ over 5 to 90 % of the range of amplitudes, and the share of it that
  /// the band contains.
  [[nodiscard]] std::pair<double, double> density(const CalibratedJoint& found,
                                                  std::size_t joint) const {
    const double reach = std::ranges::max(of_joint("amplitude", joint));
    double square = 0.0;
    double size = 0.0;
    double covered = 0.0;
    double knots = 0.0;
    for (std::size_t i = 0; i < found.slip_displacement.size(); ++i) {
      const double x = found.slip_displacement[i];
      if (x < 0.05 * reach || x > 0.9 * reach) continue;
      const double truth_here = true_density(joint, x);
      square += std::pow(found.density[i] - truth_here, 2);
      size += truth_here * truth_here;
      covered += truth_here >= found.lower[i] && truth_here <= found.upper[i] ? 1.0 : 0.0;
      knots += 1.0;
    }
    return {std::sqrt(square / size), covered / knots};
  }
};

void expect_found(const TwoJoints& test, const CalibrationResult& found, double most_loss) {
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  EXPECT_TRUE(found.warnings.empty()) << found.warnings.front().text;
  for (std::size_t joint = 0; joint < 2; ++joint) {
    const double amplitude = test.amplitude_error(found, joint);
    const double loss = test.loss_error(found, joint, 0.1);
    EXPECT_LT(amplitude, 0.005) << joint;
    // Where a joint has a tenth of the loss or more: 0.5 % of noise on the sum are 5 % of it there.
    EXPECT_LT(loss, most_loss) << joint;
    const auto [error, covered] = test.density(found.joints[joint], joint);
    EXPECT_LT(error, 0.04) << joint;
    EXPECT_GE(covered, 0.9) << joint;
    test::record_largest("amplitude [1]", amplitude);
    test::record_largest("dissipation [1]", loss);
    test::record_largest("density [1]", error);
    test::record_smallest("covered by the band [1]", covered);
  }
}

TEST(TwoJointsFromModalLevels, AreFoundByTheDrivePointAlone) {
  MICROSLIP_OF_RELEASE_ALONE();
  const TwoJoints test;
  expect_found(test, test.calibrated(), 0.03);
}

// In the studies alone: TakesAmplitudesOfSensors has no frequencies either.
TEST(TwoJointsFromModalLevels, AreFoundWithoutFrequencies) {
  MICROSLIP_STUDY();
  const TwoJoints test;
  expect_found(test, test.calibrated({.frequency = FrequencyUse::kIgnore}), 0.04);
}

// k, which frequencies determine, given 5 % too high: to 1e-3, five times the half width of its
// band.
TEST(TwoJointsFromModalLevels, TheirStiffnessesAreFoundToo) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  std::vector<StructuralJoint> joints(test.model.structure.joints().begin(),
                                      test.model.structure.joints().end());
  for (StructuralJoint& joint : joints) joint.joint = Joint(1.05 * joint.joint.stiffness(), {});
  test.model.structure = JointedStructure(test.model.structure.linear(), joints,
                                          {Excitation{"drive"}}, test.model.structure.damping());
  const CalibrationResult found =
      test.calibrated({.frequency = FrequencyUse::kAbsolute, .fit_stiffness = true});
  expect_found(test, found, 0.03);
  EXPECT_NEAR(found.joints[0].stiffness.value, 9e5, 1e-3 * 9e5);
  EXPECT_NEAR(found.joints[1].stiffness.value, 5e5, 1e-3 * 5e5);
}

bool warns_of(const CalibrationResult& found, std::string_view code) {
  return std::ranges::any_of(found.warnings,
                             [&](const Warning& warning) { return warning.code == code; });
}

// Shapes of the stuck structure are wrong by up to 30 % in the displacement of a joint; densities
// found with them by more than all. In the studies alone: TakesAmplitudesOfSensors has these
// shapes, too.
TEST(TwoJointsFromModalLevels, StuckShapesAreWrongByWhatTheyAreWrongBy) {
  MICROSLIP_STUDY();
  const TwoJoints test;
  const CalibrationResult found =
      test.calibrated({.frequency = FrequencyUse::kIgnore, .stuck_shapes = true});
  EXPECT_GT(test.density(found.joints[0], 0).first, 0.5);
  for (std::size_t joint = 0; joint < 2; ++joint) {
    test::record_largest("amplitude [1]", test.amplitude_error(found, joint));
    test::record_largest("density [1]", test.density(found.joints[joint], joint).first);
  }
  EXPECT_TRUE(warns_of(found, "scatter_large"));
}

// A sensor across each joint: its amplitude is used instead of the model's.
TEST(TwoJointsFromModalLevels, TakesAmplitudesOfSensors) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  for (std::size_t joint = 0; joint < 2; ++joint) {
    test.levels.joints.push_back({.name = "joint" + std::to_string(joint + 1),
                                  .amplitude = test.of_joint("amplitude", joint)});
  }
  // With the shapes of the stuck structure, which are wrong by 30 %, so that only the sensors can
  // be right.
  const CalibrationResult found =
      test.calibrated({.frequency = FrequencyUse::kIgnore, .stuck_shapes = true});
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_LT(test.loss_error(found, joint, 0.1), 0.04) << joint;
    EXPECT_LT(test.density(found.joints[joint], joint).first, 0.05) << joint;
  }
}

/// Share of the levels with a tenth of the loss or more at which the band of a joint's loss
/// contains it.
double held(const TwoJoints& test, const CalibrationResult& found, std::size_t joint) {
  double inside = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < test.levels.size(); ++i) {
    const double own = test.of_joint("dissipation", joint)[i];
    const double all = test.of_joint("dissipation", 0)[i] + test.of_joint("dissipation", 1)[i];
    if (own < 0.1 * all) continue;
    const Estimate& band = found.levels[i].joints[joint].dissipation;
    inside += band.lower <= own && own <= band.upper ? 1.0 : 0.0;
    count += 1.0;
  }
  return inside / count;
}

// Displacements by sensors with 1 % of noise, which is 3 % of a loss: in place of those of the
// structure they lead to bands that contain half of the losses. Beside them, as what they are, they
// leave the losses as well known as without.
TEST(TwoJointsFromModalLevels, TakesAmplitudesOfSensorsAsWellAsTheyAreKnown) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  RandomStream random(3, 0);
  for (std::size_t joint = 0; joint < 2; ++joint) {
    JointLevels sensor{.name = "joint" + std::to_string(joint + 1)};
    for (const double a : test.of_joint("amplitude", joint)) {
      sensor.amplitude.push_back(a * (1.0 + 0.01 * random.normal()));
      sensor.amplitude_std.push_back(0.01 * a);
    }
    test.levels.joints.push_back(sensor);
  }
  const CalibrationResult found = test.calibrated();
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  EXPECT_TRUE(found.warnings.empty()) << found.warnings.front().text;
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_LT(test.loss_error(found, joint, 0.1), 0.03) << joint;
    EXPECT_GE(held(test, found, joint), 0.9) << joint;
  }
  EXPECT_LT(found.sensor_scatter, 1.3);
  // A gain of 6 % is beyond them: it is named.
  for (double& a : test.levels.joints[0].amplitude) a *= 1.06;
  const CalibrationResult gained = test.calibrated({.draws = 100});
  EXPECT_TRUE(std::ranges::any_of(gained.warnings, [](const Warning& warning) {
    return warning.code == "sensor_contradicts" && warning.text.find("joint1") != std::string::npos;
  }));
}

// Displacements of the response point with 1 % of noise: the loss of a level is that of the true
// displacement, which the band must contain.
TEST(TwoJointsFromModalLevels, BandsHoldTheLossAtTheTrueDisplacement) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  RandomStream random(4, 0);
  for (double& displacement : test.levels.displacement) {
    test.levels.displacement_std.push_back(0.01 * displacement);
    displacement *= 1.0 + 0.01 * random.normal();
  }
  const CalibrationResult found = test.calibrated();
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_GE(held(test, found, joint), 0.9) << joint;
  }
}

/// Of both joints, where a tenth of the loss or more is theirs, and within their bands.
void expect_losses(const TwoJoints& test, const CalibrationResult& found) {
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  EXPECT_LT(found.loss_scatter, 1.3);
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_LT(test.loss_error(found, joint, 0.1), 0.03) << joint;
    EXPECT_GE(held(test, found, joint), 0.9) << joint;
  }
}

// Frequencies of the structure 0.75 % too high: its softening is, too, which losses contradict.
// They are corrected by what the modes are measured off, and the joints are as with the right ones.
TEST(TwoJointsFromModalLevels, AreFoundInAStructureThatIsTooStiff) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  const std::vector<double> off(test.model.structure.linear().size(), 0.0075);
  test.model.structure = with_modal_offsets(test.model.structure, off);
  const CalibrationResult found = test.calibrated();
  expect_losses(test, found);
  // To a twentieth of the offset: joints share some of the softening.
  for (const std::size_t mode : {0, 1, 2}) {
    EXPECT_NEAR(found.frequency_offset[mode], -0.0075, 4e-4) << mode;
    EXPECT_NEAR(found.modes.offset[mode], -0.0075, 4e-4) << mode;
  }
}

// All but the joints 1.5 % too stiff, as by a modulus: the stuck modes, which have the springs of
// the joints in them, are then off by 0.36 to 0.61 %, each by another share, and so are their
// shapes. The modes without joints are off alike; one of them is a rigid motion, so that no
// structure has other offsets. The error of a loss is that of the tests beside this.
TEST(TwoJointsFromModalLevels, AreFoundInAStructureWithAWrongModulus) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  const std::vector<double> off(test.model.structure.linear().size(), 0.0075);
  test.model.structure =
      with_modal_offsets(test.model.structure, off, std::vector<double>{0.0075, 0.0075});
  const CalibrationResult found = test.calibrated();
  expect_losses(test, found);
  ASSERT_EQ(found.modes.springs.size(), 2U);
  for (const double spring : found.modes.springs) EXPECT_NEAR(spring, -0.0075, 4e-4);
  for (const std::size_t mode : {0, 1, 2}) {
    EXPECT_NEAR(found.modes.offset[mode], -0.0075, 4e-4) << mode;
  }
  EXPECT_FALSE(warns_of(found, "offsets_differ"));
}

// Each mode off by another share, those without levels, too: shapes are then off as well. The
// offsets are found with the joints; of a mode without levels to what the levels tell of it. The
// error of a loss is that of the tests beside this.
TEST(TwoJointsFromModalLevels, AreFoundInAStructureWithEachModeOff) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  const std::vector<double> off{0.0085, 0.0035, 0.0075, 0.009, 0.005, 0.012};
  test.model.structure = with_modal_offsets(test.model.structure, off);
  const CalibrationResult found = test.calibrated();
  expect_losses(test, found);
  for (const std::size_t mode : {0, 1, 2}) {
    EXPECT_NEAR(found.modes.offset[mode], -off[mode], 4e-4) << mode;
  }
  EXPECT_TRUE(warns_of(found, "offsets_differ"));
}

/// ζ of the structure with the true joints at the levels, by harmonic balance.
std::vector<double> true_damping(const TwoJoints& test) {
  const JointedStructure& given = test.model.structure;
  std::vector<StructuralJoint> joints(given.joints().begin(), given.joints().end());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j].joint = read_joint(kFolder + "truth_joint" + std::to_string(j + 1) + ".json").joint;
  }
  const HarmonicBalance balance({given.linear(), joints, {Excitation{"drive"}}, given.damping()},
                                {test.model.response}, {});
  std::vector<double> ratios;
  for (std::size_t mode = 0; mode <= test.levels.mode.back(); ++mode) {
    std::vector<double> responses;
    for (std::size_t i = 0; i < test.levels.size(); ++i) {
      if (test.levels.mode[i] == mode) responses.push_back(test.levels.displacement[i]);
    }
    for (const SteadyVibration& point : balance.backbone(responses, mode).points) {
      ratios.push_back(point.damping_ratio());
    }
  }
  return ratios;
}

// The levels of the truth as damping ratios, structure included, with 0.5 % of noise.
TEST(TwoJointsFromModalLevels, AreFoundFromDampingRatios) {
  MICROSLIP_OF_RELEASE_ALONE();
  TwoJoints test;
  RandomStream random(8, 0);
  for (const double ratio : true_damping(test)) {
    test.levels.damping_ratio.push_back(ratio * (1.0 + 0.005 * random.normal()));
    test.levels.damping_ratio_std.push_back(0.005 * ratio);
  }
  ASSERT_EQ(test.levels.damping_ratio.size(), test.levels.size());
  test.levels.dissipation.clear();
  test.levels.dissipation_std.clear();
  const CalibrationResult found = test.calibrated();
  ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
  // Where the structure has nine tenths of ζ its noise is 5 % of the loss of the joints: that is
  // all there is to name.
  for (const Warning& warning : found.warnings) EXPECT_EQ(warning.code, "loss_uncertain");
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_LT(test.amplitude_error(found, joint), 0.005) << joint;
    // As from losses: of ζ the structure has up to nine tenths, but at low levels alone.
    EXPECT_LT(test.density(found.joints[joint], joint).first, 0.04) << joint;
  }
}

}  // namespace
}  // namespace microslip::two_joints_test
