// SPDX-License-Identifier: MIT
#include "microslip/documents/study/ensemble_plan_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/config/changed_number.hpp"
#include "support/replaced.hpp"

namespace microslip::ensemble_plan_file_test {
namespace {

const std::string kPredict = R"(schema = "microslip.ensemble/1"
kind = "predict"
[predict]
model = "model.toml"
draws = 100
[[case]]
name = "low"
kind = "frf"
force_N = 0.1
frequency_Hz = [0.1, 0.2]
[[case]]
kind = "backbone"
response_m = { from = 0.1, to = 0.4, count = 3, spacing = "log" }
[[case]]
kind = "march"
force_file = "force.csv"
)";

const std::string kBootstrap = R"(schema = "microslip.ensemble/1"
kind = "bootstrap"
[bootstrap]
levels = "levels.csv"
stiffness_N_per_m = 1.7e5
count = 50
)";

const std::string kDesign = R"(schema = "microslip.ensemble/1"
kind = "design"
[design]
joint = "joint.json"
count = 50
levels = [10, 20]
noise = [0.01]
amplitude_m = [1e-6, 1e-4]
)";

const std::string kSweep = R"(schema = "microslip.ensemble/1"
kind = "sweep"
[sweep]
model = "model.toml"
[[sweep.axis]]
number = "structure.frequency_Hz[0]"
values = [0.1, 0.2]
[[sweep.axis]]
number = "joint: stiffness_N_per_m"
values = { from = 1, to = 2, count = 3 }
[[case]]
kind = "frf"
force_N = 0.1
frequency_Hz = [0.1, 0.2]
)";

std::string message(const std::string& text) {
  return test::message_of<Error>([&] { (void)parse_ensemble_plan(text, "dir/plan.toml"); });
}

TEST(EnsemblePlan, ReadsDraws) {
  const EnsemblePlan plan = parse_ensemble_plan(kPredict, "dir/plan.toml");
  const auto& predict = std::get<PredictPlan>(plan.work);
  EXPECT_EQ(predict.model, "dir/model.toml");
  EXPECT_EQ(predict.draws, 100U);
  EXPECT_EQ(plan.seed, 1U);
  EXPECT_EQ(plan.confidence, 0.95);
  ASSERT_EQ(plan.cases.size(), 3U);
  EXPECT_EQ(plan.cases[0].name, "low");
  EXPECT_EQ(plan.cases[0].force, 0.1);
  EXPECT_EQ(plan.cases[0].to, 0.2);
  EXPECT_EQ(plan.cases[1].name, "case 2");
  EXPECT_EQ(plan.cases[1].responses.size(), 3U);
  EXPECT_NEAR(plan.cases[1].responses[1], 0.2, 1e-15);
  EXPECT_EQ(plan.cases[1].responses[2], 0.4);
  EXPECT_EQ(plan.cases[2].force_file, "dir/force.csv");
}

const std::string kRigDesign = R"(schema = "microslip.ensemble/1"
kind = "design"
[design]
rig = "rig.toml"
count = 5
levels = [10]
sensors = [["acc1", "ldv"], ["acc1"]]
)";

TEST(EnsemblePlan, ReadsDesignsOfARig) {
  const auto plan = std::get<DesignPlan>(parse_ensemble_plan(kRigDesign, "dir/p.toml").work);
  EXPECT_EQ(plan.rig, "dir/rig.toml");
  EXPECT_TRUE(plan.joint.empty());
  EXPECT_EQ(plan.sensor_noise, std::vector<double>{1.0});
  ASSERT_EQ(plan.sensors.size(), 2U);
  EXPECT_EQ(plan.sensors[0], (std::vector<std::string>{"acc1", "ldv"}));
  for (const auto& [by, refusal] : std::vector<std::pair<std::string, std::string>>{
           {"count = 5\njoint = \"j.json\"", "one of the keys joint and rig"},
           {"count = 5\nnoise = [0.1]", "unknown key 'noise'"},
           {"count = 5\nsensor_noise = [-1]", "sensor_noise[0] = -1"}}) {
    EXPECT_NE(message(test::replaced(kRigDesign, "count = 5", by)).find(refusal), std::string::npos)
        << by;
  }
  for (const auto& [by, refusal] : std::vector<std::pair<std::string, std::string>>{
           {"[\"acc1\"]", "must be an array of arrays"},
           {"[]", "must have at least one choice"},
           {"[[\"a\"], [\"a\"]]", "sensors[1] = [a]; must differ"},
           {"[[1]]", "sensors[0][0]"}}) {
    const std::string text = test::replaced(kRigDesign, "[[\"acc1\", \"ldv\"], [\"acc1\"]]", by);
    EXPECT_NE(message(text).find(refusal), std::string::npos) << message(text);
  }
}

