// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/joint.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test::reduce_test {
namespace {

namespace fs = std::filesystem;

const std::string kRig = MICROSLIP_EXAMPLES "/reference_rig/";
constexpr int kLevels = 12;

std::string level_name(int level) {
  return "level_" + std::string(level < 10 ? "0" : "") + std::to_string(level) + ".csv";
}

/// The rig and its recordings, as a user has them in a folder.
class RigSandbox : public Sandbox {
 public:
  RigSandbox() {
    fs::copy_file(kRig + "rig.toml", file("rig.toml"));
    for (int i = 1; i <= kLevels; ++i) {
      fs::copy_file(kRig + "recordings/" + level_name(i), file(level_name(i)));
    }
  }
};

Arguments all_levels(const std::string& ending = "") {
  Arguments call{"reduce", "rig.toml"};
  for (int i = 1; i <= kLevels; ++i) {
    const std::string name = level_name(i);
    call.push_back(ending.empty() ? name : name.substr(0, name.size() - 4) + ending);
  }
  return call;
}

CsvTable table(const Sandbox& box, const std::string& name) {
  return CsvTable(box.get(name), name);
}

/// Of A and D against truth.csv, which another program computed: the largest relative errors.
std::pair<double, double> errors(const Sandbox& box, const std::string& name) {
  const CsvTable found = table(box, name);
  const CsvTable truth(test::get(kRig + "truth.csv"), "truth.csv");
  const std::vector<double> a = found.numbers("amplitude", kLength);
  const std::vector<double> d = found.numbers("dissipation", kEnergy);
  const std::vector<double> true_a = truth.numbers("amplitude", kLength);
  const std::vector<double> true_d = truth.numbers("dissipation", kEnergy);
  std::pair<double, double> largest{0.0, 0.0};
  for (std::size_t i = 2; i < a.size(); ++i) {  // above the noise
    largest.first = std::max(largest.first, std::abs(a[i] / true_a[i] - 1.0));
    largest.second = std::max(largest.second, std::abs(d[i] / true_d[i] - 1.0));
  }
  return largest;
}

// The lines before the table; that of the recordings is as `sha256sum level_*.csv | sha256sum`
// says.
TEST(reduce, RefusesARecordingThatIsThereTwice) {
  const RigSandbox box;
  fs::create_symlink(level_name(2), box.file("again.csv"));
  expect_refused(box, {"reduce", "rig.toml", level_name(2), "again.csv", "--out", "o.csv"},
                 {"again.csv = the same file as level_02.csv", "Leave one"});
}

TEST(reduce, TellsWhatItWasMadeOf) {
  const RigSandbox box;
  expect_done(box, with(all_levels(), {"--out", "levels.csv"}));
  const std::string many = box.get("levels.csv");
  std::string list;
  for (int i = 1; i <= kLevels; ++i) {
    list += sha256(box.get(level_name(i))) + "  " + level_name(i) + "\n";
  }
  const std::string rig = "\n# sha256[rig.toml] = " + sha256(box.get("rig.toml")) + "\n";
  EXPECT_NE(many.find(": microslip reduce rig.toml level_01.csv ... " + level_name(kLevels) +
                      " --out levels.csv" + rig + "# " + std::to_string(kLevels) +
                      " recordings: sha256sum | sha256sum " + sha256(list) + "\namplitude [m]"),
            std::string::npos)
      << many.substr(0, 400);

  expect_done(box, {"reduce", "rig.toml", "level_01.csv", "level_02.csv", "--out", "two.csv"});
  EXPECT_NE(
      box.get("two.csv").find(": microslip reduce rig.toml level_01.csv level_02.csv --out "
                              "two.csv" +
                              rig + "# sha256[level_01.csv] = " + sha256(box.get("level_01.csv")) +
                              "\n# sha256[level_02.csv] = " + sha256(box.get("level_02.csv")) +
                              "\namplitude [m]"),
      std::string::npos);

  // Options between the recordings are part of the call.
  Arguments split = all_levels();
  split.insert(split.begin() + 4, {"--order", "9"});
  expect_done(box, with(split, {"--out", "split.csv"}));
  EXPECT_NE(box.get("split.csv").find("--order 9 level_03.csv level_04.csv"), std::string::npos);
}

TEST(reduce, WritesTheLevelsOfTheExample) {
  const RigSandbox box;
  const Outcome run = expect_done(box, with(all_levels(), {"--out", "levels.csv"}));
  for (const char* part :
       {"12 records", "channel 'ldv'", "7, as in [test] of the rig,", "level_12"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
  }
  std::string header;
  const CsvTable levels = table(box, "levels.csv");
  for (const CsvColumn& column : levels.columns()) {
    header += column.name + (column.unit ? " [" + *column.unit + "]" : "") + ",";
  }
  EXPECT_EQ(
      header,
      "amplitude [m],dissipation [J],amplitude_std [m],dissipation_std [J],secant_stiffness "
      "[N/m],secant_stiffness_std [N/m],source,frequency [Hz],resonance_frequency [Hz],"
      "force_amplitude [N],response_amplitude [m/s^2],input_energy [J],linear_dissipation [J],"
      "damping_ratio [1],force_distortion [1],reversals [1],flags,");
  const auto [amplitude, dissipation] = errors(box, "levels.csv");
  EXPECT_LE(amplitude, 1e-3);
  EXPECT_LE(dissipation, 5e-3);
}

TEST(reduce, WithoutTheVibrometer) {
  const RigSandbox box;
  expect_done(box, with(all_levels(), {"--no-vibrometer", "--quiet", "--out", "levels.csv"}));
  EXPECT_LE(errors(box, "levels.csv").first, 1.2e-2);
}

TEST(reduce, ReadsEveryFormatAlike) {
  const RigSandbox box;
  expect_done(box, with(all_levels(), {"--quiet", "--out", "csv.csv"}));
  const std::vector<double> expected = table(box, "csv.csv").numbers("dissipation", kEnergy);
  for (const std::string ending : {".uff", ".mat", ".h5"}) {
    SCOPED_TRACE(ending);
    for (int i = 1; i <= kLevels; ++i) {
      const std::string name = level_name(i);
      expect_done(box, {"convert", name, name.substr(0, name.size() - 4) + ending, "--quiet"});
    }
    expect_done(box, with(all_levels(ending), {"--quiet", "--out", "other.csv"}));
    const std::vector<double> found = table(box, "other.csv").numbers("dissipation", kEnergy);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-12);  // the same samples
    }
    EXPECT_EQ(table(box, "other.csv").text("source")[0], "level_01" + ending);
  }
}

