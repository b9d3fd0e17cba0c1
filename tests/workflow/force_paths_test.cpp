// SPDX-License-Identifier: MIT
// Records beside the joint that was identified from them.

#include "microslip/workflow/results/force_paths.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/observe/record_force.hpp"
#include "microslip/observe/sensor_drift.hpp"
#include "microslip/workflow/identify/records_identification.hpp"
#include "support/force_records.hpp"
#include "support/messages.hpp"

namespace microslip::force_paths_test {
namespace {

constexpr double kReach = 2.4e-4;  // m
constexpr double kStep = 1e-3;     // s

Joint known_joint() {
  return {1.7e5, SlipDensity({UniformPart{.from = 0.0, .to = 60.0, .weight = 0.8}})};
}

/// Two recordings, and the joint.json of both.
class Identified : public ::testing::Test {
 protected:
  Identified() {
    write("a.csv", recorded(1));
    write("b.csv", recorded(2));
    RecordsIdentification options{.records = {folder.file("a.csv"), folder.file("b.csv")}};
    options.options.draws = 100;
    text = joint_text(options, identify_records(options), "identify");
    file = parse_joint(text, "joint.json");
  }

  /// A record of the known joint. @param motion  seed of the path.
  static ForceRecord recorded(std::uint64_t motion) {
    const std::vector<double> path = testing::random_motion(3000, kReach, motion);
    return testing::simulated_record(known_joint(), path, 5, {}, kStep);
  }

  void write(const std::string& name, const ForceRecord& record) const {
    std::string csv = "time [s],u [um],f [N]\n";
    for (std::size_t i = 0; i < record.size(); ++i) {
      csv += fmt::format("{:.6f},{:.9g},{:.9g}\n", kStep * static_cast<double>(i),
                         1e6 * record.displacement[i], record.force[i]);
    }
    write_file(folder.file(name), csv);
  }

  [[nodiscard]] ForcePaths read(const std::vector<std::size_t>& records) const {
    return read_force_paths(file, folder.file("."), records);
  }

