// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/csv.hpp"

namespace microslip::cli_test {
namespace {

Sandbox sandbox() { return Sandbox{{"decay.csv", sample_decay_text()}}; }

Arguments call(const Arguments& more = {}) {
  Arguments arguments{"ringdown", "decay.csv", "--modal-mass", "2", "--out", "levels.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ringdown, WritesLevelsOfADecay) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, call({"--joint-ratio", "0.25"}));
  for (const char* part :
       {"Ring-down", "decay.csv, acc1", "joint amplitude", "frequency", "the record ends"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
  }
  const CsvTable table(box.get("levels.csv"), "levels.csv");
  const std::vector<double> time = table.numbers("decay_time", kTime);
  const std::vector<double> amplitude = table.numbers("amplitude", kLength);
  const std::vector<double> dissipation = table.numbers("dissipation", kEnergy);
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> damping = table.numbers("damping_ratio", kDimensionless);
  ASSERT_GT(time.size(), 5U);
  const SampleDecay decay;
  const double omega0 = 2.0 * std::numbers::pi * decay.frequency;
  const double delta0 = decay.damping * omega0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double s = 1.0 + delta0 * time[i];
    const double omega = omega0 * (1.0 + 0.01 * std::log(s));
    const double a = decay.amplitude * omega0 * omega0 / s / (omega * omega);
    // The rate of decay of the acceleration is all that D needs: D = 2πmωA²δ_acc. Model and decay differ
    // by ζ² and by the fourth derivative of the phase, 1e−4 each.
    EXPECT_NEAR(amplitude[i] / (0.25 * a), 1.0, 1e-3);
    EXPECT_NEAR(frequency[i] * 2.0 * std::numbers::pi / omega, 1.0, 1e-4);
    EXPECT_NEAR(damping[i] / (delta0 / s / omega), 1.0, 2e-3);
    EXPECT_NEAR(dissipation[i] / (2.0 * std::numbers::pi * 2.0 * omega * a * a * delta0 / s), 1.0,
                3e-3);
  }
  for (const char* column : {"frequency_std", "damping_ratio_std"}) {
    EXPECT_TRUE(table.has(column)) << column;  // what `identify` weighs measured frequencies by
  }
  EXPECT_EQ(table.text("source").front(), "decay.csv");
  EXPECT_EQ(table.text("flags").front(), "");
}

TEST(ringdown, GivesLevelsThatIdentifyTakes) {
  const Sandbox box = sandbox();
  expect_done(box, call({"--quiet"}));
  expect_done(box, call({"--quiet"}));  // levels may replace levels
  EXPECT_EQ(box.run({"identify", "levels.csv", "--stiffness", "1e5", "--out", "j.json"}).status, 0);
}

TEST(ringdown, IsQuietAndWritesToStandardOutput) {
  const Sandbox box = sandbox();
  EXPECT_EQ(expect_done(box, call({"--quiet"})).out, "");
  const Outcome run = box.run({"ringdown", "decay.csv", "--modal-mass", "2", "--out", "-",
                               "--joint-stiffness", "1e5", "--stick-frequency", "54"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.find("\namplitude [m],dissipation [J],amplitude_std [m],dissipation_std "
                           "[J],secant_stiffness [N/m]") != std::string::npos)
      << run.out;
  EXPECT_NE(run.err.find("Ring-down"), std::string::npos);
}

TEST(ringdown, GivesDampingAloneWithoutModalMass) {
  const Sandbox box = sandbox();
  expect_done(box, {"ringdown", "decay.csv", "--out", "damping.csv"});
  expect_done(box, {"ringdown", "decay.csv", "--quiet", "--out", "damping.csv"});
  const CsvTable table(box.get("damping.csv"), "damping.csv");
  EXPECT_FALSE(table.has("dissipation"));
  for (const char* column : {"amplitude_std", "frequency_std", "damping_ratio_std", "flags"}) {
    EXPECT_TRUE(table.has(column)) << column;
  }
  expect_refused(box, {"identify", "damping.csv", "--stiffness", "1e5", "--out", "j.json"},
                 {"damping.csv", "'dissipation'", "--modal-mass"});
  expect_refused(box, {"ringdown", "decay.csv", "--loss-factor", "0.01", "--out", "damping.csv"},
                 {"--loss-factor", "--modal-mass"});
}

TEST(ringdown, SaysStartBandAndWarningsInTheFile) {
  const Sandbox box = sandbox();
  expect_done(box, call({"--quiet"}));
  const std::string text = box.get("levels.csv");
  for (const char* part :
       {"# microslip ", "# sensors: acc1", "# free decay from: 0 s", "# band: "}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text.substr(0, 600);
  }
}

/// A hammer blow on a real bolted beam, three accelerometers; see the README beside it.
TEST(ringdown, SensorsOfARealBlowAgreeOrAreFlagged) {
  const char* folder = std::getenv("MICROSLIP_DATA_DIR");
  if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
  const std::string record = std::string(folder) + "/brake_reuss_beam/HammerImpact.mat";
  const Sandbox box;
  for (const std::string frequency : {"80.5", "297.7", "845.7", "1526.8"}) {
    const Outcome run = box.run({"ringdown", record, "--assume-units", "SI", "--frequency",
                                 frequency, "--channel", "acc1", "--channel", "acc2", "--channel",
                                 "acc3", "--quiet", "--out", "levels.csv"});
    ASSERT_EQ(run.status, 0) << run.err;
    const CsvTable table(box.get("levels.csv"), "levels.csv");
    const std::vector<double> time = table.numbers("decay_time", kTime);
    const std::vector<double> f = table.numbers("frequency", kFrequency);
    EXPECT_GT(time.front(), 0.0) << frequency;
    EXPECT_GE(time.size(), 8U) << frequency;  // the fastest has 9
    for (const double each : f) EXPECT_NEAR(each / std::stod(frequency), 1.0, 0.01);
    // Two sensors that differ beyond their deviations are said to, in the file.
    const bool said =
        box.get("levels.csv").find("# warning: sensors_differ: acc1 and acc2 differ") !=
        std::string::npos;
    const std::vector<std::string> flags = table.text("flags");
    const bool flagged = std::ranges::any_of(flags, [](const std::string& all) {
      return all.find("sensors_differ") != std::string::npos;
    });
    EXPECT_TRUE(flagged || !said) << frequency;
    // acc2 is near a node of the first mode: 4 % of the amplitude of acc1.
    if (frequency == "80.5") {
      EXPECT_TRUE(flagged);
    }
  }
}

TEST(ringdown, TakesUnitsAndRanges) {
  const Sandbox box = sandbox();
  box.put("decay.csv", replaced(sample_decay_text(), "acc1 [m/s^2]", "acc1"));
  expect_refused(box, call(), {"decay.csv", "'acc1'", "--assume-units"});
  expect_done(box, call({"--assume-units", "acc1=m/s^2", "--frequency", "50Hz", "--band", "40:70",
                         "--from", "100ms", "--to", "1.5"}));
  const CsvTable table(box.get("levels.csv"), "levels.csv");
  EXPECT_GT(table.numbers("decay_time", kTime).front(), 0.1);
  EXPECT_LT(table.numbers("decay_time", kTime).back(), 1.5);
}

TEST(ringdown, RefusesBadCalls) {
  const Sandbox box = sandbox();
  expect_refused(box, call({"--channel", "ldv"}), {"decay.csv", "'ldv'", "missing", "'acc1'"});
  expect_refused(box, call({"--band", "40"}), {"--band", "LOW:HIGH"});
  expect_refused(box, call({"--band", "70:40"}), {"band", "must rise"});
  expect_refused(box, call({"--frequency", "5"}), {"decay.csv", "'acc1'", "5"});
  expect_refused(box, call({"--joint-ratio", "0"}), {"joint_ratio", "not 0"});
  expect_refused(box, call({"--loss-factor", "0.5"}), {"--loss-factor", "exceeds"});
  expect_refused(box, call({"--joint-stiffness", "1e5"}), {"stick_frequency"});
  expect_refused(box, call({"--assume-units", "acc1"}), {"--assume-units", "CHANNEL=UNIT"});
  expect_refused(box, call({"--assume-units", "ldv=m"}), {"decay.csv", "'ldv'"});
  expect_refused(box, call({"--from", "1.95"}), {"decay.csv", "too short"});
  expect_refused(box, {"ringdown", "none.csv", "--modal-mass", "2", "--out", "levels.csv"},
                 {"none.csv"});
  expect_refused(box, {"ringdown", "decay.csv", "--modal-mass", "0", "--out", "levels.csv"},
                 {"modal_mass", "above 0"});
}

TEST(ringdown, SaysWhenTheDecayEndsEarly) {
  // The mode comes back at half of its amplitude after 1 s.
  const CsvTable table(sample_decay_text(), "decay.csv");
  const std::vector<double> time = table.numbers("time", kTime);
  std::vector<double> acceleration = table.numbers("acc1", kAcceleration);
  for (std::size_t i = time.size() / 2; i < time.size(); ++i) {
    acceleration[i] += 0.5 * acceleration[i - time.size() / 2];
  }
  CsvWriter writer;
  writer.add_numbers("time", kTime, time);
  writer.add_numbers("acc1", kAcceleration, acceleration);
  const Sandbox box{{"decay.csv", writer.str()}};
  const Outcome run = box.run(call());
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.out.find("warning"), std::string::npos) << run.out;
  const std::string flags = CsvTable(box.get("levels.csv"), "levels.csv").text("flags").front();
  EXPECT_TRUE(flags == "amplitude_rises" || flags == "mode_lost") << flags;
}

}  // namespace
}  // namespace microslip::cli_test
