// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test::verify_test {
namespace {

namespace fs = std::filesystem;

const std::string kRig = MICROSLIP_EXAMPLES "/reference_rig/";

/// The rig, its true joint and three recordings, as a user has them in a folder.
class RigSandbox : public Sandbox {
 public:
  RigSandbox() {
    for (const char* name : {"rig.toml", "joint.json"}) fs::copy_file(kRig + name, file(name));
    for (const char* name : {"level_01.csv", "level_05.csv", "level_12.csv"}) {
      fs::copy_file(kRig + "recordings/" + name, file(name));
    }
  }
};

const Arguments kCall{"verify",       "rig.toml",     "joint.json", "level_01.csv",
                      "level_05.csv", "level_12.csv", "--out",      "out.csv"};

CsvTable table(const Sandbox& box, const std::string& name) {
  return CsvTable(box.get(name), name);
}

std::string header_of(const CsvTable& found) {
  std::string header;
  for (const CsvColumn& column : found.columns()) {
    header += column.name + (column.unit ? " [" + *column.unit + "]" : "") + ",";
  }
  return header;
}

TEST(verify, ComparesEachChannelOfEachRecord) {
  const RigSandbox box;
  const Outcome run = expect_done(box, kCall);
  for (const char* part : {"3 records", "7 in the stick state", "NRMSE", "level_12.csv", "ldv"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
  }
  const CsvTable found = table(box, "out.csv");
  EXPECT_EQ(header_of(found),
            "source,channel,status,frequency [Hz],response_amplitude [m/s^2],NRMSE [1],"
            "noise_share [1],amplitude_ratio [1],phase_error [rad],joint_amplitude [m],"
            "predicted_joint_amplitude [m],input_energy [J],predicted_input_energy [J],"
            "frequency_offset [Hz],flags,");
  ASSERT_EQ(found.rows(), 15U);
  EXPECT_EQ(found.text("source")[5], "level_05.csv");
  EXPECT_EQ(found.text("channel")[5], "force");
  EXPECT_EQ(found.text("status")[5], "converged");
  const std::vector<double> nrmse = found.numbers("NRMSE", kDimensionless);
  const std::vector<double> noise = found.numbers("noise_share", kDimensionless);
  for (std::size_t i = 0; i < nrmse.size(); ++i) {
    // The true joint. The fit takes 22 of 512 degrees of freedom from the noise, (0.21 noise)^2;
    // near resonance the force feels what noise is left in the frequency of 14 cycles.
    const double allowed = found.text("channel")[i] == "force" ? 0.01 : 3e-4;
    EXPECT_LE(nrmse[i] * nrmse[i], (1.0 + 0.3 * 0.3) * noise[i] * noise[i] + allowed * allowed);
  }
  EXPECT_NE(box.get("out.csv").find("# sha256[rig.toml] = "), std::string::npos);
}

TEST(verify, EndsOnInterruptWhileItDraws) {
  const RigSandbox box;
  for (const int signal : {SIGINT, SIGTERM}) {
    expect_interruptible(box, with(kCall, {"--draws", "1000000", "--normal-load-std", "0.05"}),
                         signal, "draws");
  }
}

TEST(verify, AWrongJointIsWorse) {
  const RigSandbox box;
  expect_done(box, with(kCall, {"--quiet"}));
  const std::vector<double> right = table(box, "out.csv").numbers("NRMSE", kDimensionless);
  box.put("joint.json", test::replaced(box.get("joint.json"), "1.7e5", "1.53e5"));
  expect_done(box, with(kCall, {"--quiet"}));
  const std::vector<double> wrong = table(box, "out.csv").numbers("NRMSE", kDimensionless);
  EXPECT_GE(wrong[5], 20.0 * right[5]);  // the force of level 5
  for (const double offset : table(box, "out.csv").numbers("frequency_offset", kFrequency)) {
    EXPECT_LE(offset, -0.05);
  }
}

TEST(verify, WritesHarmonicsHistoriesAndPicture) {
  const RigSandbox box;
  expect_done(box, with(kCall, {"--harmonics-csv", "harmonics.csv", "--histories", "cycles.csv",
                                "--cycles", "3", "--picture", "picture.svg"}));
  const CsvTable harmonics = table(box, "harmonics.csv");
  ASSERT_EQ(harmonics.rows(), 30U);
  const std::vector<double> recorded = harmonics.numbers("acc1_recorded", kAcceleration);
  const std::vector<double> predicted = harmonics.numbers("acc1_predicted", kAcceleration);
  const std::vector<double> error = harmonics.numbers("acc1_recorded_std", kAcceleration);
  EXPECT_NEAR(predicted[20] / recorded[20], 1.0, 1e-9);  // the level of the last record
  for (const std::size_t row : {22U, 24U, 26U}) {        // third, fifth, seventh harmonic
    EXPECT_NEAR(predicted[row], recorded[row], 5.0 * error[row]) << row;
    EXPECT_GE(recorded[row], 100.0 * error[row]) << row;
  }
  EXPECT_NEAR(harmonics.numbers("acc1_recorded_phase", kAngle)[20], 0.0, 1e-9);
  const CsvTable histories = table(box, "cycles.csv");
  EXPECT_TRUE(
      header_of(histories).starts_with("source,time [s],force_recorded [N],force_predicted [N],"
                                       "acc1_recorded [m/s^2],acc1_predicted [m/s^2],"));
  const double rows = 2048.0 * (3.0 / 55.7 + 3.0 / 55.3 + 3.0 / 54.6);
  EXPECT_NEAR(static_cast<double>(histories.rows()), rows, 3.0);
  EXPECT_NE(box.get("picture.svg").find("<svg"), std::string::npos);
  EXPECT_NE(box.get("picture.svg").find("level_12.csv"), std::string::npos);
}

TEST(verify, WritesToStandardOutput) {
  const RigSandbox box;
  const Outcome run = box.run({"verify", "rig.toml", "joint.json", "level_05.csv", "--out", "-"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(CsvTable(run.out, "out").rows(), 5U);
  EXPECT_NE(run.err.find("Verification by 1 record\n"), std::string::npos) << run.err;
}

TEST(verify, WarnsBeyondTheIdentifiedRange) {
  const RigSandbox box;
  box.put("levels.csv",
          "amplitude [um],dissipation [uJ]\n10,0.4\n20,3\n40,24\n60,75\n80,165\n100,310\n");
  expect_done(box, {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "small.json"});
  Arguments call = kCall;
  call[2] = "small.json";
  const Outcome run = expect_done(box, call);
  EXPECT_NE(run.out.find("[beyond_identification (2 of 3 records, first"), std::string::npos)
      << run.out;
  const std::vector<std::string> flags = table(box, "out.csv").text("flags");
  EXPECT_EQ(flags[0].find("beyond_identification"), std::string::npos);
  EXPECT_NE(flags[14].find("beyond_identification"), std::string::npos);
  EXPECT_NE(box.get("out.csv").find(
                "\n# warning: beyond_identification (2 of 3 records, first level_05.csv): "),
            std::string::npos);
}

// Accelerations in a wrong unit: the exciter would move 0.33 m on a beam of 0.58 m, where the
// shortening, quadratic in it, rules a structure whose joint never slips and that nothing damps.
TEST(verify, WhatDoesNotConvergeIsWrittenAndMarked) {
  const RigSandbox box;
  std::string record = box.get("level_12.csv");
  for (const std::string name : {"acc1", "acc2", "acc3"}) {
    record = test::replaced(record, name + " [m/s^2]", name + " [km/s^2]");
  }
  box.put("level_01.csv", record);
  box.put("joint.json", R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1.7e5,
                            "density": [{"type": "atoms", "slip_force_N": [1e9], "weight": [1]}]})");
  box.put("rig.toml", test::replaced(box.get("rig.toml"), "[0.0028, 0.0018, 0.0011]", "[0.0]"));
  const Outcome run = box.run(kCall);
  EXPECT_EQ(run.status, 3) << run.out << run.err;
  EXPECT_NE(run.out.find("(!)"), std::string::npos) << run.out;
  EXPECT_EQ(table(box, "out.csv").text("status")[0], "not converged");
  EXPECT_NE(box.get("out.csv").find("\n# warning: not_converged: level_01.csv: "),
            std::string::npos);
}

TEST(verify, NamesWhatIsWrong) {
  const RigSandbox box;
  const std::string level = box.get("level_05.csv");
  const std::string rig = box.get("rig.toml");
  const auto refused = [&](const Arguments& call, const std::vector<std::string>& parts) {
    expect_refused(box, with(call, {"--out", "out.csv"}), parts);
  };
  box.put("bad.csv", test::replaced(level, "acc2 [m/s^2]", "other [m/s^2]"));
  refused({"verify", "rig.toml", "joint.json", "bad.csv"}, {"bad.csv", "'acc2'", "missing"});
  box.put("bad.csv", test::replaced(level, "force [N]", "force"));
  refused({"verify", "rig.toml", "joint.json", "bad.csv"}, {"bad.csv", "--assume-units force=N"});
  refused({"verify", "rig.toml", "rig.toml", "level_05.csv"}, {"rig.toml"});
  refused({"verify", "joint.json", "rig.toml", "level_05.csv"}, {"joint.json"});
  refused({"verify", "rig.toml", "level_05.csv", "level_05.csv"}, {"level_05.csv"});
  refused({"verify", "rig.toml", "none.json", "level_05.csv"}, {"none.json"});
  refused({"verify", "rig.toml", "joint.json", "none.csv"}, {"none.csv"});
  const Arguments call{"verify", "rig.toml", "joint.json", "level_05.csv"};
  refused(with(call, {"--picture", "picture.jpg"}), {"--picture", ".svg"});
  refused(with(call, {"--frequency", "70"}), {"level_05.csv", "70"});
  refused(with(call, {"--histories", "rig.toml"}), {"rig.toml"});
  // Before anything is read.
  const std::vector<std::string> twice{"standard output", "would be written twice"};
  expect_refused(box,
                 {"verify", "none.toml", "none.json", "none.csv", "--out", "-", "--histories", "-"},
                 twice);
  refused({"verify", "none.toml", "none.json", "none.csv", "--histories", "joint.json"},
          {"joint.json", "a table of predicted histories"});
  refused({"verify", "none.toml", "none.json", "none.csv", "--harmonics-csv", "out.csv"},
          {"out.csv", "would be written twice"});
  box.put("rig.toml",
          test::replaced(rig, "stiffness_N_per_m = 1.7e5", "stick_frequency_Hz = 95.0"));
  refused(call, {"rig.toml", "stick_frequency_Hz", "95"});
}

// Not an error: another beam may be what is to be tried. But it is said.
TEST(verify, ARecordOfAnotherRigIsFlagged) {
  const RigSandbox box;
  box.put("rig.toml", test::replaced(box.get("rig.toml"), "length_m = 0.583", "length_m = 0.60"));
  const Outcome run =
      box.run({"verify", "rig.toml", "joint.json", "level_05.csv", "--out", "out.csv"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("model_misfit"), std::string::npos) << run.out;
  EXPECT_GE(table(box, "out.csv").numbers("NRMSE", kDimensionless)[0], 1.0);
}

TEST(verify, LeavesOutFaultyFilesWhenTold) {
  const RigSandbox box;
  box.put("bad.csv", "nothing\n");
  const Arguments call{"verify",       "rig.toml", "joint.json", "bad.csv",
                       "level_05.csv", "--out",    "out.csv"};
  expect_refused(box, call, {"bad.csv"});
  const Outcome run = expect_done(box, with(call, {"--skip-faulty"}));
  EXPECT_NE(run.out.find("Left out: bad.csv"), std::string::npos) << run.out;
  EXPECT_EQ(table(box, "out.csv").rows(), 5U);
}

}  // namespace
}  // namespace microslip::cli_test::verify_test
