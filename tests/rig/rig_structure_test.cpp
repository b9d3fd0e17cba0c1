// SPDX-License-Identifier: MIT
#include "microslip/rig/rig_structure.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic_balance.hpp"
#include "support/densities.hpp"
#include "support/reference_csv.hpp"
#include "support/rigs.hpp"

namespace microslip {
namespace {

// reference_rig_levels.csv is a SciPy program's; its header says: relative error about 1e-4. The bounds
// are what a drive frequency and a level need.
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
}  // namespace microslip
