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
#include "microslip/io/csv.hpp"
#include "support/figures.hpp"

namespace microslip::cli_test::brake_reuss_test {
namespace {

namespace fs = std::filesystem;

const std::string kExample = MICROSLIP_EXAMPLES "/brake_reuss_beam/";

/// The stepped sines of the Brake–Reuß beam [Chen et al. and Jin et al., Mech. Syst. Signal
/// Process. 166 (2022) 108401, 108402]: identified by those of held response, predicted for those
/// of held force.
class BrakeReuss : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MICROSLIP_DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
    const fs::path file = fs::path(folder) / "brake_reuss_beam/ForcedFrequencyResponses.mat";
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    fs::copy_file(file, box_.file("sweeps.mat"));
    for (const char* name : {"rig.toml", "levels.csv"}) {
      fs::copy_file(kExample + name, box_.file(name));
    }
  }

  /// Force, amplitude and frequency of phase resonance of the sweeps of held force.
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

// The bound is that of the sessions: at one amplitude their damping differs by 3 to 6 %. The
// frequency is not expected to agree: the sessions differ by 0.5 Hz, and it is recorded.
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
    EXPECT_NEAR(peak.amplitude, amplitude[i], 0.04 * amplitude[i]) << force[i] << " N";
    test::record_deviation("peak amplitude", peak.amplitude, amplitude[i]);
    test::record_largest("frequency offset [Hz]", std::abs(peak.frequency - frequency[i]));
  }
}

}  // namespace
}  // namespace microslip::cli_test::brake_reuss_test
