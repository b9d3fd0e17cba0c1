// SPDX-License-Identifier: MIT
#include "microslip/documents/response/virtual_measurement_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"

namespace microslip::virtual_measurement_file_test {
namespace {

VirtualLevel level_of(std::size_t number) {
  VirtualLevel level;
  level.number = number;
  level.response = 10.0;
  level.frequency = 55.5;
  level.resonance_frequency = 55.46;
  level.controlled.force = {0.0, 2.0, 0.006, {0.0, 0.008}};
  level.controlled.voltage = {0.0, {0.0, 3.0}, 0.1, 0.1};
  level.uncontrolled.force = {0.0, 2.0, 0.0, 0.1};
  level.uncontrolled.voltage = {0.0, 4.0, 0.0, 0.0};
  for (DrivenVibration* driven : {&level.controlled, &level.uncontrolled}) {
    driven->vibration.force_amplitude = 2.0;
    driven->vibration.response = 10.0;
    JointCycle& cycle = driven->vibration.joints.emplace_back();
    cycle.displacement = {-1e-6, 1e-4};
    cycle.amplitude = 1e-4;
    cycle.dissipation = 3e-4;
    cycle.reversals = 2;
  }
  level.warnings = {{std::string(kMacroSlip), "all slips"}};
  level.summary.stop = Stop::kConverged;
  return level;
}

/// The second of three is not found.
std::vector<VirtualLevel> levels() {
  std::vector<VirtualLevel> levels{level_of(1), level_of(2), level_of(3)};
  levels[1].summary.stop = Stop::kNoProgress;
  levels[1].summary.reason = "no resonance";
  return levels;
}

const std::vector<std::string> kSources{"a.csv", "b.csv", "c.csv"};

TEST(VirtualMeasurementFile, TruthIsATableOfLevels) {
  const Joint joint = testing::reference_joint();
  const std::string text = truth_table(levels(), joint, kSources).str();
  const LevelsFile file = parse_levels(text, "truth.csv");
  EXPECT_EQ(file.levels.amplitude, (std::vector<double>{1e-4, 1e-4}));
  EXPECT_EQ(file.levels.dissipation, (std::vector<double>{3e-4, 3e-4}));
  EXPECT_EQ(file.levels.secant_stiffness[0], secant_stiffness(joint, 1e-4));
  const CsvTable table(text, "truth.csv");
  EXPECT_EQ(table.numbers("frequency", kFrequency)[0], 55.5);
  EXPECT_EQ(table.numbers("resonance_frequency", kFrequency)[0], 55.46);
  EXPECT_EQ(table.numbers("mean_displacement", kLength)[0], -1e-6);
  // √(0.006² + 0.008²)/2
  EXPECT_NEAR(table.numbers("force_distortion", kDimensionless)[0], 0.005, 1e-15);
  EXPECT_NE(text.find("# not found: level 2, 10 m/s^2: no resonance"), std::string::npos);
  EXPECT_NE(text.find("c.csv"), std::string::npos);
  EXPECT_EQ(text.find("b.csv"), std::string::npos);
  EXPECT_NE(text.find("macro_slip"), std::string::npos);
}

TEST(VirtualMeasurementFile, TellsWhatTheControlDid) {
  const CsvTable table(force_control_table(levels(), 5).str(), "force_control.csv");
  EXPECT_EQ(table.numbers("level", kDimensionless), (std::vector<double>{1.0, 3.0}));
  for (const CsvColumn& column : table.columns()) {  // volts have no unit here
    EXPECT_EQ(column.name.find("voltage"), std::string::npos);
  }
  EXPECT_EQ(table.numbers("before_3", kDimensionless)[0], 0.05);
  EXPECT_EQ(table.numbers("after_3", kDimensionless)[0], 0.004);
  EXPECT_EQ(table.numbers("after_5", kDimensionless)[0], 0.0);
}

TEST(VirtualMeasurementFile, RefusesWhatItCannotWrite) {
  const Joint joint = testing::reference_joint();
  const std::vector<std::string> two{"a.csv", "b.csv"};
  EXPECT_THROW((void)truth_table(levels(), joint, two), InputError);
  std::vector<VirtualLevel> none = levels();
  for (VirtualLevel& level : none) level.summary.stop = Stop::kNoProgress;
  EXPECT_THROW((void)truth_table(none, joint, kSources), InputError);
  EXPECT_THROW((void)force_control_table(none, 10), InputError);
  std::vector<VirtualLevel> pure = levels();
  for (VirtualLevel& level : pure) level.uncontrolled = {};
  EXPECT_THROW((void)force_control_table(pure, 10), InputError);
}

}  // namespace
}  // namespace microslip::virtual_measurement_file_test