// A whole number that no double has in full stands in the settings as it is.
TEST(EnsemblePlan, TellsLargeSeedsApart) {
  for (const char* seed : {"9007199254740992", "9007199254740993", "9223372036854775807"}) {
    const EnsemblePlan plan =
        parse_ensemble_plan(test::replaced(kPredict, "kind = \"predict\"",
                                           std::string("kind = \"predict\"\nseed = ") + seed),
                            "plan.toml");
    EXPECT_EQ(std::to_string(plan.seed), seed);
    EXPECT_EQ(std::ranges::count(plan.settings, std::string("seed = ") + seed), 1) << seed;
  }
}

TEST(EnsemblePlan, ReadsTheOtherKinds) {
  EXPECT_EQ(std::get<BootstrapPlan>(parse_ensemble_plan(kBootstrap, "p").work).stiffness, 1.7e5);
  const auto design = std::get<DesignPlan>(parse_ensemble_plan(kDesign, "p").work);
  EXPECT_EQ(design.levels, (std::vector<std::size_t>{10, 20}));
  EXPECT_EQ(design.highest, 1e-4);
  const auto sweep = std::get<SweepPlan>(parse_ensemble_plan(kSweep, "p").work);
  ASSERT_EQ(sweep.axes.size(), 2U);
  EXPECT_EQ(sweep.axes[0].path, "structure.frequency_Hz[0]");
  EXPECT_EQ(sweep.axes[0].joint, "");
  EXPECT_EQ(sweep.axes[1].joint, "joint");
  EXPECT_EQ(sweep.axes[1].values, (std::vector<double>{1.0, 1.5, 2.0}));
}

// Each line of each plan left out, but those of optional keys: a message names what is missing.
TEST(EnsemblePlan, NamesAMissingKey) {
  for (const std::string& plan : {kPredict, kBootstrap, kDesign, kSweep}) {
    std::size_t begin = 0;
    for (std::size_t end = plan.find('\n'); end != std::string::npos;
         begin = end + 1, end = plan.find('\n', begin)) {
      const std::string line = plan.substr(begin, end - begin);
      if (line.starts_with('[') || line.starts_with("name")) continue;
      const std::string key = line.substr(0, line.find(" ="));
      const std::string found = message(plan.substr(0, begin) + plan.substr(end + 1));
      EXPECT_NE(found.find("dir/plan.toml"), std::string::npos) << line << ": " << found;
      EXPECT_NE(found.find(key), std::string::npos) << line << ": " << found;
    }
  }
}

struct Wrong {
  std::string plan;
  std::string old;
  std::string by;
  std::string refusal;
};

