// SPDX-License-Identifier: MIT
// `campaign` with ring-downs, records of force and displacement, and conditions of tests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/dissipation.hpp"
#include "support/figures.hpp"
#include "support/force_records.hpp"
#include "support/replaced.hpp"
#include "support/virtual_lap_joint.hpp"

namespace microslip::cli_test::campaign_kinds_test {
namespace {

const Arguments kCall{"campaign", "campaign.toml", "--out", "found"};

Joint true_joint() { return parse_joint(test::kLapJoint, "joint.json").joint; }

std::string campaign(const std::string& identification, const std::string& tests) {
  return fmt::format(R"(schema = "microslip.campaign/1"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
{}{})",
                     identification, tests);
}

std::string one_test(const std::string& name, const std::string& use,
                     const std::string& more = "") {
  return fmt::format("[[test]]\nname = \"{0}\"\nfile = \"{0}.csv\"\nuse = \"{1}\"\n{2}", name, use,
                     more);
}

/// The structure with the true joint.
Sandbox laboratory() {
  return {
      {"rig.toml", test::kLapRig}, {"true.toml", test::kLapModel}, {"joint.json", test::kLapJoint}};
}

/// blow.csv: the free decay from 320 µm, as a hammer would leave it, with 20 mm/s² of noise.
void record_blow(const Sandbox& box) {
  static const std::string blow = [&box] {  // the same in each
    expect_done(box,
                {"march", "true.toml", "--release", "1:320um", "--duration", "4", "--sampling-rate",
                 "4096", "--no-error-estimate", "--out", "march.csv", "--quiet"});
    RandomStream random(21, 1);
    return test::noisy_record(box.get("march.csv"), 0.02, random);
  }();
  box.put("blow.csv", blow);
}

/// swept.csv: a sweep at 1 N, the peak at 230 µm, with noise.
void record_sweep(const Sandbox& box) {
  expect_done(box, {"frf", "true.toml", "--force", "1", "--frequency", "78.5:80.5", "--at",
                    "78.5:80.5:61", "--out", "frf.csv", "--quiet"});
  RandomStream random(22, 1);
  box.put("swept.csv", test::noisy_sweep(box.get("frf.csv"), random));
}

/// held_20.csv to held_320.csv: sweeps at constant response, in µm, with noise; the tests that they
/// are.
std::string record_held(const Sandbox& box) {
  RandomStream random(23, 1);
  std::string tests;
  for (const int x : {20, 40, 60, 80, 100, 130, 160, 200, 240, 280, 320}) {
    expect_done(box, {"frf", "true.toml", "--response", fmt::format("{}um", x), "--frequency",
                      "79:80.5", "--at", "79:80.5:61", "--out", "frf.csv", "--quiet"});
    const std::string name = fmt::format("held_{}", x);
    box.put(name + ".csv", test::noisy_sweep(box.get("frf.csv"), random));
    tests += one_test(name, "identify");
  }
  return tests;
}

CsvTable table(const Sandbox& box, const std::string& name) { return {box.get(name), name}; }

/// Cells of a column in the rows of a quantity of comparison.csv that were measured.
std::vector<double> compared(const CsvTable& table, const std::string& quantity,
                             const std::string& column) {
  const std::vector<std::string> quantities = table.text("quantity");
  const std::vector<std::string> measured = table.text("measured");
  const std::vector<std::string> cells = table.text(column);
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (quantities[row] == quantity && !measured[row].empty()) {
      values.push_back(std::stod(cells[row]));
    }
  }
  return values;
}

