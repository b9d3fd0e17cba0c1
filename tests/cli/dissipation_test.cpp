// SPDX-License-Identifier: MIT
#include "microslip/joint/dissipation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/csv.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip::cli_test {
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
  EXPECT_TRUE(text.starts_with(kHeader)) << text;
  expect_curve(text, {0.0, 1e-4, 2e-4, 3e-4});
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
}  // namespace microslip::cli_test
