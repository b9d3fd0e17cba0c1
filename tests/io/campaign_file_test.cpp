// SPDX-License-Identifier: MIT
#include "microslip/documents/study/campaign_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/replaced.hpp"

namespace microslip::campaign_file_test {
namespace {

const std::string kText = R"(schema = "microslip.campaign/1"
title = "beam"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
linear_damping = "fit"
smoothing = "lambda=0.1"
edges = "none"
atom = true
inner_reversals = "use"
draws = 200
seed = 7
dissipation_gain_std = 0.02
amplitude_gain_std = 0.01
session_offsets = true
leave_one_out = "tests"
[prediction]
frequency_std = 0.004
force_gain_std = 0.03
[[test]]
name = "first"
file = "a.mat:sweeps.held"
use = "identify"
conditions = { torque_Nm = 20.5, order = "rising" }
[[test]]
name = "second"
file = "b.csv"
use = "both"
session = "2"
[[test]]
name = "third"
file = "c.csv"
use = "predict"
)";

TEST(CampaignFile, TakesEachKey) {
  const CampaignFile campaign = parse_campaign(kText, "folder/campaign.toml");
  EXPECT_EQ(campaign.title, "beam");
  EXPECT_EQ(campaign.structure, "folder/rig.toml");
  EXPECT_EQ(campaign.stiffness, 4e5);
  EXPECT_TRUE(campaign.linear_damping);
  EXPECT_EQ(campaign.smoothing, "lambda=0.1");
  EXPECT_FALSE(campaign.edges);
  EXPECT_TRUE(campaign.atom);
  EXPECT_TRUE(campaign.use_inner_reversals);
  EXPECT_EQ(campaign.draws, 200U);
  EXPECT_EQ(campaign.seed, 7U);
  EXPECT_EQ(campaign.dissipation_gain_std, 0.02);
  EXPECT_EQ(campaign.amplitude_gain_std, 0.01);
  EXPECT_TRUE(campaign.session_offsets);
  EXPECT_EQ(campaign.leave_out, LeaveOut::kTests);
  EXPECT_EQ(campaign.frequency_std, 0.004);
  EXPECT_EQ(campaign.force_gain_std, 0.03);
  ASSERT_EQ(campaign.tests.size(), 3U);
  EXPECT_EQ(campaign.tests[0].file, "folder/a.mat:sweeps.held");
  ASSERT_EQ(campaign.tests[0].conditions.size(), 2U);
  EXPECT_EQ(campaign.tests[0].conditions[0].value, "rising");
  EXPECT_EQ(campaign.tests[0].conditions[1].name, "torque_Nm");
  EXPECT_EQ(campaign.tests[0].conditions[1].value, "20.5");
  EXPECT_TRUE(campaign.tests[1].identifies() && campaign.tests[1].predicted());
  EXPECT_FALSE(campaign.tests[2].identifies());
  EXPECT_EQ(campaign.sessions(), (std::vector<std::string>{"1", "2"}));
}

/// That the message of the changed file has these parts.
void expect_refused_text(const std::string& before, const std::string& after,
                         const std::vector<std::string>& parts, const std::string& text = kText) {
  SCOPED_TRACE(before + " -> " + after);
  try {
    (void)parse_campaign(test::replaced(text, before, after), "campaign.toml");
    FAIL() << "was taken";
  } catch (const Error& error) {
    for (const std::string& part : parts) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
          << part << " in: " << error.what();
    }
  }
}