/// √(mean of (measured − predicted)²/σ²).
double deviations(const CsvTable& table, const std::string& quantity) {
  const std::vector<double> measured = compared(table, quantity, "measured");
  const std::vector<double> sigma = compared(table, quantity, "measured_std");
  const std::vector<double> predicted = compared(table, quantity, "predicted");
  EXPECT_GE(measured.size(), 8U) << quantity;
  double sum = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    sum += std::pow((measured[i] - predicted[i]) / sigma[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(measured.size()));
}

double share_inside(const CsvTable& table) {
  const std::vector<std::string> verdicts = table.text("verdict");
  const auto said = std::ranges::count_if(verdicts, [](const auto& v) { return !v.empty(); });
  return static_cast<double>(std::ranges::count(verdicts, "inside")) / static_cast<double>(said);
}

/// rms of what levels miss the dissipation of a joint by, over the sigma that they state, 1.
double loss_over_sigma(const CsvTable& levels, const Joint& truth) {
  const std::vector<double> amplitude = levels.numbers("amplitude", kLength);
  const std::vector<double> loss = levels.numbers("dissipation", kEnergy);
  const std::vector<double> sigma = levels.numbers("dissipation_std", kEnergy);
  double sum = 0.0;
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    sum += std::pow((loss[i] - dissipation(truth, amplitude[i])) / sigma[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(amplitude.size()));
}

// The blow against the sweeps of the same structure: frequency and damping ratio over amplitude. By
// the true joint they lie within the σ that the analysis of the decay states, rms below 1.5 of it;
// by the joint that the campaign finds from eleven sweeps, at least 90 % in a band of 95 % that has
// the draws of the joint, too.
TEST(campaignKinds, ABlowFollowsFromSweeps) {
  const Sandbox box = laboratory();
  record_blow(box);
  const std::string held = record_held(box);
  expect_done(box, {"verify", "true.toml", "blow.csv", "--out", "truth.csv", "--quiet"});
  const CsvTable truth = table(box, "truth.csv");
  for (const char* quantity : {"frequency", "damping_ratio"}) {
    const double sigmas = deviations(truth, quantity);
    EXPECT_LT(sigmas, 1.5) << quantity;
    test::record_largest(fmt::format("{} over sigma [1]", quantity), sigmas);
  }
  box.put("campaign.toml",
          campaign("draws = 400\n", held + one_test("blow", "predict", "kind = \"ringdown\"\n")));
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("blow.csv: ringdown"), std::string::npos) << run.out;
  const CsvTable found = table(box, "found/comparison.csv");
  const double inside = share_inside(found);
  EXPECT_GE(inside, 0.9) << run.out;
  test::record_smallest("inside of 95 % [1]", inside);
  const auto largest = [&](const char* quantity) {
    double most = 0.0;
    const std::vector<double> measured = compared(found, quantity, "measured");
    const std::vector<double> predicted = compared(found, quantity, "predicted");
    for (std::size_t i = 0; i < measured.size(); ++i) {
      most = std::max(most, std::abs(predicted[i] / measured[i] - 1.0));
    }
    return most;
  };
  test::record_largest("frequency [1]", largest("frequency"));
  test::record_largest("damping ratio [1]", largest("damping_ratio"));
  // The same by verify and the model that is left, its draws and its sensors.
  expect_done(box, {"verify", "found/model.toml", "blow.csv", "--draws", "400", "--out",
                    "again.csv", "--quiet"});
  const CsvTable again = table(box, "again.csv");
  for (const char* column : {"predicted", "lower", "upper"}) {
    const std::vector<double> first = compared(found, "damping_ratio", column);
    const std::vector<double> second = compared(again, "damping_ratio", column);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR(second[i], first[i], 1e-6 * first[i]) << column;  // of ω/2π in the file
    }
  }
}

