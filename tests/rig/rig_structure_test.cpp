// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/rig_structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/densities.hpp"
#include "support/reference_csv.hpp"
#include "support/rigs.hpp"

namespace microslip::rig_structure_test {
namespace {

// reference_rig_levels.csv is a SciPy program's; its header says: relative error about 1e-4. The
// bounds are what a drive frequency and a level need.
TEST(RigStructure, VibratesAsAnotherProgramFound) {
  const testing::ReferenceTable table(std::string(MICROSLIP_TEST_DATA) +
                                      "/reference_rig_levels.csv");
  const Rig rig = testing::reference_rig();
  const HarmonicBalance balance(rig_structure(rig, stick_state(rig, 7), testing::reference_joint()),
                                {"force", ResponseKind::kAcceleration},
                                {.harmonics = 9, .samples = 512});
  const std::vector<double>& response = table["response_amplitude [m/s^2]"];
  const ResponseCurve curve = balance.backbone(response);
  ASSERT_TRUE(curve.summary.converged()) << curve.summary.full();
  for (std::size_t i = 0; i < response.size(); ++i) {
    const SteadyVibration& level = curve.points[i];
    EXPECT_NEAR(level.frequency(), table["frequency [Hz]"][i], 1e-5 * level.frequency());
    EXPECT_NEAR(level.force_amplitude, table["force_amplitude [N]"][i],
                2e-3 * level.force_amplitude);
    EXPECT_NEAR(level.joints[0].dissipation, table["dissipation [J]"][i],
                1e-3 * level.joints[0].dissipation);
  }
}

// The shapes in the file have ten digits.
TEST(RigStructure, IsTheModelOfTheExample) {
  const std::string folder = std::string(MICROSLIP_EXAMPLES) + "/reference_rig";
  const ModelFile example = read_model(folder + "/model.toml");
  const Rig rig = read_rig(folder + "/rig.toml");
  const StickState state = stick_state(rig, 7);
  const JointedStructure expected = rig_structure(rig, state, testing::reference_joint());
  const auto expect_near = [](std::span<const double> found, std::span<const double> wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_NEAR(found[i], wanted[i], 1e-9 * std::abs(wanted[i]));
    }
  };
  const ModalModel& linear = example.structure.linear();
  ASSERT_EQ(linear.size(), state.modes());
  for (std::size_t i = 0; i < linear.size(); ++i) {
    EXPECT_NEAR(linear.modes()[i].angular_frequency, state.omega[i], 1e-9 * state.omega[i]);
    EXPECT_EQ(linear.modes()[i].loss_factor, state.loss_factor[i]);
  }
  EXPECT_EQ(example.structure.damping(), expected.damping());
  expect_near(linear.shape("exciter"), state.excitation);
  expect_near(linear.shape("exciter"), state.accelerometer[0]);
  expect_near(linear.shape("middle"), state.accelerometer[1]);
  expect_near(linear.shape("clamped side"), state.accelerometer[2]);
  const StructuralJoint& joint = example.structure.joints()[0];
  const StructuralJoint& contact = expected.joints()[0];
  expect_near(joint.shape, contact.shape);
  expect_near(joint.shortening, contact.shortening);
  EXPECT_EQ(joint.spring_in_modes, contact.spring_in_modes);
  EXPECT_NEAR(joint.series_compliance, contact.series_compliance, 1e-9 * contact.series_compliance);
  EXPECT_EQ(joint.joint.stiffness(), contact.joint.stiffness());
}

// A drive is set to a tenth of a hertz, and half of that off resonance turns the phase by more than
// half a radian: from the resonance the solution is not near in any component.
TEST(RigStructure, HoldsALevelBesideItsResonance) {
  const Rig rig = testing::reference_rig();
  const HarmonicBalance balance(rig_structure(rig, stick_state(rig, 7), testing::reference_joint()),
                                {"force", ResponseKind::kAcceleration},
                                {.harmonics = 9, .samples = 512});
  for (const double response : {0.294, 1.0, 9.81, 39.24}) {
    const Target level{Quantity::kResponse, response};
    const VibrationResult resonance = balance.solve(kPhaseResonance, level);
    for (const double off : {-0.3, -0.05, 0.05, 0.3}) {  // Hz
      const double omega = resonance.vibration.angular_frequency + 2.0 * std::numbers::pi * off;
      const VibrationResult beside =
          balance.solve({Quantity::kAngularFrequency, omega}, level, resonance.vibration);
      ASSERT_TRUE(beside.summary.converged()) << response << ' ' << off << beside.summary.full();
      EXPECT_LE(beside.vibration.energy_imbalance, 1e-8);
      EXPECT_GT((beside.vibration.phase_lag - kPhaseResonance.value) * off, 0.0);
    }
  }
}

TEST(RigStructure, TakesTheSpringOfTheJointWhereModesTellNone) {
  Rig rig = testing::reference_rig();
  rig.structure = RigModes{{50.0}, {1.0}, {1e-3}};
  rig.contact = {};
  rig.masses.clear();
  for (RigSensor& sensor : rig.accelerometers) sensor.shape = {1.0};
  const JointedStructure structure =
      rig_structure(rig, stick_state(rig), testing::reference_joint());
  EXPECT_EQ(structure.joints()[0].spring_in_modes, testing::reference_joint().stiffness());
  // The joint then sticks as the modes have it.
  EXPECT_NEAR(structure.stuck_frequencies()[0], 2.0 * std::numbers::pi * 50.0, 1e-9);
}

TEST(RigStructure, WarnsOfAnotherStiffness) {
  const StickState state = stick_state(testing::reference_rig(), 7);
  const Joint truth = testing::reference_joint();
  EXPECT_FALSE(stiffness_warning(state, truth));
  EXPECT_FALSE(stiffness_warning(state, Joint(1.005 * truth.stiffness(), truth.density())));
  const auto warning = stiffness_warning(state, Joint(2.0e5, truth.density()));
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->code, "stiffness_differs");
  EXPECT_NE(warning->text.find("2e+05 N/m"), std::string::npos) << warning->text;
  EXPECT_NE(warning->text.find("1.7e+05 N/m"), std::string::npos) << warning->text;
}

}  // namespace
}  // namespace microslip::rig_structure_test