TEST(CampaignFile, NamesWhatIsWrong) {
  expect_refused_text("campaign/1", "campaign/2", {"campaign.toml:1", "microslip.campaign/1"});
  expect_refused_text("title =", "titel =", {"campaign.toml:2", "titel", "title"});
  expect_refused_text("structure = \"rig.toml\"", "structure = \"\"", {"structure", "path"});
  expect_refused_text("= 4e5", "= -4e5", {"identification.stiffness_N_per_m", "-400000"});
  expect_refused_text("\"fit\"", "\"fitted\"", {"linear_damping", "'fitted'", "none, fit"});
  expect_refused_text("draws = 200", "draws = 1", {"draws", "1", "40", "1000 give"});
  expect_refused_text("draws = 200", "draws = 0", {"seed", "requires draws"});
  expect_refused_text("_gain_std = 0.02", "_gain_std = 2.0", {"dissipation_gain_std", "0.3"});
  expect_refused_text("session = \"2\"", "session = \"1\"",
                      {"session_offsets", "has no effect", "'1'"});
  expect_refused_text("name = \"second\"", "name = \"first\"",
                      {"test[1].name", "'first'", "another test"});
  expect_refused_text("name = \"second\"", "name = \"a/b\"", {"test[1].name", "without /"});
  expect_refused_text("use = \"both\"", "use = \"predict\"", {"session_offsets", "has no effect"});
  expect_refused_text("use = \"both\"", "use = \"all\"",
                      {"use", "'all'", "identify, predict, both"});
  expect_refused_text("use = \"both\"\n", "", {"use"});
  expect_refused_text("torque_Nm =", "\"torque [Nm]\" =", {"torque [Nm]", "letters"});
  expect_refused_text("edges = \"none\"", "forcing = \"modal\"",
                      {"identification.forcing", "applies to joints of a model", "model ="});
  expect_refused_text("\"tests\"", "\"modes\"", {"leave_one_out", "none, tests, levels"});
  expect_refused_text("torque_Nm = 20.5", "torque_Nm = [1, 2]", {"torque_Nm", "a number"});
}

const std::string kModelText = R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
frequency = "absolute"
stiffness = "fit"
forcing = "modal"
harmonics = 3
edges = "none"
draws = 100
leave_one_out = "modes"
[[test]]
name = "blow"
file = "a.csv"
use = "identify"
kind = "ringdown"
mode = 2
[[test]]
name = "other blow"
file = "b.csv"
use = "both"
kind = "ringdown"
)";

TEST(CampaignFile, TakesEachKeyOfAModel) {
  const CampaignFile campaign = parse_campaign(kModelText, "folder/campaign.toml");
  EXPECT_TRUE(campaign.of_model());
  EXPECT_EQ(campaign.structure, "folder/model.toml");
  EXPECT_EQ(campaign.frequency, FrequencyOfLevels::kAbsolute);
  EXPECT_TRUE(campaign.fit_stiffness && campaign.modal_forcing);
  EXPECT_EQ(campaign.harmonics, 3U);
  EXPECT_FALSE(campaign.edges);
  EXPECT_EQ(campaign.leave_out, LeaveOut::kModes);
  EXPECT_EQ(campaign.tests[0].mode, 2U);
  EXPECT_EQ(campaign.tests[1].mode, 0U);  // all
  const std::string rest = kModelText.substr(kModelText.find("[[test]]"));
  const CampaignFile plain = parse_campaign(
      "schema = \"microslip.campaign/1\"\nmodel = \"model.toml\"\n" + rest, "campaign.toml");
  EXPECT_EQ(plain.frequency, FrequencyOfLevels::kChange);
  EXPECT_FALSE(plain.fit_stiffness || plain.modal_forcing);
  EXPECT_EQ(plain.harmonics, 5U);
  EXPECT_EQ(plain.draws, 0U);
}

TEST(CampaignFile, NamesWhatIsWrongOfAModel) {
  const auto refused = [](const std::string& before, const std::string& after,
                          const std::vector<std::string>& parts) {
    expect_refused_text(before, after, parts, kModelText);
  };
  refused("model = \"model.toml\"", "model = \"\"", {"campaign.toml:2", "path"});
  refused("\"absolute\"", "\"all\"", {"frequency", "change, absolute, ignore"});
  refused("\"absolute\"", "\"change\"", {"identification.stiffness", "'fit'", "absolute"});
  refused("\"modal\"", "\"none\"", {"forcing", "excitation, modal"});
  refused("harmonics = 3", "harmonics = 101", {"harmonics", "101", "1 to 100"});
  refused("draws = 100", "draws = 99", {"draws", "99", "100"});
  refused("edges = \"none\"", "atom = true", {"identification.atom", "applies to one joint"});
  refused("edges = \"none\"", "session_offsets = true", {"session_offsets", "absolute"});
  refused("mode = 2", "mode = 0", {"mode", "1 or more"});
  refused("name = \"blow\"", "name = \"modal\"", {"test[0].name", "modal_levels.csv"});
  refused("kind = \"ringdown\"\nmode = 2", "kind = \"loops\"",
          {"kind", "one joint", "identify identifies"});
}

