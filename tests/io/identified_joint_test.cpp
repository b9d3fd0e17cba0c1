// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/identified_joint.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "microslip/documents/study/calibration_summary.hpp"
#include "support/messages.hpp"

namespace microslip::identified_joint_test {
namespace {

Joint half_slips() { return {1e5, SlipDensity({UniformPart{0.0, 10.0, 0.5}})}; }

IdentifiedJoint with_band(const std::string& method) {
  return {.joint = half_slips(),
          .method = method,
          .status = "converged",
          .covered_from = 2.0,
          .covered_to = 9.0,
          .warnings = {"few_levels", "noisy"},
          .warning_texts = {"Of 5 levels.", "D scatters by \"9 %\"."},
          .band_confidence = 0.9,
          .band_samples = 300.0,
          .band_slip_force = {0.0, 5.0, 10.0},
          .band_lower = {0.01, 0.02, 0.0},
          .band_upper = {0.09, 0.08, 0.07}};
}

/// Everything that levels can tell.
IdentifiedJoint of_levels() {
  IdentifiedJoint joint = with_band("inversion");
  joint.model = "power_law";
  joint.linear_damping = 12.5;
  joint.verdicts = {{"order_dependent", 0.03, 0.01, true}, {"frequency_rises", 0.0, 0.002, false}};
  joint.scatter = 1.5;
  joint.scatter_is_relative = false;
  joint.secant_scatter = 0.4;
  joint.scatter_of_all = 1.1;
  joint.lambda = 3e-4;
  joint.degrees_of_freedom = 4.5;
  joint.smoothing_trend = -1.0;
  joint.inner_not_converged = 2.0;
  joint.path = SmoothingPath{{1.0, 2.0}, {5.0, 3.0}, {0.1, 0.2}, {0.02, 0.03}};
  joint.edges = {4.0};
  joint.parameters = {{"exponent", -0.5, 0.01}, {"coefficient", 0.3, {}}, {"to", 8.0, 0.0}};
  joint.covariance = {1.0, 0.0, 0.0, 1.0};
  joint.misfit = 0.02;
  joint.secant = StiffnessFound{500.0, 40.0};
  joint.frequencies = FrequenciesFound{1e-4, 2e-4, 0.2, 0.05, 7.0};
  joint.level_bands = LevelBandsFound{120.0, {0.4, 0.6}, {{10.0, 15.0}}, {{0.0, 0.1}}};
  return joint;
}

IdentifiedJoint of_records() {
  IdentifiedJoint joint = with_band("inversion");
  FoundByRecords& found = joint.by_records.emplace();
  found.stiffness = {1e5, 0.9e5, 1.1e5};
  found.elastic = {5e4, 4e4, 6e4};
  found.viscous = {3.0, 2.0, 4.0};
  found.reference_exponent = -0.5;
  found.records = {{"a.csv",
                    1.0,
                    "virgin",
                    "shown",
                    0.1,
                    0.2,
                    0.01,
                    {0.5},
                    {1e-6, 2e-6},
                    {3.0},
                    {{"other", 1, 2, true}}},
                   {"b.csv", 1.0, "unknown", "given", 0.3, 0.4, 0.02, {0.6, 0.7}, {}, {-1.0}, {}}};
  found.tables = {{0.02, true, {{"dissipation", 0.1, 0.2, false}}}, {1.5, false, {}}};
  return joint;
}

IdentifiedJoint of_assemblies(bool mean) {
  IdentifiedJoint joint = with_band(std::string(kAssembliesMethod));
  FoundOfAssemblies& found = joint.of_assemblies.emplace();
  found.stiffness_from = "common";
  if (mean) {
    found.names = {"old", "new"};
    found.stiffness_spread = {0.1, 0.05, 0.2};
    found.slip_force_spread = {0.2, 0.1, 0.3};
    found.shape_spread = {0.3, 0.2, 0.4};
    found.spread_prior_from = 0.01;
    found.spread_prior_to = 0.3;
    found.effective_draws = 90.0;
    joint.scatter = 0.02;
  } else {
    found.name = "old";
    found.stiffness = {1e5, 0.9e5, 1.1e5};
    found.slip_force_scale = {1.1, 1.0, 1.2};
    found.shape = {0.1, 0.0, 0.2};
  }
  return joint;
}

IdentifiedJoint of_calibration() {
  IdentifiedJoint joint = with_band(std::string(kCalibrationMethod));
  joint.degrees_of_freedom = 3.5;
  joint.edges = {6.0};
  joint.by_calibration = FoundByCalibration{
      8.0, {1e5, 0.9e5, 1.1e5}, {5e4, 4e4, 6e4}, {0.1, 0.9, 0.2}, -0.5, {0.4}, 3.0};
  return joint;
}

std::vector<IdentifiedJoint> all() {
  return {of_levels(), of_records(), of_assemblies(true), of_assemblies(false), of_calibration()};
}

// A member that only the writer or only the reader knows would be lost on the way.
TEST(IdentifiedJoint, ReadsBackWhatItWrites) {
  for (const IdentifiedJoint& joint : all()) {
    const JointFile file = joint_file_of(joint, {});
    const JointFile again = joint_file_of(identified_joint_of(file, "j.json"), {});
    EXPECT_EQ(again.identification, file.identification) << joint.method;
    const JointFile parsed = parse_joint(format_joint(file), "j.json");
    EXPECT_EQ(parsed.identification, file.identification) << joint.method;
  }
}

TEST(IdentifiedJoint, HasEachMemberInItsPlace) {
  const IdentifiedJoint levels = identified_joint_of(joint_file_of(of_levels(), {}), "");
  EXPECT_EQ(levels.found_by(), "power_law");
  EXPECT_EQ(levels.scatter, 1.5);
  EXPECT_FALSE(levels.scatter_is_relative);
  ASSERT_EQ(levels.parameters.size(), 3U);
  EXPECT_EQ(levels.parameters[2].name, "to");
  EXPECT_EQ(levels.parameters[2].error, 0.0);
  ASSERT_EQ(levels.verdicts.size(), 2U);
  EXPECT_TRUE(levels.verdicts[0].broken);
  const IdentifiedJoint joint = identified_joint_of(joint_file_of(of_records(), {}), "");
  const FoundByRecords& found = joint.by_records.value();
  EXPECT_EQ(found.viscous.value().upper, 4.0);
  ASSERT_EQ(found.records.size(), 2U);
  EXPECT_EQ(found.records[1].offset, (std::vector<double>{0.6, 0.7}));
  ASSERT_EQ(found.records[0].verdicts.size(), 1U);
  EXPECT_EQ(found.records[0].verdicts[0].departure, "other");
  EXPECT_TRUE(found.records[1].verdicts.empty());
  EXPECT_EQ(found.tables.at(0).verdicts.at(0).noise, 0.2);
  const IdentifiedJoint calibrated = identified_joint_of(joint_file_of(of_calibration(), {}), "");
  EXPECT_EQ(calibrated.by_calibration.value().variance_reduction,
            (std::vector<double>{0.1, 0.9, 0.2}));
}

// Joints of others and of earlier versions say little or nothing.
TEST(IdentifiedJoint, TakesWhatIsMissingAsNotKnown) {
  const IdentifiedJoint joint = identified_joint_of({half_slips(), {}, {}}, "j.json");
  EXPECT_TRUE(joint.method.empty());
  EXPECT_EQ(joint.status, kStatusNotTold);
  EXPECT_EQ(joint.covered_to, std::nullopt);
  EXPECT_EQ(joint.band_confidence, 0.95);
  const IdentifiedJoint other = identified_joint_of(
      {half_slips(), {}, {{"scatter", 0.5}, {"status", 3.0}, {"scatter_force_N", 1.0}}}, "j.json");
  EXPECT_EQ(other.scatter, 0.5);
  EXPECT_EQ(other.status, kStatusNotTold);
  EXPECT_FALSE(other.by_records);
}

TEST(IdentifiedJoint, NamesTheKeyThatDoesNotFit) {
  const auto refuse = [](const IdentifiedJoint& joint, const std::string& key,
                         const NamedValue& value, const std::string& expected) {
    JointFile file = joint_file_of(joint, {});
    for (auto& [name, old] : file.identification) {
      if (name == key) old = value;
    }
    const std::string message =
        test::message_or("no error", [&] { (void)identified_joint_of(file, "j.json"); });
    EXPECT_NE(message.find("j.json: identification." + key), std::string::npos) << message;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  };
  using Numbers = std::vector<double>;
  refuse(of_levels(), "band_upper_per_N", Numbers{}, "0 numbers; must be 3");
  refuse(of_levels(), "band_upper_per_N", Numbers{1, 0, 1}, "must be at least band_lower_per_N");
  refuse(of_levels(), "path_gcv", Numbers{1}, "must be 2");
  refuse(of_levels(), "verdict", list_of_texts({"held"}), "1 texts; must be 2");
  refuse(of_records(), "band_viscous_N_s_per_m", Numbers{1}, "must be 2");
  refuse(of_records(), "verdict_record", Numbers{3}, "from 1 to the 2 records");
  refuse(of_records(), "offset_record", Numbers{1, 2, 1.5}, "from 1 to the 2 records");
  refuse(of_records(), "levels_verdict_table", Numbers{0}, "from 1 to the 2 tables");
  refuse(of_calibration(), "told", Numbers{1}, "must be 3");
}

CalibrationSummary calibration() {
  return {.status = "converged",
          .levels = 7,
          .levels_found = 6,
          .confidence = 0.9,
          .scatter = 1.2,
          .scatter_is_relative = false,
          .frequency_scatter = 1e-5,
          .joints = {{"lap", 1e5, 0.9e5, 1.1e5, 0.5, 3.5, 0.8, 2.0, 1.0, 9.0},
                     {"foot", 2e5, 1.9e5, 2.1e5, 0.4, 2.5, 0.7, 0.0, 2.0, 8.0}},
          .edges_sought = true,
          .edges = {{"lap", 5.0, 0.1}},
          .offsets = {{1, 2e-3}},
          .pairs = {{"lap", "foot", -0.8, 0.3, 0.1, true}},
          .known_in_sum = {"lap", "foot", "rib"},
          .warnings = {{"few_levels", "Of 7 levels."}}};
}

TEST(CalibrationSummary, ReadsBackWhatItWrites) {
  const CalibrationFile file = calibration_file_of(calibration(), {});
  const CalibrationSummary read = calibration_summary_of(file, "c.json");
  EXPECT_EQ(calibration_file_of(read, {}).calibration, file.calibration);
  EXPECT_EQ(read.offsets.at(0).mode, 1U);
  EXPECT_TRUE(read.pairs.at(0).known_only_together);
  EXPECT_EQ(read.joints.at(1).covered_to, 8.0);
}

TEST(CalibrationSummary, NamesTheKeyThatIsMissing) {
  for (const std::string key :
       {"status", "levels", "scatter_of", "pair_verdict", "stiffness_N_per_m", "warning_texts"}) {
    CalibrationFile file = calibration_file_of(calibration(), {});
    std::erase_if(file.calibration, [&](const auto& entry) { return entry.first == key; });
    const std::string message =
        test::message_or("no error", [&] { (void)calibration_summary_of(file, "c.json"); });
    EXPECT_NE(message.find("c.json: calibration." + key), std::string::npos) << message;
    EXPECT_NE(message.find("microslip calibrate"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace microslip::identified_joint_test
