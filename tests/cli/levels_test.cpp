// SPDX-License-Identifier: MIT
// `levels` of force–displacement records.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/secant.hpp"
#include "support/force_records.hpp"

namespace microslip::cli_test::levels_test {
namespace {

/// Sines of rising amplitude, so many cycles of each, of 100 samples.
ForceRecord sample_loops(int cycles, const std::vector<double>& amplitudes,
                         const testing::RecordNoise& noise = {}) {
  std::vector<double> path;
  for (const double a : amplitudes) {
    for (int i = 0; i < 100 * cycles; ++i)
      path.push_back(a * std::sin(0.02 * std::numbers::pi * i));
  }
  return testing::simulated_record(sample_joint(), path, 3, noise);
}

const std::vector<double> kAmplitudes{3e-5, 6e-5, 1e-4, 1.4e-4, 1.8e-4, 2.2e-4};
const Arguments kLevels{"levels", "loops.csv", "--out", "levels.csv"};

Sandbox sandbox() { return Sandbox{{"loops.csv", record_text(sample_loops(5, kAmplitudes))}}; }

TEST(levels, WritesTheCyclesOfLoops) {
  const Sandbox box = sandbox();
  const Outcome done = expect_done(box, kLevels);
  for (const char* part : {"loops.csv", "cycles", "dissipation", "noise per sample"}) {
    EXPECT_NE(done.out.find(part), std::string::npos) << part << " in\n" << done.out;
  }
  const CsvTable table(box.get("levels.csv"), "levels.csv");
  const std::vector<double> amplitude = table.numbers("amplitude", kLength);
  const std::vector<double> lost = table.numbers("dissipation", kEnergy);
  const std::vector<double> lost_std = table.numbers("dissipation_std", kEnergy);
  const std::vector<double> stiffness = table.numbers("secant_stiffness", kStiffness);
  const std::vector<double> stiffness_std = table.numbers("secant_stiffness_std", kStiffness);
  const std::vector<double> begin = table.numbers("start_time", kTime);
  const std::vector<double> end = table.numbers("end_time", kTime);
  ASSERT_GE(amplitude.size(), 23U);  // the first of each amplitude but one begins at another
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    // Four deviations, and 7e-4 of chords of 100 samples.
    EXPECT_NEAR(lost[i], dissipation(sample_joint(), amplitude[i]),
                4 * lost_std[i] + 1e-3 * lost[i]);
    EXPECT_NEAR(stiffness[i], secant_stiffness(sample_joint(), amplitude[i]), 4 * stiffness_std[i]);
    EXPECT_NEAR(end[i] - begin[i], 0.1, 0.005);
  }
}

// What it writes is what identify takes.
TEST(levels, AreThoseThatIdentifyTakes) {
  const Sandbox box = sandbox();
  expect_done(box, kLevels);
  expect_done(box, {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "joint.json"});
  const Joint found = read_joint(box.file("joint.json")).joint;
  for (const double a : kAmplitudes) {
    EXPECT_NEAR(dissipation(found, a) / dissipation(sample_joint(), a), 1.0, 0.02) << a;
  }
  const auto file = nlohmann::json::parse(box.get("joint.json")).at("identification");
  EXPECT_TRUE(file.at("warnings").empty()) << file.at("warnings");
}

TEST(levels, TakeSeveralRecordsAndStandardOutput) {
  const Sandbox box = sandbox();
  box.put("other.csv", record_text(sample_loops(4, {2e-4})));
  expect_done(box, {"levels", "loops.csv", "other.csv", "--out", "both.csv"});
  const CsvTable table(box.get("both.csv"), "both.csv");
  const std::vector<std::string> source = table.text("source");
  EXPECT_EQ(source.front(), "loops.csv");
  EXPECT_EQ(source.back(), "other.csv");
  const Outcome printed = box.run({"levels", "loops.csv", "--out", "-"});
  EXPECT_NE(printed.out.find("amplitude [m]"), std::string::npos);
  EXPECT_NE(printed.err.find("Levels of closed cycles"), std::string::npos);
}

TEST(levels, SayWhatTheyLeaveOutInTheFile) {
  const Sandbox box;
  box.put("loops.csv", record_text(sample_loops(5, {1e-6, 2e-4})));
  const Outcome done = expect_done(box, with(kLevels, {"--quiet"}));
  EXPECT_EQ(done.out, "");
  EXPECT_NE(box.get("levels.csv").find("# warning: cycles_in_noise: "), std::string::npos);

  ForceRecord drifting = sample_loops(5, {2e-4}, {0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < drifting.size(); ++i)
    drifting.force[i] += 0.02 * static_cast<double>(i);
  box.put("loops.csv", record_text(drifting));
  expect_done(box, kLevels);
  EXPECT_NE(box.get("levels.csv").find("# warning: not_closed: "), std::string::npos);
}

TEST(levels, RefuseWhatHasNoCycles) {
  const Sandbox box;
  std::vector<double> path;
  for (int i = 0; i < 300; ++i) path.push_back(1e-6 * i * std::sin(0.02 * i * (1.0 + 0.004 * i)));
  box.put("loops.csv", record_text(testing::simulated_record(sample_joint(), path, 1)));
  expect_refused(box, kLevels, {"loops.csv", "closed cycles is none"});

  ForceRecord swapped = sample_loops(5, {2e-4});
  for (double& value : swapped.force) value = -value;
  box.put("loops.csv", record_text(swapped));
  expect_refused(box, kLevels, {"loops.csv", "work over the record", "sign"});

  box.put("loops.csv", record_text(sample_loops(5, {2e-4}), "time [s],u [um],f [um]"));
  expect_refused(box, kLevels, {"loops.csv", "channel of", "--force"});
  expect_refused(box, with(kLevels, {"--force", "u"}), {"loops.csv"});
  expect_refused(box, {"levels", "missing.csv", "--out", "l.csv"}, {"missing.csv"});
}

}  // namespace
}  // namespace microslip::cli_test::levels_test