// Conversely: levels of the blow are those of the true joint within their σ, rms below
// 1.5, and the sweep's peak follows from them: the 0.3 % of noise that its force has at each step
// are in the band.
TEST(campaignKinds, ABlowIdentifiesTheJoint) {
  const Sandbox box = laboratory();
  record_blow(box);
  record_sweep(box);
  box.put("campaign.toml", campaign("draws = 400\n[prediction]\nforce_gain_std = 0.003\n",
                                    one_test("blow", "both", "kind = \"ringdown\"\n") +
                                        one_test("swept", "predict")));
  const Outcome run = expect_done(box, kCall);
  const CsvTable levels = table(box, "found/blow_levels.csv");
  ASSERT_GE(levels.rows(), 8U);
  EXPECT_LT(loss_over_sigma(levels, true_joint()), 1.5);
  const CsvTable all = table(box, "found/campaign.csv");
  const std::vector<std::string> parts = all.text("part");
  const auto peak = static_cast<std::size_t>(std::ranges::find(parts, "peak") - parts.begin());
  ASSERT_LT(peak, parts.size());
  for (const char* quantity : {"amplitude", "damping_ratio"}) {
    EXPECT_EQ(all.text(fmt::format("{}_verdict", quantity))[peak], "inside") << run.out;
  }
  EXPECT_EQ(std::ranges::count(parts, "curve"), 2 * std::ranges::count(parts, "level"));
}

const std::string kBeam = R"(schema = "microslip.rig/1"
[beam]
length_m = 0.583
width_m = 0.040
thickness_m = 0.005
youngs_modulus_Pa = 2.07e11
mass_density_kg_per_m3 = 7850.0
[contact]
rod_radius_m = 0.030
stiffness_N_per_m = 1.7e5
[damping]
loss_factor = [0.0028, 0.0018, 0.0011]
[[mass]]
position_m = 0.55
mass_kg = 0.030
[excitation]
position_m = 0.55
channel = "force"
[[accelerometer]]
position_m = 0.55
channel = "acceleration"
)";

// A beam of seven modes whose frequency falls by 2 % while the joint slips: the mode's mass at the
// sensor falls by 7 % of that of the stuck mode, by which D would be wrong by four of its σ at
// small amplitudes. With the shape at each frequency D is that of the true joint, rms below 1.5 of
// its σ.
TEST(campaignKinds, ABlowOfABeamKnowsHowItsShapeMoves) {
  const Sandbox box{{"rig.toml", kBeam}, {"joint.json", kJointText}};
  expect_done(box, {"model", "rig.toml", "joint.json", "--out", "true.toml", "--quiet"});
  expect_done(box,
              {"march", "true.toml", "--release", "1:200um", "--duration", "4", "--sampling-rate",
               "4096", "--no-error-estimate", "--out", "march.csv", "--quiet"});
  RandomStream random(24, 1);
  box.put("blow.csv", test::noisy_record(box.get("march.csv"), 0.005, random));
  box.put("campaign.toml",
          test::replaced(campaign("", one_test("blow", "identify", "kind = \"ringdown\"\n")), "4e5",
                         "1.7e5"));
  expect_done(box, kCall);
  const CsvTable levels = table(box, "found/blow_levels.csv");
  ASSERT_GE(levels.rows(), 8U);
  const double sigmas = loss_over_sigma(levels, sample_joint());
  EXPECT_LT(sigmas, 1.5);
  test::record_largest("dissipation over sigma [1]", sigmas);
}

/// A record of the true joint in three cycles of each of ten amplitudes up to the largest, with
/// noise of 20 millionths of the path and 0.04 % of the force.
void record_loops(const Sandbox& box, const std::string& name, double largest, std::uint64_t seed) {
  constexpr int kAmplitudes = 10;
  constexpr int kCycles = 3;
  constexpr int kSamples = 120;  // a cycle
  std::vector<double> path;
  for (int n = 1; n <= kAmplitudes; ++n) {
    for (int i = 0; i < kCycles * kSamples; ++i) {
      path.push_back(largest * n / kAmplitudes * std::sin(2.0 * std::numbers::pi * i / kSamples));
    }
  }
  box.put(name, record_text(testing::simulated_record(true_joint(), path, seed,
                                                      {.displacement = 2e-5, .force = 4e-4})));
}

