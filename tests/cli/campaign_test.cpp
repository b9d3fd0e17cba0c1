// SPDX-License-Identifier: MIT
// `campaign` on a virtual structure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/replaced.hpp"
#include "support/virtual_lap_joint.hpp"

namespace microslip::cli_test::campaign_test {
namespace {

constexpr double kFrequency0 = 80.0;  // Hz
constexpr double kShape = 0.7;        // kg^-1/2

const std::string kCampaign = R"(schema = "microslip.campaign/1"
title = "Virtual beam"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
draws = 200
session_offsets = true
leave_one_out = "tests"
[prediction]
force_gain_std = 0.02
[[test]]
name = "monday"
file = "monday.csv"
use = "identify"
conditions = { torque_Nm = 20, order = "rising" }
[[test]]
name = "tuesday"
file = "tuesday.csv"
use = "identify"
session = "2"
[[test]]
name = "again"
file = "again.csv"
use = "identify"
session = "2"
[[test]]
name = "swept"
file = "swept.csv"
use = "predict"
session = "2"
)";

/// Levels of the true joint with noise of 0.5 % in D, 0.01 % in the frequency.
/// @param offset  of the frequency, relative. @param gain  of D. @param shift  of the amplitudes,
///     m.
std::string measured(double offset, double gain, double shift, std::uint64_t stream) {
  const Joint joint = parse_joint(test::kLapJoint, "true.json").joint;
  RandomStream random(1, stream);
  std::string text = "amplitude [m],dissipation [J],frequency [Hz]\n";
  for (int i = 1; i <= 12; ++i) {
    const double a = 2.5e-5 * i + shift;
    const double omega = 2.0 * std::numbers::pi * kFrequency0;
    const double f =
        std::sqrt(omega * omega - kShape * kShape * (4e5 - secant_stiffness(joint, a))) /
        (2.0 * std::numbers::pi);
    text += fmt::format("{:.12g},{:.12g},{:.12g}\n", a,
                        gain * dissipation(joint, a) * (1.0 + 0.005 * random.normal()),
                        f * (1.0 + offset) * (1.0 + 1e-4 * random.normal()));
  }
  return text;
}

constexpr double kOffset = 0.005;  // of session 2

/// Two sessions, and a sweep of the second by the structure with the true joint, which is there
/// stiffer by the offset.
class Laboratory : public Sandbox {
 public:
  /// @param gain_of_again  of D of the third test.
  explicit Laboratory(double gain_of_again = 1.0)
      : Sandbox{{"rig.toml", test::kLapRig},
                {"true.json", test::kLapJoint},
                {"campaign.toml", kCampaign},
                {"monday.csv", measured(0.0, 1.0, 0.0, 1)},
                {"tuesday.csv", measured(kOffset, 1.0, 4e-6, 2)},
                {"again.csv", measured(kOffset, gain_of_again, -4e-6, 3)}} {
    put("stiffer.toml", test::replaced(test::kLapRig, "[80.0]",
                                       fmt::format("[{}]", kFrequency0 * (1.0 + kOffset))));
    expect_done(*this, {"model", "stiffer.toml", "true.json", "--out", "truth.toml", "--quiet"});
    static const std::string swept = [this] {  // the same in each
      expect_done(*this, {"frf", "truth.toml", "--force", "2", "--frequency", "78:81", "--at",
                          "78:81:121", "--out", "swept.csv", "--quiet"});
      return get("swept.csv");
    }();
    put("swept.csv", swept);
  }
};

const Arguments kCall{"campaign", "campaign.toml", "--out", "found"};

CsvTable table(const Sandbox& box, const std::string& name) { return {box.get(name), name}; }

/// The cell of a column of text in the row whose other column has that text.
std::string cell(const CsvTable& table, const std::string& column, const std::string& key,
                 const std::string& value) {
  const std::vector<std::string> keys = table.text(key);
  const auto at = std::ranges::find(keys, value) - keys.begin();
  return table.text(column).at(static_cast<std::size_t>(at));
}

// The sweep of the second session is predicted by the joint of both and the offset of its session:
// 0.02 % of noise in its mean frequency, half a percent in D. The band of its amplitude is that of
// the 2 % that the gain of the force is uncertain by: ± 4 %.
TEST(campaign, IdentifiesFromSomeTestsAndPredictsAnother) {
  const Laboratory box;
  const Outcome run = expect_done(box, kCall);
  for (const std::string part : {"Virtual beam", "session 2", "frequency offset", "left out",
                                 "Prediction of 1 test", "inside"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in:\n" << run.out;
  }
  const CsvTable sessions = table(box, "found/sessions.csv");
  EXPECT_EQ(sessions.rows(), 2U);
  const double offset = sessions.numbers("frequency_offset", kDimensionless)[1];
  const double sigma = sessions.numbers("frequency_offset_std", kDimensionless)[1];
  EXPECT_NEAR(offset, kOffset, 3.0 * sigma);
  EXPECT_LT(sigma, 1e-4);

  const CsvTable all = table(box, "found/campaign.csv");
  EXPECT_EQ(all.rows(), 37U);  // 36 levels and a peak
  EXPECT_EQ(cell(all, "condition_order", "test", "monday"), "rising");
  EXPECT_EQ(cell(all, "condition_torque_Nm", "test", "monday"), "20");
  EXPECT_EQ(cell(all, "condition_order", "test", "swept"), "");
  for (const char* column : {"amplitude_verdict", "frequency_verdict", "damping_ratio_verdict"}) {
    EXPECT_EQ(cell(all, column, "part", "peak"), "inside") << column;
  }
  const double measured = std::stod(cell(all, "frequency", "part", "peak"));
  EXPECT_NEAR(std::stod(cell(all, "frequency_predicted", "part", "peak")), measured,
              3e-4 * measured);
  const double amplitude = std::stod(cell(all, "amplitude", "part", "peak"));
  const double width = std::stod(cell(all, "amplitude_upper", "part", "peak")) -
                       std::stod(cell(all, "amplitude_lower", "part", "peak"));
  EXPECT_NEAR(width, 0.08 * amplitude, 0.04 * amplitude);
  for (const std::string& text : table(box, "found/leave_one_out.csv").text("contradicts")) {
    EXPECT_EQ(text, "no");
  }
  // Frequencies without the offset: no warning of a rise.
  EXPECT_EQ(box.get("found/joint.json").find("frequency_rises"), std::string::npos);
}

// What campaign predicts is what verify predicts by the model and the draws that are left: of the
// rounding of a frequency in the file.
TEST(campaign, LeavesAModelThatPredictsTheSame) {
  const Laboratory box;
  expect_done(box, with(kCall, {"--quiet"}));
  expect_done(box, {"verify", "found/model_2.toml", "swept.csv", "--draws", "200", "--out",
                    "again_compared.csv", "--quiet"});
  const CsvTable first = table(box, "found/comparison.csv");
  const CsvTable second = table(box, "again_compared.csv");
  ASSERT_EQ(first.rows(), second.rows());
  for (const char* column : {"predicted", "lower", "upper"}) {
    const std::vector<std::string> a = first.text(column);
    const std::vector<std::string> b = second.text(column);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(std::stod(a[i]), std::stod(b[i]), 1e-6 * std::abs(std::stod(a[i]))) << column;
    }
  }
}

// The same joint with 20 % more loss, 40 times the noise. What predicts is without it: pooled, it
// made the joint lose 6 % too much.
TEST(campaign, NamesTheTestOfAnotherJoint) {
  const Laboratory box(1.2);
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("again: D"), std::string::npos) << run.out;
  const CsvTable left = table(box, "found/leave_one_out.csv");
  EXPECT_EQ(cell(left, "contradicts", "left_out", "again"), "yes");
  EXPECT_EQ(cell(left, "contradicts", "left_out", "monday"), "no");
  EXPECT_NE(box.get("found/leave_one_out.csv").find("# warning: left_out_contradicts: again"),
            std::string::npos);
  EXPECT_NE(run.out.find("again is wrong, or another joint"), std::string::npos) << run.out;
  const Joint truth = parse_joint(test::kLapJoint, "true.json").joint;
  const Joint found = read_joint(box.file("found/joint.json")).joint;
  for (const double a : {1e-4, 2e-4, 2.9e-4}) {
    EXPECT_NEAR(dissipation(found, a) / dissipation(truth, a), 1.0, 0.01) << a;
  }
  const CsvTable all = table(box, "found/campaign.csv");
  for (const char* column : {"amplitude_verdict", "frequency_verdict", "damping_ratio_verdict"}) {
    EXPECT_EQ(cell(all, column, "part", "peak"), "inside") << column;
  }
}

