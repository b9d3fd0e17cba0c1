// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test::brake_reuss_test {
namespace {

namespace fs = std::filesystem;

const std::string kExample = MICROSLIP_EXAMPLES "/brake_reuss_beam/";

/// The stepped sines of the Brake–Reuß beam [Chen et al. and Jin et al., Mech. Syst. Signal
/// Process. 166 (2022) 108401, 108402]: identified from those at constant response, predicted for
/// those at constant force.
class BrakeReuss : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MICROSLIP_DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
    const fs::path file = fs::path(folder) / "brake_reuss_beam/ForcedFrequencyResponses.mat";
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file("sweeps.mat"));
    for (const char* name : {"rig.toml", "levels.csv", "campaign.toml"}) {
      fs::copy_file(kExample + name, box_.file(name));
    }
  }

  /// Force, amplitude and frequency of phase resonance of the sweeps at constant force.
  CsvTable measured() const {
    const Outcome run = box_.run({"reduce", "rig.toml", "sweeps.mat:FRdata.ForceControl", "--out",
                                  "measured.csv", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
    return {box_.get("measured.csv"), "measured.csv"};
  }

  struct Peak {
    double amplitude = 0.0;  ///< m
    double frequency = 0.0;  ///< Hz
  };

  Peak predicted(double force) const {
    expect_done(box_, {"frf", "model.toml", "--force", fmt::format("{}", force), "--frequency",
                       "78:82", "--out", "frf.csv", "--quiet"});
    const CsvTable table(box_.get("frf.csv"), "frf.csv");
    const std::vector<double> x = table.numbers("displacement", kLength);
    const auto at = std::ranges::max_element(x) - x.begin();
    return {x[static_cast<std::size_t>(at)],
            table.numbers("frequency", kFrequency)[static_cast<std::size_t>(at)]};
  }

  Sandbox box_;
};

/// Of the amplitude at resonance: at one amplitude the damping of the sessions differs by 6 to 7 %,
/// and the amplitude goes with the 1/(1 + p)th power of it, D ~ X^{2+p}, p = 0.4 at the lowest of
/// these forces.
constexpr double kSessions = 0.07 / 1.4;

// The frequency is not expected to agree: the sessions differ by 0.5 Hz, and it is recorded.
TEST_F(BrakeReuss, PeaksOfTheOtherSweepsFollowFromLinearDampingAndSlip) {
  const Outcome run = box_.run({"identify", "levels.csv", "--stiffness", "5.08e5",
                                "--linear-damping", "fit", "--out", "joint.json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  expect_done(box_, {"model", "rig.toml", "joint.json", "--out", "model.toml"});
  const CsvTable table = measured();
  const std::vector<double> force = table.numbers("force_amplitude", kForce);
  const std::vector<double> amplitude = table.numbers("amplitude", kLength);
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  ASSERT_EQ(force.size(), 4U);
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Peak peak = predicted(force[i]);
    EXPECT_NEAR(peak.amplitude, amplitude[i], kSessions * amplitude[i]) << force[i] << " N";
    test::record_deviation("peak amplitude", peak.amplitude, amplitude[i]);
    test::record_largest("frequency offset [Hz]", std::abs(peak.frequency - frequency[i]));
  }
}

/// The model of the tutorial, with the spread from the eight sweeps at constant response.
const std::string kDrawn = R"(schema = "microslip.model/1"
[structure]
frequency_Hz = [80.38]
frequency_std = [0.0044]
loss_factor = [0.0]
[[structure.point]]
name = "drive point"
shape = [0.7085]
[[joint]]
file = "joint.json"
samples = "joint_samples.h5"
shape = [0.7085]
spring_in_modes_N_per_m = 4.88e5
[excitation]
point = "drive point"
gain_std = 0.021
)";

// Each step at the force that it had. Amplitudes at resonance within what the sessions differ by.
// Their band knows nothing of that: three of four are inside, all values of the peaks no more than
// 0.5 % beyond, and what an edge of 1000 draws is known to, 2.67σ/√1000, σ = 2.2 %; frequencies are
// inside. Of the amplitudes over the curve so many are as 1 − 0.95 of the draws have, at least. The
// sweep's peak is that of `reduce`. In the studies alone: docs/tutorial_brake_reuss_beam.md,
// section 6, makes these calls and compares what they print.
TEST_F(BrakeReuss, SweepsOfHeldForceLieAtTheEdgeOfTheBandOfTheOthers) {
  MICROSLIP_STUDY();
  expect_done(box_, {"identify", "levels.csv", "--stiffness", "4.88e5", "--linear-damping", "fit",
                     "--dissipation-gain-std", "2.1%", "--seed", "2", "--samples", "1000",
                     "--samples-out", "joint_samples.h5", "--out", "joint.json", "--quiet"});
  box_.put("drawn.toml", kDrawn);
  expect_done(box_, {"verify", "drawn.toml", "sweeps.mat:FRdata.ForceControl", "--draws", "1000",
                     "--seed", "2", "--out", "comparison.csv", "--quiet"});
  const std::string text = box_.get("comparison.csv");
  EXPECT_EQ(text.find("# warning: few_inside"), std::string::npos);
  EXPECT_NE(text.find("joint_not_of_this_kind"), std::string::npos);  // of the levels' frequencies
  const CsvTable table(text, "comparison.csv");
  const std::vector<std::string> part = table.text("part");
  const std::vector<std::string> quantity = table.text("quantity");
  const std::vector<std::string> verdict = table.text("verdict");
  const std::vector<std::string> found = table.text("measured");
  const std::vector<std::string> prediction = table.text("predicted");
  const std::vector<double> amplitude = measured().numbers("amplitude", kLength);
  const std::vector<std::string> known_to = table.text("measured_std");
  const std::vector<std::string> lower = table.text("lower");
  const std::vector<std::string> upper = table.text("upper");
  std::size_t peaks = 0;
  int outside = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (part[row] != "peak") continue;
    EXPECT_GE(std::stod(found[row]), 0.993 * std::stod(lower[row])) << quantity[row];
    EXPECT_LE(std::stod(found[row]), 1.007 * std::stod(upper[row])) << quantity[row];
    if (quantity[row] == "frequency") {
      EXPECT_EQ(verdict[row], "inside");
    }
    if (quantity[row] != "displacement") continue;
    outside += verdict[row] == "inside" ? 0 : 1;
    ASSERT_LT(peaks, amplitude.size());
    EXPECT_NEAR(std::stod(found[row]), amplitude[peaks], 1e-9 * amplitude[peaks]);
    EXPECT_NEAR(std::stod(prediction[row]), amplitude[peaks], kSessions * amplitude[peaks]);
    // By the scatter of their steps, which are not finer or coarser than 5 and 35° and of one
    // shaker.
    EXPECT_GT(std::stod(known_to[row]), 0.003 * amplitude[peaks]);
    EXPECT_LT(std::stod(known_to[row]), 0.02 * amplitude[peaks]);
    ++peaks;
  }
  EXPECT_EQ(peaks, 4U);
  EXPECT_LE(outside, 1);
  EXPECT_NE(text.find("# warning: coarse_steps: sweeps.mat:FRdata.ForceControl(1)"),
            std::string::npos);
}

