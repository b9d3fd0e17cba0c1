// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/effort.hpp"

namespace microslip::cli_test::measure_test {
namespace {

const std::string kExample = MICROSLIP_EXAMPLES "/reference_rig/";

/// The text with the first `before` in it replaced.
std::string edited(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

/// The reference rig with so many levels.
std::string rig_text(std::size_t levels) {
  return edited(test::get(kExample + "rig.toml"), "count = 90",
                "count = " + std::to_string(levels));
}

/// A rig of four levels and its joint, as a user has them in a folder.
Sandbox sandbox(const std::string& rig = rig_text(4)) {
  return Sandbox{{"rig.toml", rig}, {"joint.json", test::get(kExample + "joint.json")}};
}

CsvTable table(const Sandbox& box, const std::string& name) {
  return CsvTable(box.get(name), name);
}

std::vector<std::string> records(const std::string& ending) {
  std::vector<std::string> names;
  for (int i = 1; i <= 4; ++i) names.push_back("test/level_0" + std::to_string(i) + ending);
  return names;
}

/// Reduces the records by the rig beside them and expects the truth of A and D; the lowest level is
/// next to the noise.
void expect_truth(const Sandbox& box, const std::string& ending) {
  Arguments call{"reduce", "test/rig.toml"};
  for (const std::string& name : records(ending)) call.push_back(name);
  call.insert(call.end(), {"--out", "levels.csv", "--quiet"});
  expect_done(box, call);
  const CsvTable found = table(box, "levels.csv");
  const CsvTable truth = table(box, "test/truth.csv");
  for (const auto& [column, dimension, tolerance] :
       {std::tuple{"amplitude", kLength, 1e-3}, std::tuple{"dissipation", kEnergy, 5e-3},
        std::tuple{"linear_dissipation", kEnergy, 5e-3},
        std::tuple{"secant_stiffness", kStiffness, 0.02}}) {
    const std::vector<double> is = found.numbers(column, dimension);
    const std::vector<double> should = truth.numbers(column, dimension);
    ASSERT_EQ(is.size(), 4U);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(is[i], should[i], tolerance * should[i]);
  }
}

TEST(measure, WritesRecordsThatReduceToTheTruth) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, {"measure", "rig.toml", "--out", "test"});
  for (const char* part : {"4 of 4, 0.294 to 39.24 m/s^2", "55.8 to 54.5 Hz", "before control",
                           "level_01.csv to level_04.csv"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
  }
  for (const std::string& name : records(".csv")) EXPECT_TRUE(box.has(name)) << name;
  expect_truth(box, ".csv");
  // The rig beside the records does not know the joint.
  EXPECT_EQ(box.get("test/rig.toml").find("joint.json\""), std::string::npos);
  EXPECT_NE(box.get("test/rig.toml").find("measure rig.toml --out test"), std::string::npos);
  EXPECT_NE(box.get("test/truth.csv").find("# sha256[rig.toml] = "), std::string::npos);
  EXPECT_NE(box.get("test/truth.csv").find("# sha256[joint.json] = "), std::string::npos);
}

TEST(measure, WritesWhatTheForceControlDid) {
  const Sandbox box = sandbox();
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--before-control", "--quiet"});
  const CsvTable control = table(box, "test/force_control.csv");
  EXPECT_GT(control.numbers("before_3", kDimensionless).back(), 0.03);
  for (int n = 2; n <= 10; ++n) {
    for (const double share : control.numbers("after_" + std::to_string(n), kDimensionless)) {
      EXPECT_LE(share, 0.003);
    }
  }
  // The records before it have a distorted force, which the reduction tells.
  expect_done(box, {"reduce", "test/rig.toml", "test/before_control_04.csv", "--out", "before.csv",
                    "--quiet"});
  EXPECT_NEAR(table(box, "before.csv").numbers("force_distortion", kDimensionless)[0],
              control.numbers("before_3", kDimensionless).back(), 2e-3);
  EXPECT_NE(box.get("before.csv").find("force_distortion"), std::string::npos);
}

TEST(measure, WritesEveryFormat) {
  for (const std::string format : {"uff", "uff-ascii", "mat", "h5"}) {
    // The tests of io write and read the others, too.
    if ((format == "uff-ascii" || format == "mat") && !test::in_studies()) continue;
    const Sandbox box = sandbox();
    expect_done(box, {"measure", "rig.toml", "--out", "test", "--format", format, "--quiet"});
    expect_truth(box, format == "uff-ascii" ? ".uff" : "." + format);
  }
}

TEST(measure, IsTheSameForItsSeed) {
  const Sandbox box = sandbox();
  const Arguments call{"measure", "rig.toml", "--out", "test", "--quiet"};
  expect_done(box, call);
  const auto first = box.content();
  expect_done(box, call);
  EXPECT_TRUE(box.content() == first);
  const std::string record = box.get("test/level_03.csv");
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--seed", "2", "--quiet"});
  EXPECT_NE(box.get("test/level_03.csv"), record);
}

TEST(measure, DrivesByAPureForce) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, {"measure", "rig.toml", "--out", "test", "--no-shaker"});
  EXPECT_NE(run.out.find("a pure force"), std::string::npos);
  EXPECT_FALSE(box.has("test/force_control.csv"));
  for (const double distortion :
       table(box, "test/truth.csv").numbers("force_distortion", kDimensionless)) {
    EXPECT_EQ(distortion, 0.0);
  }
}