// Without offsets the frequencies of both sessions together rise, which no joint does.
TEST(campaign, WarnsOfFrequenciesThatAreNotMonotone) {
  const Laboratory box;
  box.put("campaign.toml", test::replaced(kCampaign, "session_offsets = true\n", ""));
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("session_offsets = true"), std::string::npos) << run.out;
  const std::string text = box.get("found/campaign.csv");
  EXPECT_NE(text.find("# warning: sessions_differ"), std::string::npos);
  EXPECT_NE(text.find("# warning: frequency_rises"), std::string::npos);
  EXPECT_FALSE(box.has("found/model_2.toml"));
}

// The amplitudes of the second session begin where those of the first end: the joint alone parts
// its offset from the softening in between. Where they overlap, levels of both hold the two apart.
TEST(campaign, WarnsOfAnOffsetThatLeansOnTheJoint) {
  const Laboratory box;
  expect_done(box, with(kCall, {"--quiet"}));
  const std::string warning =
      "# warning: offset_leans_on_joint: the amplitudes of session 2 do not";
  EXPECT_EQ(box.get("found/sessions.csv").find(warning), std::string::npos);
  std::string low = measured(0.0, 1.0, 0.0, 1);
  std::size_t end = 0;
  for (int row = 0; row < 7; ++row) end = low.find('\n', end) + 1;  // up to 150 µm
  low.resize(end);
  box.put("monday.csv", low);
  const auto above = [](const std::string& text) {
    std::size_t at = 0;
    for (int row = 0; row < 7; ++row) at = text.find('\n', at) + 1;
    return text.substr(0, text.find('\n') + 1) + text.substr(at);
  };
  box.put("tuesday.csv", above(measured(kOffset, 1.0, 4e-6, 2)));
  box.put("again.csv", above(measured(kOffset, 1.0, -4e-6, 3)));
  expect_done(box, with(kCall, {"--quiet"}));
  for (const char* name : {"sessions.csv", "campaign.csv", "comparison.csv", "model_2.toml"}) {
    EXPECT_NE(box.get(std::string("found/") + name).find(warning), std::string::npos) << name;
  }
  EXPECT_NE(box.get("found/joint.json").find("offset_leans_on_joint"), std::string::npos);
}

