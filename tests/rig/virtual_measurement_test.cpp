// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/rig/setup/shaker.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "support/densities.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"
#include "support/rigs.hpp"

namespace microslip::virtual_measurement_test {
namespace {

using Complex = std::complex<double>;
using testing::reference_joint;
using testing::reference_rig;

/// The rig of the published experiment: a drive in steps of 0.1 Hz.
Rig tested_rig() {
  Rig rig = reference_rig();
  rig.test->frequency_resolution = 0.1;
  return rig;
}

Rig rig_of_levels(double from, double to, std::size_t count) {
  Rig rig = tested_rig();
  rig.test->response_from = from;
  rig.test->response_to = to;
  rig.test->count = count;
  return rig;
}

/// All 90 levels, solved once.
const VirtualMeasurement& reference_test() {
  static const VirtualMeasurement kTest = measure_virtually(tested_rig(), reference_joint());
  return kTest;
}

std::vector<Complex> exciter_acceleration(const Rig& rig, const DrivenVibration& driven) {
  const StickState state = stick_state(rig);
  std::vector<Complex> result(driven.force.size());
  for (std::size_t n = 1; n < result.size(); ++n) {
    const double omega = static_cast<double>(n) * driven.vibration.angular_frequency;
    for (std::size_t i = 0; i < state.modes(); ++i) {
      result[n] -= omega * omega * state.excitation[i] * driven.vibration.modal[i][n];
    }
  }
  return result;
}

std::vector<Complex> exciter_displacement(const Rig& rig, const DrivenVibration& driven) {
  std::vector<Complex> result = exciter_acceleration(rig, driven);
  for (std::size_t n = 1; n < result.size(); ++n) {
    result[n] /= -std::pow(static_cast<double>(n) * driven.vibration.angular_frequency, 2);
  }
  return result;
}

// reference_rig_levels.csv is a SciPy program's under a pure force at phase resonance; its header
// says: relative error about 1e-4. The small second harmonic is next to its error.
TEST(VirtualMeasurement, MeasuresWhatAnotherProgramFound) {
  const testing::ReferenceTable table(std::string(MICROSLIP_TEST_DATA) +
                                      "/reference_rig_levels.csv");
  const std::vector<double>& response = table["response_amplitude [m/s^2]"];
  for (std::size_t i = 0; i < response.size(); ++i) {
    Rig rig = rig_of_levels(response[i], response[i], 1);
    rig.test->frequency_resolution = 0.0;
    const VirtualMeasurement test = measure_virtually(rig, reference_joint(), {.shaker = false});
    ASSERT_TRUE(test.summary.converged()) << test.summary.full();
    ASSERT_EQ(test.levels.size(), 1U);
    const VirtualLevel& level = test.levels[0];
    const SteadyVibration& found = level.controlled.vibration;
    const auto expect = [&](double value, const std::string& column, double tolerance) {
      EXPECT_NEAR(value, table[column][i], tolerance * table[column][i]) << column << ", row " << i;
    };
    expect(level.resonance_frequency, "frequency [Hz]", 1e-5);
    expect(level.frequency, "frequency [Hz]", 1e-5);
    expect(found.force_amplitude, "force_amplitude [N]", 2e-3);
    expect(found.joints[0].amplitude, "amplitude [m]", 5e-4);
    expect(found.joints[0].dissipation, "dissipation [J]", 1e-3);
    expect(found.input_energy, "input_energy [J]", 1e-3);
    expect(found.linear_dissipation, "linear_dissipation [J]", 1e-3);
    const std::vector<Complex> acceleration = exciter_acceleration(rig, level.controlled);
    expect(std::abs(acceleration[2]), "acceleration_harmonic2 [m/s^2]", 0.02);
    expect(std::abs(acceleration[3]), "acceleration_harmonic3 [m/s^2]", 0.02);
  }
}

TEST(VirtualMeasurement, HoldsResponseFrequencyAndForceAtAll90Levels) {
  const VirtualMeasurement& test = reference_test();
  ASSERT_TRUE(test.summary.converged()) << test.summary.full();
  ASSERT_EQ(test.levels.size(), 90U);
  for (const VirtualLevel& level : test.levels) {
    EXPECT_TRUE(level.warnings.empty());
    EXPECT_LE(force_distortion(level.controlled, 10), 0.003) << level.number;
    test::record_largest("controlled [1]", force_distortion(level.controlled, 10));
    test::record_largest("uncontrolled [1]", force_distortion(level.uncontrolled, 10));
    EXPECT_NEAR(level.controlled.vibration.response, level.response, 1e-9 * level.response);
    EXPECT_NEAR(level.uncontrolled.vibration.response, level.response, 1e-9 * level.response);
    EXPECT_NEAR(level.frequency, level.resonance_frequency, 0.05 + 1e-9);
    EXPECT_EQ(level.frequency, std::round(10.0 * level.frequency) / 10.0);
    EXPECT_NEAR(level.controlled.vibration.frequency(), level.frequency, 1e-9);
  }
  // 4 g at 55.8 to 54.6 Hz, as published.
  EXPECT_NEAR(test.levels.front().frequency, 55.8, 0.051);
  EXPECT_NEAR(test.levels.back().frequency, 54.6, 0.11);
}

// Fig. 7 of the paper: the force without control is clearly distorted, above all by its third
// harmonic, as the force of the joint is odd.
TEST(VirtualMeasurement, IsDistortedWithoutControl) {
  const VirtualLevel& level = reference_test().levels.back();
  EXPECT_GT(force_distortion(level.uncontrolled, 10), 0.03);
  EXPECT_EQ(force_distortion(level.uncontrolled, 10),
            std::abs(level.uncontrolled.force[3]) / std::abs(level.uncontrolled.force[1]));
  EXPECT_GE(level.control_iterations, 1);
}

// F_n = a_n V_n − b_n w_n in rounding, for the voltages that are returned; those are a sine to the
// tolerance of the iteration, 1e-9 of the force.
TEST(VirtualMeasurement, SatisfiesTheEquationsOfShakerAndStructureTogether) {
  const Rig rig = tested_rig();
  const RigShaker shaker;
  for (const VirtualLevel& level : reference_test().levels) {
    for (const DrivenVibration* driven : {&level.controlled, &level.uncontrolled}) {
      const std::vector<Complex> w = exciter_displacement(rig, *driven);
      const double force = driven->vibration.force_amplitude;
      for (std::size_t n = 1; n < w.size(); ++n) {
        const ShakerTransfer transfer =
            shaker_transfer(shaker, static_cast<double>(n) * driven->vibration.angular_frequency);
        const Complex made = transfer.voltage * driven->voltage[n] - transfer.displacement * w[n];
        EXPECT_LT(std::abs(driven->force[n] - made), 1e-12 * force);
        if (driven == &level.controlled || n == 1) continue;
        EXPECT_LT(std::abs(transfer.voltage * driven->voltage[n]), 1e-8 * force);
      }
      const ShakerEnergy energy = shaker_energy(shaker, driven->vibration.angular_frequency,
                                                driven->voltage, driven->force, w);
      const double lost = energy.coil + energy.suspension + driven->vibration.linear_dissipation +
                          driven->vibration.joints[0].dissipation;
      EXPECT_NEAR(energy.electrical, lost, 1e-9 * lost);
    }
  }
}

// [AR14 (15)]; and D of the harmonics is D(A) of the joint, whose cycles here have two reversals:
// the harmonics above H make the difference.
TEST(VirtualMeasurement, TruthKeepsTheEnergyBalance) {
  const Joint joint = reference_joint();
  for (const VirtualLevel& level : reference_test().levels) {
    const SteadyVibration& truth = level.controlled.vibration;
    const JointCycle& cycle = truth.joints[0];
    EXPECT_LT(truth.energy_imbalance, 1e-9);
    EXPECT_EQ(cycle.reversals, 2U);
    EXPECT_NEAR(cycle.dissipation, dissipation(joint, cycle.amplitude), 1e-4 * cycle.dissipation);
  }
}

TEST(VirtualMeasurement, IsTheSameOnOneThread) {
  const Rig rig = rig_of_levels(5.0, 39.24, 6);
  const VirtualMeasurement many = measure_virtually(rig, reference_joint());
  const VirtualMeasurement alone =
      measure_virtually(rig, reference_joint(), {.execution = Execution::serial()});
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(many.levels[i].controlled.force, alone.levels[i].controlled.force);
    EXPECT_EQ(many.levels[i].controlled.voltage, alone.levels[i].controlled.voltage);
    EXPECT_EQ(many.levels[i].controlled.vibration.modal,
              alone.levels[i].controlled.vibration.modal);
  }
}

TEST(VirtualMeasurement, SpacesItsLevels) {
  RigTest test;
  test.response_from = 1.0;
  test.response_to = 100.0;
  test.count = 3;
  EXPECT_EQ(response_levels(test), (std::vector<double>{1.0, 50.5, 100.0}));
  test.logarithmic = true;
  EXPECT_NEAR(response_levels(test)[1], 10.0, 1e-12);
  test.count = 1;
  EXPECT_EQ(response_levels(test), std::vector<double>{1.0});
}

/// The beam by its modes.
Rig modes_rig() {
  Rig rig = rig_of_levels(5.0, 39.24, 4);
  const StickState state = stick_state(rig);
  RigModes modes{{}, state.excitation, state.joint};
  for (const double omega : state.omega)
    modes.frequency.push_back(omega / (2.0 * std::numbers::pi));
  rig.structure = modes;
  rig.contact.rod_radius = 0.0;
  rig.masses.clear();
  for (std::size_t j = 0; j < rig.accelerometers.size(); ++j) {
    rig.accelerometers[j].shape = state.accelerometer[j];
  }
  return rig;
}

// Modes have no shortening, whose second harmonic then is missing, and no axial compliance, which
// for the beam is 1.4e-8 m/N, 0.2 % of that of the joint.
TEST(VirtualMeasurement, TakesModesForTheBeam) {
  const VirtualMeasurement test = measure_virtually(modes_rig(), reference_joint());
  ASSERT_TRUE(test.summary.converged()) << test.summary.full();
  const VirtualMeasurement beam =
      measure_virtually(rig_of_levels(5.0, 39.24, 4), reference_joint());
  for (std::size_t i = 0; i < 4; ++i) {
    const SteadyVibration& found = test.levels[i].controlled.vibration;
    const SteadyVibration& expected = beam.levels[i].controlled.vibration;
    EXPECT_LE(force_distortion(test.levels[i].controlled, 10), 0.003);
    EXPECT_NEAR(found.joints[0].amplitude, expected.joints[0].amplitude,
                0.01 * expected.joints[0].amplitude);
    EXPECT_LT(std::abs(exciter_acceleration(modes_rig(), test.levels[i].controlled)[2]),
              1e-6 * found.response);
  }
}

TEST(VirtualMeasurement, TellsOfMacroSlip) {
  const VirtualMeasurement test =
      measure_virtually(rig_of_levels(39.24, 80.0, 3), reference_joint());
  ASSERT_TRUE(test.summary.converged()) << test.summary.full();
  EXPECT_TRUE(test.levels[0].warnings.empty());
  ASSERT_EQ(test.levels[2].warnings.size(), 1U);
  EXPECT_EQ(test.levels[2].warnings[0].code, kMacroSlip);
}

// Where the shortening has taken over, 5 mm and more at the joint, phase resonance is that of an
// antiresonance. The levels below it are as ever.
TEST(VirtualMeasurement, TellsOfLevelsWithoutResonanceAndGoesOn) {
  Rig rig = rig_of_levels(30.0, 1e4, 8);
  rig.test->logarithmic = true;
  const VirtualMeasurement test = measure_virtually(rig, reference_joint(), {.shaker = false});
  EXPECT_FALSE(test.summary.converged());
  EXPECT_NE(test.summary.reason.find("of 8 levels found; level "), std::string::npos)
      << test.summary.reason;
  EXPECT_TRUE(test.levels[0].summary.converged());
  EXPECT_TRUE(test.levels[3].summary.converged());
  for (const VirtualLevel& level : test.levels) {
    if (level.summary.converged()) {
      EXPECT_LT(level.resonance_frequency, 55.8);
    } else {
      EXPECT_NE(level.summary.reason.find("no"), std::string::npos) << level.summary.reason;
    }
  }
}

TEST(VirtualMeasurement, TellsOfAForceThatIsNotControlled) {
  const VirtualMeasurement test = measure_virtually(
      rig_of_levels(39.24, 39.24, 1), reference_joint(), {.max_control_iterations = 0});
  ASSERT_TRUE(test.summary.converged());
  ASSERT_EQ(test.levels[0].warnings.size(), 1U);
  EXPECT_EQ(test.levels[0].warnings[0].code, kForceNotControlled);
  EXPECT_EQ(test.levels[0].controlled.force, test.levels[0].uncontrolled.force);
}

std::string message(const Rig& rig, const VirtualMeasurementOptions& options = {}) {
  try {
    (void)measure_virtually(rig, reference_joint(), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// A node of all modes: no force moves the exciter.
TEST(VirtualMeasurement, RefusesAnExciterThatMovesNothing) {
  Rig rig = modes_rig();
  std::get<RigModes>(rig.structure).excitation.assign(7, 0.0);
  EXPECT_EQ(message(rig).substr(0, 20), "modes.excitation = 0");
}

TEST(VirtualMeasurement, RefusesATestThatCannotBe) {
  Rig rig = reference_rig();
  rig.test.reset();
  EXPECT_EQ(message(rig).substr(0, 12), "test = none;");
  rig = reference_rig();
  rig.test->sampling_rate = 1000.0;
  EXPECT_EQ(message(rig),
            "test.sampling_rate = 1000; must be above 1116: twice harmonic 10 of the stuck "
            "resonance, 55.8 Hz. Slower sampling would alias the high harmonics.");
  rig = reference_rig();
  rig.test->duration = 0.05;
  EXPECT_EQ(message(rig),
            "test.duration = 0.05; must be at least 0.0538: 3 cycles of the stuck resonance, 55.8 "
            "Hz. Record longer, or check the units of the beam.");
  rig = reference_rig();
  rig.test->frequency_resolution = 1000.0;
  EXPECT_EQ(message(rig),
            "test.frequency_resolution = 1000; must be at most 0.558: 1 % of the stuck "
            "resonance, 55.8 Hz. A coarser drive would not be at resonance.");
  rig = reference_rig();
  EXPECT_EQ(message(rig, {.controlled_harmonics = 1}),
            "controlled_harmonics = 1; must be from 2 to 100");
  EXPECT_EQ(message(rig, {.force_distortion = 0.0}), "force_distortion = 0; must be above 0");
}

// The stuck resonance of 55.79 Hz needs 1115.8 Hz; the drive is at 56 Hz.
TEST(VirtualMeasurement, SamplesFastEnoughForItsDrives) {
  Rig rig = rig_of_levels(0.1, 0.2, 2);
  rig.test->frequency_resolution = 0.5;
  rig.test->sampling_rate = 1119.0;
  EXPECT_EQ(message(rig),
            "test.sampling_rate = 1119; must be above 1120: twice harmonic 10 of the drive of "
            "level 1, 56.0 Hz. Slower sampling would alias the high harmonics.");
}

TEST(VirtualMeasurement, CanBeCancelled) {
  VirtualMeasurementOptions options;
  options.progress = [](std::size_t done, std::size_t) { return done < 2; };
  EXPECT_THROW((void)measure_virtually(rig_of_levels(1.0, 5.0, 5), reference_joint(), options),
               Cancelled);
}

}  // namespace
}  // namespace microslip::virtual_measurement_test