// A rig in the folder itself is the user's own.
TEST(measure, LeavesTheRigInItsFolder) {
  const Sandbox box = sandbox();
  expect_done(box, {"measure", "rig.toml", "--out", ".", "--quiet"});
  EXPECT_EQ(box.get("rig.toml"), rig_text(4));
  EXPECT_TRUE(box.has("level_04.csv"));
}

TEST(measure, NamesWhatIsWrong) {
  const Arguments call{"measure", "rig.toml", "--out", "test"};
  const std::string rig = rig_text(4);
  const auto refused = [&](const std::string& before, const std::string& after,
                           const std::vector<std::string>& parts) {
    expect_refused(sandbox(edited(rig, before, after)), call, parts);
  };
  refused("joint = \"joint.json\"", "", {"contact.joint", "must name the file of the true joint"});
  refused("\"joint.json\"", "\"none.json\"", {"contact.joint = ", "none.json"});
  refused("harmonics = 9", "harmonics = 0", {"test.harmonics = 0; must be from 1 to 100"});
  refused("count = 4", "count = 0", {"test.response_acceleration.count = 0"});
  refused("8192.0", "1000.0", {"rig.toml: test.sampling_rate_Hz = 1000; must be above 1116"});
  refused("duration_s = 1.0", "duration_s = 0.02", {"test.duration_s = 0.02; must be at least"});
  const std::size_t test = rig.find("[test]");
  expect_refused(sandbox(rig.substr(0, test)), call, {"rig.toml: test = none", "Add a test"});
  expect_refused(sandbox(), {"measure", "none.toml", "--out", "test"}, {"none.toml"});
  expect_refused(sandbox(), {"measure", "rig.toml", "--out", "joint.json"}, {"joint.json"});
  expect_refused(sandbox(), {"measure", "rig.toml", "--out", "-"},
                 {"--out = '-'; must be a folder"});
  expect_refused(sandbox(), {"measure", "rig.toml", "--out", "test", "--seed", "x"}, {"--seed"});
}

TEST(measure, DoesNotMixWithAnotherTest) {
  const Sandbox box = sandbox();
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--quiet"});
  box.put("rig.toml", rig_text(3));
  expect_refused(box, {"measure", "rig.toml", "--out", "test"},
                 {"must not contain level_04.csv, of another test"});
}

// Of another format, of the state before control, or of its force control.
TEST(measure, DoesNotMixWithOtherFilesOfAnotherTest) {
  for (const std::string name : {"level_01.uff", "before_control_02.csv", "force_control.csv"}) {
    const Sandbox box = sandbox();
    std::filesystem::create_directory(box.file("test"));
    box.put("test/" + name, "level,force_before,force_after\n1,1,1\n");
    expect_refused(box, {"measure", "rig.toml", "--out", "test", "--no-shaker"},
                   {"must not contain " + name + ", of another test"});
  }
}

// All is checked before the test is solved: at 2 to 4 km/s² nothing would be found.
TEST(measure, ReplacesOnlyFilesOfItsKinds) {
  const std::string rig = edited(rig_text(4), "from_m_per_s2 = 0.294, to_m_per_s2 = 39.24",
                                 "from_m_per_s2 = 2000, to_m_per_s2 = 4000");
  for (const std::string name : {"level_01.csv", "before_control_02.csv", "force_control.csv"}) {
    const Sandbox box = sandbox(rig);
    std::filesystem::create_directory(box.file("test"));
    box.put("test/" + name, "mine [m],yours [m]\n1,1\n");
    expect_refused(box, {"measure", "rig.toml", "--out", "test", "--before-control"},
                   {name, "exists and contains a table of 'mine, yours'"});
  }
}

