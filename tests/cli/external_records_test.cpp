// SPDX-License-Identifier: MIT
// Forces on paths that others measured or computed.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"

namespace microslip::cli_test::external_records_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A summary with each wrapped value in one line.
std::string unwrapped(const std::string& text) {
  return std::regex_replace(text, std::regex("\n {10,}"), " ");
}

class ExternalRecords : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MICROSLIP_DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
    folder_ = folder;
  }

  [[nodiscard]] fs::path external(const std::string& name) const { return folder_ / name; }

  [[nodiscard]] json identification() const {
    return json::parse(box_.get("joint.json")).at("identification");
  }

  fs::path folder_;
  Sandbox box_;
};

/// A history of another code, of ten nested springs without noise: MASTODON, idaholab/mastodon,
/// LGPL-2.1; its stress over twice the strain zx.
TEST_F(ExternalRecords, NestedSpringsAreAJointOfThisKind) {
  const fs::path file = external("mastodon_isoil/data_file_hysteresis.csv");
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const testing::ReferenceTable table(file.string());
  const std::vector<double>& strain = table["strain_zx_el"];
  const std::vector<double>& stress = table["stress_zx_el"];
  std::string text = "time [s],u [m],f [N]\n";
  for (std::size_t i = 0; i < strain.size(); ++i) {
    text += fmt::format("{},{},{}\n", 0.01 * static_cast<double>(i), 2.0 * strain[i], stress[i]);
  }
  box_.put("history.csv", text);
  expect_done(box_, {"identify", "history.csv", "--out", "joint.json"});
  const json found = identification();
  EXPECT_TRUE(found.at("warnings").empty()) << found.at("warning_texts");
  EXPECT_LE(found.at("unexplained").at(0).get<double>(), 5e-3);
}

/// A banded rotary friction damper with backlash, a sine of 0.5 Hz at three amplitudes:
/// ARTS-Laboratory, Dataset-Friction-Damper-with-Backlash, data/dataset-2, CC BY-SA 4.0.
TEST_F(ExternalRecords, AFrictionDamperWithBacklashIsNone) {
  for (const char* amplitude : {"0.5", "1", "1.5"}) {
    const fs::path file = external(fmt::format("friction_damper/sine_0.5Hz_{}in.csv", amplitude));
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file("damper.csv"), fs::copy_options::overwrite_existing);
    const Outcome done = expect_done(
        box_, {"identify", "damper.csv", "--out", "joint.json", "--density-csv", "density.csv"});
    EXPECT_LT(unwrapped(done.out).find("NOT A MASING JOINT: play, pinching or bearing (dead_zone)"),
              unwrapped(done.out).find("density"))
        << done.out;
    const json warnings = identification().at("warnings");
    EXPECT_NE(std::ranges::find(warnings, "dead_zone"), warnings.end()) << warnings;
    EXPECT_NE(box_.get("density.csv")
                  .find("# warning: dead_zone: not a Masing joint under constant normal load"),
              std::string::npos);
  }
}

/// Angle joints of one bolt, computed with solid elements and contact, slip, pass the play of the
/// hole and bear on it farther out each time: pbocchini/single-bolted-connection, GPL-3.0. They
/// were said to drift.
TEST_F(ExternalRecords, ABoltThatBearsOnItsHoleHasADeadZone) {
  for (const char* name : {"H1_4", "H3_4"}) {
    const fs::path file = external(fmt::format("single_bolt/{}.csv", name));
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file("bolt.csv"), fs::copy_options::overwrite_existing);
    expect_done(box_, {"identify", "bolt.csv", "--out", "joint.json", "--samples", "100"});
    const json found = identification();
    EXPECT_EQ(found.at("verdict_departure").at(0), "dead_zone") << name;
    EXPECT_EQ(found.at("verdict").at(0), "broken") << name;
  }
}

// One of its records does not predict the others, and the warnings give the reason: of the joint,
// and of each record by itself. The force is missed by a fifth, where its noise is a thousandth.
TEST_F(ExternalRecords, AFrictionDamperIsNotPredictedAndItIsSaidWhy) {
  Arguments call{"verify", "joint.json"};
  for (const char* amplitude : {"0.5", "1", "1.5"}) {
    const std::string name = fmt::format("sine_0.5Hz_{}in.csv", amplitude);
    const fs::path file = external("friction_damper/" + name);
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file(name));
    call.push_back(name);
  }
  expect_done(box_, {"identify", "sine_0.5Hz_1.5in.csv", "--out", "joint.json", "--quiet"});
  expect_done(box_, with(call, {"--out", "comparison.csv", "--quiet"}));
  const std::string text = box_.get("comparison.csv");
  EXPECT_NE(
      text.find("# warning: joint_not_of_this_kind: joint.json was identified as NOT A MASING "
                "JOINT: play, pinching or bearing (dead_zone)"),
      std::string::npos);
  const CsvTable table(text, "comparison.csv");
  const std::vector<std::string> quantity = table.text("quantity");
  const std::vector<std::string> predicted = table.text("predicted");
  std::size_t records = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (quantity[row] == "force_nrmse") {
      ++records;
      test::record_largest("force nrmse [1]", std::stod(predicted[row]));
      EXPECT_GT(std::stod(predicted[row]), 0.1);
      EXPECT_LT(std::stod(predicted[row]), 0.3);
    }
    if (quantity[row] == "force_noise") {
      EXPECT_LT(std::stod(predicted[row]), 1e-3);
    }
  }
  EXPECT_EQ(records, 3U);
  for (const char* amplitude : {"0.5", "1", "1.5"}) {
    const std::string warning = fmt::format(
        "# warning: test_not_of_this_kind: sine_0.5Hz_{}in.csv: the record is NOT OF A MASING "
        "JOINT",
        amplitude);
    const std::size_t at = text.find(warning);
    ASSERT_NE(at, std::string::npos) << text.substr(0, 2000);
    EXPECT_NE(text.substr(at, text.find('\n', at) - at).find("dead_zone"), std::string::npos);
  }
}

// In a campaign levels of its cycles alone identify, which would not tell: each record is looked
// at.
TEST_F(ExternalRecords, ACampaignSaysThatAFrictionDamperIsNoJoint) {
  std::string tests;
  for (const char* amplitude : {"0.5", "1", "1.5"}) {
    const std::string name = fmt::format("sine_0.5Hz_{}in.csv", amplitude);
    const fs::path file = external("friction_damper/" + name);
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file(name));
    tests +=
        fmt::format("[[test]]\nname = \"{} in\"\nfile = \"{}\"\nkind = \"loops\"\nuse = \"{}\"\n",
                    amplitude, name, amplitude == std::string("1") ? "predict" : "identify");
  }
  box_.put("rig.toml", R"(schema = "microslip.rig/1"
[modes]
frequency_Hz = [2.0]
excitation = [0.001]
joint = [0.001]
[damping]
loss_factor = [0.0]
[excitation]
channel = "force"
[[accelerometer]]
channel = "acceleration"
shape = [0.001]
)");
  box_.put("campaign.toml",
           "schema = \"microslip.campaign/1\"\nstructure = \"rig.toml\"\n"
           "[identification]\nstiffness_N_per_m = 1.8e7\n" +
               tests);
  box_.run({"campaign", "campaign.toml", "--out", "found", "--quiet"});
  for (const char* name : {"joint.json", "levels.csv", "campaign.csv", "comparison.csv"}) {
    const std::string text = box_.get(std::string("found/") + name);
    EXPECT_NE(text.find("test_not_of_this_kind"), std::string::npos) << name;
    EXPECT_NE(text.find("dead_zone"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace microslip::cli_test::external_records_test