TEST(reduce, LeadsToTheJoint) {
  const RigSandbox box;
  expect_done(box, with(all_levels(), {"--quiet", "--out", "levels.csv"}));
  expect_done(box, {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "joint.json"});
  const Joint found = parse_joint(box.get("joint.json"), "joint.json").joint;
  const Joint truth = parse_joint(test::get(kRig + "joint.json"), "joint.json").joint;
  double difference = 0.0;
  double size = 0.0;
  for (double f = 5.0; f <= 45.0; f += 0.05) {  // 10 to 90 % of 50 N
    difference += std::pow(found.density().density(f) - truth.density().density(f), 2);
    size += std::pow(truth.density().density(f), 2);
  }
  EXPECT_LE(std::sqrt(difference / size), 0.04);
}

TEST(reduce, LevelsWithInnerReversalsAreLeftOut) {
  const Sandbox box;
  std::string text = "amplitude [um],dissipation [uJ],reversals [1]\n";
  for (int i = 1; i <= 20; ++i) {
    text += std::to_string(10 * i) + "," + std::to_string(i * i * (10 + i) / 40.0) + "," +
            (i == 7 ? "4" : "2") + "\n";
  }
  box.put("levels.csv", text);
  const Arguments call{"identify", "levels.csv", "--stiffness", "1e5", "--out", "joint.json"};
  const Outcome left_out = expect_done(box, call);
  EXPECT_NE(left_out.out.find("19"), std::string::npos);
  EXPECT_NE(left_out.out.find("1 level (line 8), left out"), std::string::npos) << left_out.out;
  const Outcome used = expect_done(box, with(call, {"--inner-reversals", "use"}));
  EXPECT_NE(used.out.find("used nevertheless"), std::string::npos) << used.out;
}