// Records of the joint by itself identify it as levels of their closed cycles, and are predicted: D
// and k_eq of the cycles in the band, what is missed of the force no more than twice its noise.
TEST(campaignKinds, LoopsIdentifyAndArePredicted) {
  const Sandbox box = laboratory();
  record_loops(box, "first.csv", 3e-4, 3);
  record_loops(box, "second.csv", 2.7e-4, 4);
  const std::string keys = "kind = \"loops\"\nforce = \"f\"\ndisplacement = \"u\"\n";
  box.put("campaign.toml", campaign("draws = 200\n", one_test("first", "identify", keys) +
                                                         one_test("second", "predict", keys)));
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("second.csv: loops"), std::string::npos) << run.out;
  const CsvTable all = table(box, "found/campaign.csv");
  const std::vector<std::string> parts = all.text("part");
  ASSERT_EQ(parts.back(), "record");
  const double missed = std::stod(all.text("force_nrmse").back());
  const CsvTable found = table(box, "found/comparison.csv");
  const std::vector<std::string> quantities = found.text("quantity");
  const auto noise = std::ranges::find(quantities, "force_noise") - quantities.begin();
  EXPECT_LT(missed, 2.0 * std::stod(found.text("predicted")[static_cast<std::size_t>(noise)]));
  // As many in the band as all but 5 % of the draws have there.
  EXPECT_EQ(box.get("found/comparison.csv").find("# warning: few_inside"), std::string::npos);
  EXPECT_GE(std::ranges::count(all.text("dissipation_verdict"), "inside"), 10) << run.out;
}

/// Levels of the true joint whose D is `gain` times it, with noise of 0.5 %, and frequencies with
/// 0.01 %.
std::string levels_of(double gain, double from, double to, std::uint64_t stream) {
  RandomStream random(31, stream);
  std::string text = "amplitude [m],dissipation [J]\n";
  constexpr int kLevels = 12;
  for (int i = 0; i < kLevels; ++i) {
    const double a = from + (to - from) * i / (kLevels - 1.0);
    text += fmt::format("{:.12g},{:.12g}\n", a,
                        gain * dissipation(true_joint(), a) * (1.0 + 0.005 * random.normal()));
  }
  return text;
}

/// Two tests of 20 Nm and two of 25 Nm, at which D is larger.
void tighten(const Sandbox& box, double gain,
             const std::string& swept = "conditions = { torque_Nm = 30 }\n") {
  record_sweep(box);
  std::string tests;
  for (const int torque : {20, 25}) {
    for (const int n : {1, 2}) {
      const std::string name = fmt::format("torque_{}_{}", torque, n);
      const double shift = 2e-6 * n + 1e-7 * torque;
      box.put(name + ".csv", levels_of(torque == 25 ? gain : 1.0, 3e-5 + shift, 2.7e-4 + shift,
                                       static_cast<std::uint64_t>(10 * torque + n)));
      tests +=
          one_test(name, "identify",
                   fmt::format("conditions = {{ torque_Nm = {}, order = \"rising\" }}\n", torque));
    }
  }
  box.put("campaign.toml", campaign("", tests + one_test("swept", "predict", swept)));
}