  test::TemporaryFolder folder;
  std::string text;
  JointFile file{known_joint(), {}, {}};
};

TEST_F(Identified, SaysWhatTheReportNeeds) {
  const IdentifiedJoint joint = identified_joint_of(file, "joint.json");
  const std::optional<FoundByRecords>& found = joint.by_records;
  ASSERT_TRUE(found);
  ASSERT_EQ(found->records.size(), 2U);
  ASSERT_TRUE(found->stiffness);
  EXPECT_LT(found->stiffness->lower, found->stiffness->value);
  EXPECT_GT(found->stiffness->upper, found->stiffness->value);
  EXPECT_FALSE(found->viscous);
  EXPECT_EQ(joint.band_samples, 100.0);
  for (const RecordFound& record : found->records) {
    EXPECT_EQ(record.verdicts.size(), kRecordDepartures.size());
    EXPECT_EQ(record.start, "virgin");
    EXPECT_EQ(record.start_from, "shown");
    ASSERT_EQ(record.offset.size(), 1U);
    // The record has an offset of 2 % of its largest force, some 30 N.
    EXPECT_NEAR(record.offset[0], 0.02 * 30.0, 0.02);
  }
  EXPECT_EQ(found->records[1].source, folder.file("b.csv"));
}

// What the identification says is left must be left by the force that is drawn: of rows of samples
// it is, by their number, less.
TEST_F(Identified, LeavesTheResidualThatTheIdentificationHad) {
  const ForcePaths found = read({0, 1});
  ASSERT_EQ(found.paths.size(), 2U);
  EXPECT_TRUE(found.warnings.empty());
  ASSERT_EQ(found.files.size(), 2U);
  EXPECT_EQ(found.files[1].name, "b.csv");
  const double scatter = identified_joint_of(file, "").by_records->records[0].scatter;
  const ForcePath& path = found.paths[0];
  EXPECT_EQ(path.source, "a.csv");
  double square = 0.0;
  for (std::size_t i = 0; i < path.force.size(); ++i) {
    square += std::pow(path.force[i] - path.found[i], 2);
  }
  // 3000 samples tell their deviation to 1.3 %; four of that.
  EXPECT_NEAR(std::sqrt(square / 3000.0) / scatter, 1.0, 0.06);
  EXPECT_NEAR(path.displacement_noise / (2e-4 * kReach), 1.0, 0.1);
}

// A displacement that drifts by a tenth of its range: found, in the file, and off the path that is
// drawn.
TEST_F(Identified, TakesOffTheDriftThatTheIdentificationTookOff) {
  const double drift = 0.2 * kReach;
  const ForceRecord drifting = without_drift(recorded(1), {.displacement = {-drift}});
  write("d.csv", drifting);
  RecordsIdentification options;
  options.records = {folder.file("d.csv")};
  options.fit_drift = true;
  options.options.draws = 100;
  file = parse_joint(joint_text(options, identify_records(options), "identify"), "joint.json");
  const RecordFound record = identified_joint_of(file, "").by_records->records[0];
  EXPECT_TRUE(record.force_drift.empty());
  EXPECT_NEAR(drift_at(record.displacement_drift, 1.0), drift, 0.1 * drift);
  const ForcePaths found = read({0});
  ASSERT_EQ(found.paths.size(), 1U);
  EXPECT_NEAR(unexplained_share(found.paths[0].force, found.paths[0].found) / record.unexplained,
              1.0, 0.1);
  EXPECT_NEAR(found.paths[0].displacement.back(),
              drifting.displacement.back() - drift_at(record.displacement_drift, 1.0),
              1e-9 * kReach);
}

// Wear of a fifth of the force, with a drift given as found beside it.
TEST_F(Identified, DoubtsADriftOfARecordOfNoMasingJoint) {
  ForceRecord worn = recorded(1);
  for (std::size_t i = 0; i < worn.size(); ++i) {
    worn.force[i] *= 1.0 - 0.2 * static_cast<double>(i) / static_cast<double>(worn.size());
  }
  write("w.csv", worn);
  RecordsIdentification options;
  options.records = {folder.file("w.csv")};
  options.options.draws = 100;
  IdentifiedRecords done = identify_records(options);
  EXPECT_TRUE(drift_warnings(done).empty());
  done.from.drift.front() = DriftFit{.drift = {.displacement = {0.1 * kReach}}};
  const std::vector<Warning> warnings = drift_warnings(done);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "drift_uncertain");
}

TEST_F(Identified, FindsRecordsByTheirContent) {
  std::filesystem::create_directory(folder.file("recordings"));
  std::filesystem::rename(folder.file("a.csv"), folder.file("recordings/a.csv"));
  const ForcePaths moved = read({0});
  ASSERT_EQ(moved.files.size(), 1U);
  EXPECT_EQ(moved.files[0].name, "recordings/a.csv");

  std::filesystem::remove(folder.file("b.csv"));
  write("b.csv", {std::vector<double>(20, 0.0), std::vector<double>(20, 1.0), kStep});
  const ForcePaths changed = read({0, 1});
  EXPECT_EQ(changed.paths.size(), 1U);
  ASSERT_EQ(changed.warnings.size(), 1U);
  EXPECT_EQ(changed.warnings[0].code, "record_changed");

  std::filesystem::remove(folder.file("b.csv"));
  const ForcePaths missing = read({1});
  ASSERT_EQ(missing.warnings.size(), 1U);
  EXPECT_EQ(missing.warnings[0].code, "record_missing");
  EXPECT_NE(missing.warnings[0].text.find("b.csv"), std::string::npos);
}

TEST_F(Identified, NamesTheKeyThatDoesNotFit) {
  const auto fault = [&](const std::string& key, const NamedValue& value) {
    JointFile broken = file;
    for (auto& [name, old] : broken.identification) {
      if (name == key) old = value;
    }
    return test::message_or("no error", [&] { (void)identified_joint_of(broken, "j.json"); });
  };
  for (const std::string key : {"correlation", "unexplained", "verdict_share", "verdict_noise",
                                "offset_record", "band_stiffness_N_per_m"}) {
    const std::string message = fault(key, std::vector<double>{1.0});
    EXPECT_NE(message.find("j.json: identification." + key), std::string::npos) << message;
  }
  std::size_t verdicts = 0;
  for (const auto& [name, value] : file.identification) {
    if (name == "verdict_record") verdicts = std::get<std::vector<double>>(value).size();
  }
  const std::string message = fault("verdict_record", std::vector<double>(verdicts, 3.0));
  EXPECT_NE(message.find("from 1 to the 2"), std::string::npos) << message;
}

}  // namespace
}  // namespace microslip::force_paths_test