/// One mode of 80 Hz with a loss factor of 0.01 that is the joint's, D = π η ω² q², under 1 N, from
/// 78.2 Hz in steps of so many Hz.
std::string one_mode_sweep(double step) {
  std::string text = "frequency [Hz],force [N],acceleration [m/s^2],phase [deg]\n";
  for (double f = 78.2; f < 82.0; f += step) {
    const double real = 80.0 * 80.0 - f * f;
    const double imaginary = 0.01 * 80.0 * 80.0;
    const double acceleration = f * f * 0.49 / std::hypot(real, imaginary);
    text += std::to_string(f) + ",1," + std::to_string(acceleration) + "," +
            std::to_string(std::atan2(imaginary, real) * 180.0 / std::numbers::pi - 180.0) + "\n";
  }
  return text;
}

TEST(reduce, SteppedSineTable) {
  const Sandbox box;
  box.put("rig.toml", R"(schema = "microslip.rig/1"
[modes]
frequency_Hz = [80.0]
excitation = [0.7]
joint = [0.7]
[damping]
loss_factor = [0.0]
[excitation]
channel = "force"
[[accelerometer]]
shape = [0.7]
channel = "acc1"
)");
  const double omega = 2.0 * std::numbers::pi * 80.0;
  const double displacement = 0.49 / (0.01 * omega * omega);  // at the resonance, per newton
  // Steps of 7 and of 53° of phase: the rule between them is exact for this mode, the table has six
  // digits.
  for (const double step : {0.05, 0.4}) {
    box.put("sweep.csv", one_mode_sweep(step));
    const Outcome run =
        expect_done(box, {"reduce", "rig.toml", "sweep.csv", "--out", "levels.csv"});
    const CsvTable levels = table(box, "levels.csv");
    EXPECT_NEAR(levels.numbers("frequency", kFrequency)[0], 80.0, 1e-5);
    const double force = levels.numbers("force_amplitude", kForce)[0];
    EXPECT_NEAR(levels.numbers("amplitude", kLength)[0] / (displacement * force), 1.0, 1e-5);
    EXPECT_NEAR(levels.numbers("dissipation", kEnergy)[0] /
                    (std::numbers::pi * displacement * force * force),
                1.0, 1e-5);
    // A first file that is not there decides nothing of the others.
    const Outcome rest = box.run(
        {"reduce", "rig.toml", "missing.csv", "sweep.csv", "--skip-faulty", "--out", "rest.csv"});
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_EQ(table(box, "rest.csv").rows(), 1U);
    const bool coarse = step > 0.1;
    EXPECT_EQ(levels.text("flags")[0], coarse ? "coarse_steps" : "");
    for (const std::string& text : {run.out, box.get("levels.csv")}) {
      EXPECT_EQ(text.find("changes by 53°") != std::string::npos, coarse) << text;
    }
  }
  fs::copy_file(kRig + "recordings/level_05.csv", box.file("level_05.csv"));
  expect_refused(box, {"reduce", "rig.toml", "sweep.csv", "level_05.csv", "--out", "more.csv"},
                 {"level_05.csv", "stepped-sine"});
}

