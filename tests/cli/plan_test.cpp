// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::cli_test::plan_test {
namespace {

Sandbox sandbox() {
  return Sandbox{{"levels.csv", sample_levels_text()}, {"joint.json", kJointText}};
}

const Arguments kPlan{"plan", "levels.csv", "--stiffness", "1.7e5", "--out", "next.csv"};

TEST(plan, RanksAmplitudesAndSaysWhereMoreDoesNotHelp) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, with(kPlan, {"--count", "6"}));
  EXPECT_NE(run.out.find("next 1"), std::string::npos);
  EXPECT_NE(run.out.find("further repeats no longer help"), std::string::npos);
  const std::string text = box.get("next.csv");
  EXPECT_TRUE(text.starts_with("# microslip ")) << text;
  EXPECT_NE(text.find("# further repeats no longer help"), std::string::npos);
  const CsvTable table(text, "next.csv");
  double levels = 0.0;
  double width = 1e300;
  const std::vector<double> before = table.numbers("width_before", kPerForce);
  const std::vector<double> after = table.numbers("width_after", kPerForce);
  const std::vector<double> endless = table.numbers("width_endless", kPerForce);
  const std::vector<double> amplitude = table.numbers("amplitude", kLength);
  const std::vector<double> repeats = table.numbers("repeats", kDimensionless);
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    EXPECT_GE(amplitude[i], 1e-5);
    EXPECT_LE(amplitude[i], 2e-4);
    EXPECT_LT(after[i], before[i]);
    EXPECT_LE(endless[i], after[i]);
    EXPECT_LT(before[i], width);
    width = before[i];
    levels += repeats[i];
  }
  EXPECT_EQ(levels, 6.0);
}

// No option of plan says what several assemblies mean: the message names none.
TEST(plan, TakesLevelsOfOneJoint) {
  std::string levels = "amplitude [m],dissipation [J],assembly\n";
  for (int i = 1; i <= 20; ++i) {
    levels +=
        std::to_string(i) + "e-5," + std::to_string(i * i) + "e-5,A" + std::to_string(i % 2) + "\n";
  }
  const Sandbox box{{"levels.csv", levels}};
  expect_refused(box, {"plan", "levels.csv", "--stiffness", "1.7e5", "--out", "p.csv"},
                 {"column assembly", "2 names", "must be one", "Keep the rows of one assembly"});
}

TEST(plan, ReplacesItsOwnKindAlone) {
  const Sandbox box = sandbox();
  expect_done(box, kPlan);
  expect_done(box, with(kPlan, {"--quiet"}));
  expect_refused(box, {"plan", "levels.csv", "--stiffness", "1.7e5", "--out", "joint.json"},
                 {"joint.json"});
}

TEST(plan, SaysWhatIsAtFault) {
  const Sandbox box = sandbox();
  box.put("few.csv", "amplitude [m],dissipation [J]\n1e-5,1e-6\n2e-5,5e-6\n");
  const auto refused = [&](const Arguments& more, const std::vector<std::string>& parts) {
    expect_refused(box, with(kPlan, more), parts);
  };
  refused({"--target", "slope"}, {"--target", "density, area or peak:MODEL.toml"});
  refused({"--target", "peak:model.toml"}, {"--force", "missing"});
  refused({"--force", "2"}, {"--force", "applies to --target peak"});
  refused({"--joint", "lap"}, {"--joint", "applies to --target peak"});
  refused({"--count", "0"}, {"--count"});
  refused({"--amplitude", "300um:20um"}, {"--amplitude"});
  refused({"--amplitude", "10um:1mm"}, {"TO of --amplitude", "0.0006 m or less"});
  refused({"--range", "10:200"}, {"TO of --range", "102 N or less"});
  refused({"--draws", "3"}, {"--draws", "1000 give"});
  expect_refused(box, {"plan", "few.csv", "--stiffness", "1.7e5", "--out", "next.csv"},
                 {"few.csv", "must be 8 or more", "Start with 8 or more levels"});
  expect_refused(box, {"plan", "levels.csv", "--out", "next.csv"}, {"--stiffness", "missing"});
}

}  // namespace
}  // namespace microslip::cli_test::plan_test