// A rig by hand, or a recording of a laboratory, has the form of what a virtual test writes.
TEST(measure, ReplacesNothingThatItDidNotWrite) {
  const Sandbox box = sandbox();
  box.put("other.toml", rig_text(3));
  expect_refused(box, {"measure", "other.toml", "--out", "."},
                 {"must not contain rig.toml that is not of a virtual test"});
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--quiet"});
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--seed", "2", "--quiet"});
  std::filesystem::remove(box.file("test/truth.csv"));
  expect_refused(box, {"measure", "rig.toml", "--out", "test"},
                 {"must not contain level_01.csv that is not of a virtual test"});
}

// A recording of a laboratory that lies among those of a virtual test, before that is solved.
TEST(measure, ReplacesNoRecordingAmongItsOwn) {
  const std::string rig = edited(rig_text(4), "from_m_per_s2 = 0.294, to_m_per_s2 = 39.24",
                                 "from_m_per_s2 = 2000, to_m_per_s2 = 4000");
  const Sandbox box = sandbox();
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--quiet"});
  box.put("rig.toml", rig);
  const std::string record = box.get("test/level_01.csv");
  box.put("test/level_01.csv", record.substr(record.find('\n') + 1));
  expect_refused(box, {"measure", "rig.toml", "--out", "test"},
                 {"test/level_01.csv", "was not written by microslip"});
}

TEST(measure, WarnsOfAnotherStiffness) {
  const Sandbox box =
      sandbox(edited(rig_text(1), "stiffness_N_per_m = 1.7e5", "stiffness_N_per_m = 1.8e5"));
  const Outcome run = Running({"measure", "rig.toml", "--out", "test"}, box.path(), {}).wait();
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("with which its modes were computed"), std::string::npos) << run.err;
  for (const char* file : {"test/truth.csv", "test/force_control.csv", "test/rig.toml"}) {
    EXPECT_NE(box.get(file).find("\n# warning: stiffness_differs: "), std::string::npos) << file;
  }
}

TEST(measure, WritesNothingWhereNoLevelIsFound) {
  const Sandbox box = sandbox(edited(rig_text(4), "from_m_per_s2 = 0.294, to_m_per_s2 = 39.24",
                                     "from_m_per_s2 = 2000, to_m_per_s2 = 4000"));
  const auto before = box.content();
  const Outcome run = Running({"measure", "rig.toml", "--out", "test"}, box.path(), {}).wait();
  EXPECT_EQ(run.status, 3);
  for (const char* part : {"0 of 4 levels found", "no resonance", "nothing is written"}) {
    EXPECT_NE(run.err.find(part), std::string::npos) << part << " in\n" << run.err;
  }
  EXPECT_TRUE(box.content() == before);
}

// A level that is not found is not written: its record of an older test must not stay.
TEST(measure, LeavesNoOldRecordOfALevelThatIsNotFound) {
  const Sandbox box = sandbox(rig_text(8));
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--no-shaker", "--quiet"});
  box.put("rig.toml", edited(edited(rig_text(8), "from_m_per_s2 = 0.294, to_m_per_s2 = 39.24",
                                    "from_m_per_s2 = 30, to_m_per_s2 = 1e4"),
                             "linear", "log"));
  expect_refused(box, {"measure", "rig.toml", "--out", "test", "--no-shaker"},
                 {"must not contain level_0", ", of another test"});
}

TEST(measure, InterruptedLeavesNothing) {
  const Sandbox box = sandbox(rig_text(2000));
  expect_interruptible(box, {"measure", "rig.toml", "--out", "test"});
}

// Levels beyond 5 mm at the joint: those that are found are written, and the status tells.
TEST(measure, TellsOfLevelsThatAreNotFound) {
  const Sandbox box =
      sandbox(edited(edited(rig_text(8), "from_m_per_s2 = 0.294, to_m_per_s2 = 39.24",
                            "from_m_per_s2 = 30, to_m_per_s2 = 1e4"),
                     "linear", "log"));
  const Outcome run =
      Running({"measure", "rig.toml", "--out", "test", "--no-shaker"}, box.path(), {}).wait();
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("of 8 levels found"), std::string::npos) << run.err;
  EXPECT_TRUE(box.has("test/level_01.csv"));
  EXPECT_FALSE(box.has("test/level_08.csv"));
  EXPECT_NE(box.get("test/truth.csv").find("# not found: level 8"), std::string::npos);
}

}  // namespace
}  // namespace microslip::cli_test::measure_test