// A wrong value: place, value and rule.
TEST(EnsemblePlan, NamesAWrongValue) {
  const std::vector<Wrong> all{
      {kPredict, "kind = \"predict\"", "kind = \"predikt\"", "must be one of predict, bootstrap"},
      {kPredict, "/1\"", "/2\"", "microslip.ensemble/1"},
      {kPredict, "draws = 100", "draws = 0", "plan.toml:5:9: predict.draws = 0; must be from 1"},
      {kPredict, "draws = 100", "draws = -3", "predict.draws"},
      {kPredict, "draws = 100", "draws = \"many\"", "predict.draws"},
      {kPredict, "draws = 100", "draws = 100\nfoo = 1", "foo"},
      {kPredict, "force_N = 0.1", "force_N = 0.1\nresponse_m = 1",
       "one of the keys force_N, acceleration_m_per_s2 and response_m, found several"},
      {kPredict, "force_N = 0.1", "force_N = -0.1", "case[0].force_N = -0.1"},
      {kPredict, "[0.1, 0.2]", "[0.1]", "must be two frequencies"},
      {kPredict, "[0.1, 0.2]", "[0.1, inf]", "frequency_Hz[1]"},
      {kPredict, "count = 3", "count = 0", "count = 0; must be from 1"},
      {kPredict, "count = 3", "count = 1000000000000", "must be from 1 to 1000000"},
      {kPredict, "from = 0.1", "from = 0.0", "from = 0"},
      {kPredict, "\"log\"", "\"logg\"", "must be one of linear, log"},
      {kPredict, "kind = \"march\"", "kind = \"dance\"", "must be one of frf, backbone, march"},
      {kPredict, "name = \"low\"", "name = \"a/b\"", "without /"},
      {kPredict, "name = \"low\"", "name = \"a\\u0000b\"", "without / and control characters"},
      {kPredict, "name = \"low\"", "name = \"case 2\"", "must differ"},
      {kPredict, "[predict]", "confidence = 1.0\n[predict]", "must be above 0 and below 1"},
      {kPredict, "[predict]", "raw = [1]\n[predict]", "raw[0]"},
      {kPredict, "[predict]", "raw = \"x\"\n[predict]", "an array"},
      {kPredict, "[predict]", "most_failed = 2\n[predict]", "must be from 0 to 1"},
      {kPredict, "[predict]", "block = 0\n[predict]", "must be from 1"},
      {kPredict, "model.toml", "-", "must be the path of a file"},
      {kBootstrap, "1.7e5", "0", "stiffness_N_per_m = 0; must be from 1e-06"},
      {kBootstrap, "count = 50", "count = 50\natom = 1", "true or false"},
      {kBootstrap, "count = 50", "count = 50\nresample = \"x\"",
       "must be one of residuals, levels"},
      {kBootstrap, "count = 50", "count = 50\npoints = 1", "must be from 2"},
      {kDesign, "[10, 20]", "[]", "must have at least one number"},
      {kDesign, "[10, 20]", "[3]", "levels[0] = 3"},
      {kDesign, "[10, 20]", "[10.5]", "must be a whole number"},
      {kDesign, "[0.01]", "[0]", "noise[0] = 0"},
      {kDesign, "[1e-6, 1e-4]", "[1e-4, 1e-6]", "rising"},
      {kDesign, "count = 50", "count = 50\ndraws = 3", "must be from 40"},
      {kSweep, "values = [0.1, 0.2]", "values = []", "must have at least one value"},
      {kSweep, "number = \"structure", "number = \"\" #", "must be the path of a number"},
      {kSweep, "count = 3", "count = 600000", "a grid of 1.2e+06 points"},
  };
  for (const Wrong& wrong : all) {
    std::string text = test::replaced(wrong.plan, wrong.old, wrong.by);
    // A grid that is too large has two long axes.
    if (wrong.refusal.starts_with("a grid")) {
      text = test::replaced(text, "values = [0.1, 0.2]",
                            "values = { from = 1, to = 2, count = 1000000 }");
      EXPECT_NE(message(text).find("a grid of 6e+11 points"), std::string::npos) << message(text);
      continue;
    }
    EXPECT_NE(message(text).find(wrong.refusal), std::string::npos)
        << wrong.by << ": " << message(text);
  }
}

// What can change without a job being done again is no setting; all else is.
TEST(EnsemblePlan, KnowsWhatJobsFollowFrom) {
  const auto settings = [](const std::string& text) {
    return parse_ensemble_plan(text, "p").settings;
  };
  const std::vector<std::string> before = settings(kPredict);
  EXPECT_EQ(settings("# a comment\n" + kPredict), before);
  for (const char* free : {"raw = [\"*\"]\n", "confidence = 0.5\n", "most_failed = 1.0\n"}) {
    EXPECT_EQ(settings(free + kPredict), before);
  }
  for (const char* counts : {"seed = 2\n", "block = 3\n"})
    EXPECT_NE(settings(counts + kPredict), before);
  EXPECT_NE(settings(test::replaced(kPredict, "0.1, 0.2", "0.1, 0.3")), before);
  EXPECT_NE(std::ranges::find(before, "case[0].force_N = 0.1"), before.end());
}

TEST(ChangedNumber, IsThatOfThePath) {
  const std::string toml = "a = 1\n[b]\nc = [1.5, 2]\n[[d]]\ne = 3.0\n";
  EXPECT_NE(toml_with_number(toml, "f", "b.c[1]", 0.1).find("c = [ 1.5, 0.1"), std::string::npos);
  EXPECT_NE(toml_with_number(toml, "f", "d[0].e", 7.0).find("e = 7.0"), std::string::npos);
  EXPECT_NE(toml_with_number(toml, "f", "a", 0.25).find("a = 0.25"), std::string::npos);
  EXPECT_EQ(json_with_number(R"({"a": [{"b": 1}]})", "f", "a[0].b", 0.5), R"({"a":[{"b":0.5}]})");
  for (const char* wrong : {"x", "b", "b.c[2]", "b.c[x]", "d[1].e", "", "[", "b..c", "~"}) {
    EXPECT_THROW((void)toml_with_number(toml, "f", wrong, 1.0), InputError) << wrong;
    EXPECT_THROW((void)json_with_number(R"({"b": {"c": [1]}})", "f", wrong, 1.0), InputError)
        << wrong;
  }
}

}  // namespace
}  // namespace microslip::ensemble_plan_file_test