TEST(campaign, IsQuietAndTheSameEachTime) {
  const Laboratory box;
  const Outcome run = expect_done(box, with(kCall, {"--quiet"}));
  EXPECT_EQ(run.out + run.err, "");
  const std::string first = box.get("found/campaign.csv");
  expect_done(box, with(kCall, {"--quiet"}));
  EXPECT_EQ(box.get("found/campaign.csv"), first);
}

TEST(campaign, EndsOnInterruptWhileItDraws) {
  const Laboratory box;
  box.put("campaign.toml", test::replaced(kCampaign, "draws = 200", "draws = 500000"));
  expect_interruptible(box, kCall, SIGINT, "campaign");
}

TEST(campaign, NamesWhatIsWrong) {
  const Laboratory box;
  const auto refused = [&](const std::string& before, const std::string& after,
                           const std::vector<std::string>& parts) {
    box.put("campaign.toml", test::replaced(kCampaign, before, after));
    expect_refused(box, kCall, parts);
    EXPECT_FALSE(box.has("found"));
  };
  refused("rig.toml", "none.toml", {"none.toml"});
  refused("rig.toml", "truth.toml",
          {"structure", "truth.toml", "must be a rig.toml", "as model in place"});
  refused("monday.csv", "none.csv", {"none.csv"});
  refused("monday.csv", "tuesday.csv", {"tuesday.csv"});
  refused("draws = 200", "draws = 1", {"draws", "= 1", "40"});
  refused("swept.csv", "true.json", {"test 'swept'", "stepped sines"});
  refused("stiffness_N_per_m = 4e5", "stiffness_N_per_m = 6e5", {"k is 600000 N/m"});
  refused("stiffness_N_per_m = 4e5", "stiffness_N_per_m = 4e9", {"k is 4e+09 N/m. Check k"});
  refused("leave_one_out = \"tests\"", "leave_one_out = \"all\"", {"leave_one_out", "'all'"});
  refused("leave_one_out = \"tests\"", "smoothing = \"lambda=-1\"",
          {"campaign.toml: identification.smoothing = -1", "above 0"});
  refused("leave_one_out = \"tests\"", "smoothing = \"p=0.3\"",
          {"campaign.toml: identification.smoothing = 'p=0.3'", "gcv or lambda=X", "identify"});
  box.put("campaign.toml", kCampaign);
  expect_refused(box, {"campaign", "-", "--out", "found"}, {"standard input", "a file"});
  expect_refused(box, {"campaign", "campaign.toml", "--out", "-"}, {"folder"});
  expect_refused(box, with(kCall, {"--picture", "a.jpg"}), {"--picture", ".svg"});
  box.put("levels.csv", box.get("monday.csv"));
  box.put("campaign.toml", test::replaced(kCampaign, "monday.csv", "levels.csv"));
  expect_refused(box, {"campaign", "campaign.toml", "--out", "."}, {"levels.csv", "replaced"});
}

}  // namespace
}  // namespace microslip::cli_test::campaign_test