// D is 5 % larger at 25 Nm: a trend of ln(1.05)/5 = 0.98 % per Nm. 24 levels of 0.5 % a torque tell
// it to 0.5 %·√(2/24)/5 = 0.03 %.
TEST(campaignKinds, SaysWhatATorqueDoes) {
  const Sandbox box = laboratory();
  tighten(box, 1.05);
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("per Nm of torque"), std::string::npos) << run.out;
  const CsvTable found = table(box, "found/conditions.csv");
  ASSERT_EQ(found.rows(), 3U);
  EXPECT_EQ(found.text("condition"), (std::vector<std::string>{"order", "torque_Nm", "torque_Nm"}));
  EXPECT_EQ(found.text("value"), (std::vector<std::string>{"rising", "20", "25"}));
  EXPECT_EQ(found.numbers("levels", kDimensionless), (std::vector<double>{48, 24, 24}));
  EXPECT_EQ(found.numbers("tests", kDimensionless), (std::vector<double>{4, 2, 2}));
  const std::vector<double> offset = found.numbers("dissipation_offset", kDimensionless);
  const std::vector<double> sigma = found.numbers("dissipation_offset_std", kDimensionless);
  EXPECT_NEAR(offset[2] - offset[1], std::log(1.05), 0.006);
  EXPECT_NEAR(sigma[1], 0.005 / std::sqrt(24.0), 0.002);
  const std::string text = box.get("found/campaign.csv");
  EXPECT_NE(text.find("# warning: conditions_pooled: tests at torque 20, 25 Nm"),
            std::string::npos);
  EXPECT_NE(text.find("identify them separately"), std::string::npos);
  EXPECT_EQ(text.find("tests at order"), std::string::npos);  // all of one value
  EXPECT_NE(text.find("# warning: condition_not_identified: swept is predicted at torque 30 Nm"),
            std::string::npos);
}

// Tests of two torques that do not differ: put together, which is said, and no more.
TEST(campaignKinds, SaysThatTorquesDoNothing) {
  const Sandbox box = laboratory();
  tighten(box, 1.0, "conditions = { torque_Nm = 20 }\n");
  expect_done(box, kCall);
  const std::string text = box.get("found/campaign.csv");
  EXPECT_NE(text.find("# warning: conditions_pooled"), std::string::npos);
  EXPECT_EQ(text.find("identify them separately"), std::string::npos);
  EXPECT_EQ(text.find("condition_not_identified"), std::string::npos);
}

TEST(campaignKinds, NamesWhatIsWrong) {
  const Sandbox box = laboratory();
  record_loops(box, "loops.csv", 3e-4, 3);
  box.put("levels.csv", levels_of(1.0, 3e-5, 2.7e-4, 1));
  box.put("modal.csv", "mode,displacement [m],frequency [Hz]\n1,1e-4,79.8\n1,2e-4,79.6\n");
  box.put("sweep.csv",
          "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n"
          "79.5,1,10,0.3\n79.9,1,50,1.5\n80.3,1,12,2.8\n");
  const auto refused = [&](const std::string& test, const std::vector<std::string>& parts) {
    box.put("campaign.toml", campaign("", one_test("levels", "identify") + test));
    expect_refused(box, kCall, parts);
    EXPECT_FALSE(box.has("found"));
  };
  refused(one_test("loops", "predict"), {"test 'loops'", "kind = \"ringdown\""});
  refused(one_test("sweep", "predict", "kind = \"loops\"\n"),
          {"test 'sweep': kind", "'loops'", "a stepped-sine table"});
  refused(one_test("loops", "predict", "kind = \"sweep\"\n"),
          {"test 'loops': kind", "'sweep'", "a recording"});
  refused(one_test("modal", "identify"), {"test 'modal'", "must not be modal levels"});
  refused(one_test("modal", "predict", "kind = \"ringdown\"\nsensors = { a = \"acceleration\" }\n"),
          {"test 'modal': sensors", "a table of modal levels"});
  refused(one_test("sweep", "predict", "allow_truncated = true\n"),
          {"test 'sweep': allow_truncated", "a stepped-sine table"});
  refused(one_test("loops", "predict", "kind = \"loops\"\nforce = \"g\"\n"), {"loops.csv", "'g'"});
  refused(one_test("loops", "predict", "kind = \"ringdown\"\nsensors = { u = \"tip\" }\n"),
          {"test 'loops': sensor u=tip", "'tip'", "acceleration"});
  box.put("campaign.toml", campaign("", one_test("loops", "identify", "kind = \"ringdown\"\n")));
  expect_refused(box, kCall, {"loops.csv", "acceleration"});
}

}  // namespace
}  // namespace microslip::cli_test::campaign_kinds_test