const std::string kKinds = R"(schema = "microslip.campaign/1"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
[[test]]
name = "blow"
file = "blow.mat"
use = "both"
kind = "ringdown"
sensors = { acc2 = "tip", acc1 = "drive" }
mode = 1
assume_units = ["SI", "acc2=g"]
allow_truncated = true
conditions = { torque_Nm = 20.5, order = "rising" }
[[test]]
name = "record"
file = "record.csv"
use = "predict"
kind = "loops"
force = "f"
displacement = "u"
[[test]]
name = "swept"
file = "swept.csv"
use = "predict"
kind = "constant-response"
)";

TEST(CampaignFile, TakesEachKeyOfAKind) {
  const CampaignFile campaign = parse_campaign(kKinds, "campaign.toml");
  ASSERT_EQ(campaign.tests.size(), 3U);
  const CampaignTest& blow = campaign.tests[0];
  EXPECT_EQ(blow.kind, CampaignKind::kRingDown);
  EXPECT_EQ(blow.sensors, (std::vector<std::string>{"acc1=drive", "acc2=tip"}));
  EXPECT_EQ(blow.mode, 1U);
  EXPECT_EQ(blow.assumed_units, (std::vector<std::string>{"SI", "acc2=g"}));
  EXPECT_TRUE(blow.allow_truncated);
  ASSERT_NE(blow.condition("torque_Nm"), nullptr);
  EXPECT_EQ(blow.condition("torque_Nm")->number, 20.5);
  EXPECT_FALSE(blow.condition("order")->number);
  EXPECT_EQ(blow.condition("temperature_K"), nullptr);
  EXPECT_EQ(campaign.conditions(), (std::vector<std::string>{"order", "torque_Nm"}));
  EXPECT_EQ(campaign.tests[1].kind, CampaignKind::kLoops);
  EXPECT_EQ(campaign.tests[1].force, "f");
  EXPECT_EQ(campaign.tests[1].displacement, "u");
  EXPECT_EQ(campaign.tests[2].kind, CampaignKind::kConstantResponse);
}

TEST(CampaignFile, RefusesKeysOfAnotherKind) {
  const auto refused = [](const std::string& before, const std::string& after,
                          const std::vector<std::string>& parts) {
    expect_refused_text(before, after, parts, kKinds);
  };
  refused("\"ringdown\"", "\"hammer\"", {"test[0].kind", "'hammer'", "ringdown, loops"});
  refused("\"ringdown\"", "\"loops\"", {"sensors", "applies to kind = \"ringdown\"", "\"loops\""});
  refused("kind = \"loops\"\n", "", {"force", "applies to kind = \"loops\"", "not given"});
  refused("kind = \"constant-response\"", "kind = \"sweep\"\nmode = 1", {"mode", "ringdown"});
  refused("mode = 1", "mode = 2", {"mode", "must be 1 to identify from"});
  refused("mode = 1", "mode = 0", {"mode", "1 or more"});
  refused("use = \"predict\"\nkind = \"constant-response\"",
          "use = \"identify\"\nkind = \"constant-response\"", {"kind", "has no effect"});
  refused("{ acc2 = \"tip\", acc1 = \"drive\" }", "{}", {"sensors", "at least one channel"});
  refused("acc2=g", "acc2=furlong", {"assume_units", "furlong"});
  refused("20.5", "nan", {"torque_Nm", "finite"});
}

TEST(CampaignFile, NeedsATestToIdentifyFrom) {
  const std::string none = R"(schema = "microslip.campaign/1"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
[[test]]
name = "only"
file = "c.csv"
use = "predict"
)";
  try {
    (void)parse_campaign(none, "campaign.toml");
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("to identify from"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace microslip::campaign_file_test