// The example, with the sweeps by their name here. The bounds are those of the test above, and the
// spread of the frequency that is found is the 0.44 % that the tutorial finds from the same levels.
// In the studies alone: the tutorial, section 7, runs the example and compares what it prints.
TEST_F(BrakeReuss, ACampaignPredictsSweepsOfHeldForceByThoseOfHeldResponse) {
  MICROSLIP_STUDY();
  box_.put(
      "campaign.toml",
      test::replaced(test::replaced(box_.get("campaign.toml"),
                                    "ForcedFrequencyResponses.mat:FRdata.R", "sweeps.mat:FRdata.R"),
                     "ForcedFrequencyResponses.mat:FRdata.F", "sweeps.mat:FRdata.F"));
  expect_done(box_, {"campaign", "campaign.toml", "--out", "campaign", "--quiet"});
  const std::string text = box_.get("campaign/campaign.csv");
  EXPECT_NE(text.find("joint_not_of_this_kind"), std::string::npos);  // of the levels' frequencies
  EXPECT_NE(text.find("# warning: frequency_rises"), std::string::npos);
  const CsvTable table(text, "campaign.csv");
  const std::vector<std::string> part = table.text("part");
  std::size_t peaks = 0;
  int outside = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (part[row] != "peak") continue;
    ++peaks;
    outside += table.text("amplitude_verdict")[row] == "inside" ? 0 : 1;
    EXPECT_EQ(table.text("frequency_verdict")[row], "inside");
    const double amplitude = std::stod(table.text("amplitude")[row]);
    EXPECT_NEAR(std::stod(table.text("amplitude_predicted")[row]), amplitude,
                kSessions * amplitude);
  }
  EXPECT_EQ(peaks, 4U);
  EXPECT_LE(outside, 1);
  const ModelFile model = read_model(box_.file("campaign/model.toml"));
  EXPECT_NEAR(model.spread.frequency.at(0), 0.0044, 5e-5);
}

// A blow on the same beam in another session, as the tutorial has it: the frequencies lie in the
// band of what those of the sweeps miss the model by. The damping ratio is -3 to 16 % above what
// the sweeps say, 8 % on the mean, by which of session, place of the accelerometer and other modes
// is not known: here 4 to 12 %, and it is reported.
TEST_F(BrakeReuss, ABlowIsPredictedBySweeps) {
  const fs::path file =
      fs::path(std::getenv("MICROSLIP_DATA_DIR")) / "brake_reuss_beam/HammerImpact.mat";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  fs::copy_file(file, box_.file("blow.mat"));
  std::string campaign = test::replaced(
      box_.get("campaign.toml"), "ForcedFrequencyResponses.mat:FRdata.R", "sweeps.mat:FRdata.R");
  campaign.resize(campaign.rfind("[[test]]"));
  box_.put("campaign.toml", campaign + R"([[test]]
name = "blow"
file = "blow.mat"
use = "predict"
kind = "ringdown"
sensors = { acc1 = "acceleration" }
assume_units = ["SI"]
session = "hammer"
)");
  expect_done(box_, {"campaign", "campaign.toml", "--out", "campaign", "--quiet"});
  const CsvTable table(box_.get("campaign/campaign.csv"), "campaign.csv");
  const std::vector<std::string> test = table.text("test");
  double sum = 0.0;
  int outside = 0;
  int ratios = 0;
  int frequencies = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (test[row] != "blow") continue;
    if (const std::string measured = table.text("damping_ratio")[row]; !measured.empty()) {
      outside += table.text("damping_ratio_verdict")[row] == "inside" ? 0 : 1;
      sum += std::stod(measured) / std::stod(table.text("damping_ratio_predicted")[row]) - 1.0;
      ++ratios;
    }
    if (table.text("frequency")[row].empty()) continue;
    ++frequencies;
    EXPECT_EQ(table.text("frequency_verdict")[row], "inside");
  }
  ASSERT_GE(ratios, 8);
  EXPECT_EQ(ratios, frequencies);
  EXPECT_GT(sum / ratios, 0.04);
  EXPECT_LT(sum / ratios, 0.12);
  test::record_largest("damping ratio of the blow, mean [1]", sum / ratios);
  EXPECT_GE(outside, 1);
}

}  // namespace
}  // namespace microslip::cli_test::brake_reuss_test