TEST(reduce, NamesWhatIsWrong) {
  const RigSandbox box;
  const std::string level = box.get("level_05.csv");
  const std::string rig = box.get("rig.toml");
  const auto refused = [&](const std::string& recording, const std::vector<std::string>& parts) {
    box.put("bad.csv", recording);
    expect_refused(box, {"reduce", "rig.toml", "bad.csv", "--out", "levels.csv"}, parts);
  };
  refused(test::replaced(level, "acc2 [m/s^2]", "other [m/s^2]"), {"bad.csv", "'acc2'", "missing"});
  refused(test::replaced(level, "force [N]", "force [m]"), {"bad.csv", "'force'", "force"});
  refused(test::replaced(level, "force [N]", "force"),
          {"bad.csv", "'force'", "--assume-units force=N"});
  refused(test::replaced(level, "force [N]", "force [stone]"), {"bad.csv", "'stone'"});
  refused(level.substr(0, level.find('\n', 4000) + 1), {"bad.csv", "fewer than 3"});
  refused("", {"bad.csv"});
  refused("time [s],force [N]\n0,1\n1,nan\n", {"bad.csv:3", "nan"});
  const Arguments call{"reduce", "rig.toml", "level_05.csv", "--out", "levels.csv"};
  box.put("rig.toml", test::replaced(rig, "length_m", "lenght_m"));
  expect_refused(box, call, {"rig.toml", "lenght_m", "length_m"});
  box.put("rig.toml", test::replaced(rig, "channel = \"force\"", "channel = \"Force\""));
  expect_refused(box, call, {"level_05.csv", "'Force'", "'force'"});
  box.put("rig.toml",
          test::replaced(rig, "stiffness_N_per_m = 1.7e5", "stick_frequency_Hz = 95.0"));
  expect_refused(box, call, {"rig.toml", "stick_frequency_Hz", "95"});
  box.put("rig.toml", rig);
  expect_refused(box, {"reduce", "rig.toml", "none.csv", "--out", "levels.csv"}, {"none.csv"});
  expect_refused(box, {"reduce", "rig.toml", "level_05.csv", "--out", "none/levels.csv"}, {"none"});
  expect_refused(box, with(call, {"--frequency", "70"}), {"level_05.csv", "70"});
  expect_refused(box, with(call, {"--frequency", "0"}), {"--frequency", "above 0"});
}

TEST(reduce, ForceOfTheWrongSignIsTold) {
  const RigSandbox box;
  const CsvTable level = table(box, "level_05.csv");
  std::string text = "time [s],force [N],acc1 [m/s^2],acc2 [m/s^2],acc3 [m/s^2],ldv [m]\n";
  for (std::size_t i = 0; i < level.rows(); ++i) {
    text += level.text("time")[i];
    for (const char* name : {"force", "acc1", "acc2", "acc3", "ldv"}) {
      const std::string cell = level.text(name)[i];
      const bool negative = cell.starts_with('-');
      text += "," + (name != std::string("force") ? cell : negative ? cell.substr(1) : "-" + cell);
    }
    text += "\n";
  }
  box.put("bad.csv", text);
  expect_refused(box, {"reduce", "rig.toml", "bad.csv", "--out", "levels.csv"},
                 {"bad.csv", "dissipation", "sign and unit of the force"});
}

TEST(reduce, LeavesOutFaultyFilesWhenTold) {
  const RigSandbox box;
  box.put("bad.csv", "nothing\n");
  const Arguments call{"reduce", "rig.toml", "bad.csv", "level_05.csv", "--out", "levels.csv"};
  expect_refused(box, call, {"bad.csv"});
  const Outcome run = expect_done(box, with(call, {"--skip-faulty"}));
  EXPECT_NE(run.out.find("Left out: bad.csv"), std::string::npos) << run.out;
  EXPECT_EQ(table(box, "levels.csv").rows(), 1U);
  EXPECT_NE(box.get("levels.csv").find("\n# warning: left_out: Left out: bad.csv"),
            std::string::npos);
}

// What the reader of a record had to forgive is in the table, quiet or not.
TEST(reduce, WarningsOfRecordsAreInTheFile) {
  const RigSandbox box;
  const std::string record = box.get("level_05.csv");
  box.put("cut.csv", record.substr(0, record.size() - 4));
  const Arguments call{"reduce", "rig.toml",   "cut.csv", "--allow-truncated",
                       "--out",  "levels.csv", "--quiet"};
  EXPECT_EQ(expect_done(box, call).err, "");
  EXPECT_NE(box.get("levels.csv").find("\n# warning: "), std::string::npos)
      << box.get("levels.csv");
}

}  // namespace
}  // namespace microslip::cli_test::reduce_test
