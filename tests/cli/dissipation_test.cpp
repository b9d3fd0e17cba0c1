// SPDX-License-Identifier: MIT
#include "microslip/joint/dissipation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip::cli_test::dissipation_test {
namespace {

constexpr const char* kHeader =
    "amplitude [m],force [N],dissipation [J],secant_stiffness [N/m],loss_factor [1]\n";

Sandbox sandbox() { return Sandbox{{"joint.json", kJointText}}; }

/// Each number in the table is that of the library, to the last digit: the table holds the shortest
/// text that reads back as the same double.
void expect_curve(const std::string& text, const std::vector<double>& amplitude) {
  const CsvTable table(text, "curve.csv");
  const Joint joint = sample_joint();
  const std::vector<double> a = table.numbers("amplitude", kLength);
  const std::vector<double> force = table.numbers("force", kForce);
  const std::vector<double> loss = table.numbers("dissipation", kEnergy);
  const std::vector<double> secant = table.numbers("secant_stiffness", kStiffness);
  const std::vector<double> factor = table.numbers("loss_factor", kDimensionless);
  ASSERT_EQ(a.size(), amplitude.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_DOUBLE_EQ(a[i], amplitude[i]);
    EXPECT_EQ(force[i], joint.virgin_force(a[i]));
    EXPECT_EQ(loss[i], dissipation(joint, a[i]));
    EXPECT_EQ(secant[i], secant_stiffness(joint, a[i]));
    EXPECT_EQ(factor[i], loss_factor(joint, a[i]));
  }
}

TEST(dissipation, WritesTheCurveOfTheLibrary) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(
      box, {"dissipation", "joint.json", "--amplitude", "0:3e-4:4", "--out", "curve.csv"});
  EXPECT_EQ(run.out, "");
  const std::string text = box.get("curve.csv");
  EXPECT_TRUE(behind_heading(text).starts_with(kHeader)) << text;
  expect_curve(text, {0.0, 1e-4, 2e-4, 3e-4});
}

TEST(dissipation, RefusesWhatLeavesTheRangeOfDoubles) {
  const Sandbox box = sandbox();
  for (const std::string range : {"1e-310:1:3:log", "1e-155:1e155:3:log", "0:1e7:3"}) {
    expect_refused(box, {"dissipation", "joint.json", "--amplitude", range, "--out", "curve.csv"},
                   {"--amplitude", "1e-15 to 1e6"});
  }
}

TEST(dissipation, TakesUnitsAndEqualRatios) {
  const Sandbox box = sandbox();
  const Outcome run =
      expect_done(box, {"dissipation", "joint.json", "--amplitude", "1um:1mm:4:log", "--out", "-"});
  EXPECT_TRUE(run.out.starts_with(kHeader)) << run.out;
  expect_curve(run.out, {1e-6, 1e-5, 1e-4, 1e-3});
}

TEST(dissipation, EndsExactlyAtTheEndOfTheRange) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(
      box, {"dissipation", "joint.json", "--amplitude", "1.1um:0.3mm:7:log", "--out", "-"});
  const std::vector<double> a = CsvTable(run.out, "curve").numbers("amplitude", kLength);
  EXPECT_EQ(a.front(), 1.1e-6);
  EXPECT_EQ(a.back(), 3e-4);
}

TEST(dissipation, ReadsTheJointFromStandardInput) {
  const Sandbox box;
  const Outcome run = expect_done(
      box, {"dissipation", "-", "--amplitude", "1um:2um:2", "--out", "-"}, {.in = kJointText});
  expect_curve(run.out, {1e-6, 2e-6});
}

// What is round in the unit of the range is the number that a reader would type.
TEST(dissipation, KeepsRoundAmplitudesRound) {
  const Sandbox box = sandbox();
  const Outcome run =
      expect_done(box, {"dissipation", "joint.json", "--amplitude", "50um:300um:6", "--out", "-"});
  EXPECT_EQ(CsvTable(run.out, "out").numbers("amplitude", kLength),
            (std::vector<double>{50e-6, 100e-6, 150e-6, 200e-6, 250e-6, 300e-6}));
  const Outcome mixed =
      expect_done(box, {"dissipation", "joint.json", "--amplitude", "50um:0.3mm:2", "--out", "-"});
  EXPECT_EQ(CsvTable(mixed.out, "out").numbers("amplitude", kLength),
            (std::vector<double>{50e-6, 300e-6}));
}

// The sample reaches farther than an identification up to 20 N, 118 um, tells.
TEST(dissipation, WarnsBeyondTheIdentifiedRange) {
  const Sandbox box;
  std::string joint = kJointText;
  joint.insert(joint.rfind('}'), R"(, "identification": {"covered_to_N": 20})");
  box.put("joint.json", joint);
  const Arguments near{"dissipation", "joint.json", "--amplitude", "1um:100um:3", "--out", "a.csv"};
  EXPECT_EQ(expect_done(box, near).err, "");
  Arguments far = near;
  far[3] = "1um:200um:3";
  EXPECT_TRUE(
      box.run(far).err.starts_with("microslip: warning: the joint moves by 200 µm, 1.7 times "
                                   "the 117.6 µm of the highest level"))
      << box.run(far).err;
  const std::string table = box.get("a.csv");
  EXPECT_TRUE(behind_heading(table).starts_with(
      "# warning: beyond_identification: the joint moves by 200 µm"))
      << table;
  far.emplace_back("--quiet");
  EXPECT_EQ(box.run(far).err, "");
  EXPECT_EQ(behind_heading(box.get("a.csv")), behind_heading(table))
      << "quiet or not, the file has it";

  const Outcome loop = box.run({"loop", "joint.json", "--amplitude", "0.2mm", "--out", "loop.csv"});
  EXPECT_EQ(loop.status, 0);
  EXPECT_TRUE(loop.err.starts_with("microslip: warning: the joint moves by 200 µm")) << loop.err;
  EXPECT_TRUE(behind_heading(box.get("loop.csv"))
                  .starts_with("# warning: beyond_identification: the joint moves"));
}

TEST(dissipation, TakesAnElasticJoint) {
  const Sandbox box;
  box.put("joint.json",
          R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e5, "density": []})");
  const Outcome run =
      expect_done(box, {"dissipation", "joint.json", "--amplitude", "0:1:2", "--out", "-"});
  EXPECT_EQ(run.out, std::string(kHeader) + "0,0,0,1e+05,0\n1,1e+05,0,1e+05,0\n");
}

TEST(dissipation, GivesLevelsThatIdentifyTakes) {
  const Sandbox box = sandbox();
  expect_done(box, {"dissipation", "joint.json", "--amplitude", "5um:250um:40", "--out", "l.csv"});
  expect_done(box, {"identify", "l.csv", "--stiffness", "1.7e5", "--out", "found.json"});
  const Joint found = read_joint(box.file("found.json")).joint;
  const Joint truth = sample_joint();
  // Levels without noise: what is left is the resolution of the inversion.
  for (const double a : {2e-5, 1e-4, 2e-4}) {
    EXPECT_NEAR(dissipation(found, a) / dissipation(truth, a), 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace microslip::cli_test::dissipation_test
