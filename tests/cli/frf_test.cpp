// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "cli/shown_calls.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/reference_csv.hpp"

namespace microslip::cli_test::frf_test {
namespace {

constexpr double pi = std::numbers::pi;

const std::string kHeader =
    "frequency [Hz],force [N],displacement [m],phase [rad],velocity [m/s],acceleration "
    "[m/s^2],dissipation [J],linear_dissipation "
    "[J],amplitude_joint [m],dissipation_joint [J],reversals_joint [1],energy_imbalance [1],peak "
    "[1]\n";

const std::string kJenkins =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 0.25,
        "density": [{"type": "atoms", "slip_force_N": [0.2], "weight": [1]}]})";

/// Loses no energy.
const std::string kUndamped =
    "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [10]\ndamping_ratio = [0]\n"
    "[[structure.point]]\nname = \"mass\"\nshape = [1]\n[excitation]\npoint = \"mass\"\n";

Arguments frf(const Arguments& more) {
  Arguments all{"frf", "model.toml", "--out", "frf.csv"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The number behind a name in a text: "displacement" of "displacement 0.8 m".
double number_behind(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name + " ");
  if (at == std::string::npos) return std::nan("");
  return std::stod(text.substr(at + name.size() + 1));
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

// ---- The numbers. ----

// Figures of another program, one harmonic, exact integrals. 4096 samples leave 2e-8.
TEST(frf, HasThePeaksOfOneHarmonic) {
  const auto reference = testing::reference_table("sdof_peak.csv");
  ASSERT_EQ(reference.rows(), 3U);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const Sandbox box = one_mass();
    if (row == 2) box.put("joint.json", kJenkins);
    expect_done(box, frf({"--force", std::to_string(reference["force [N]"][row]), "--frequency",
                          "0.13:0.17", "--harmonics", "1", "--samples", "4096"}));
    const std::string text = box.get("frf.csv");
    const std::string peak = text.substr(text.find("# peak:"));
    const double displacement = reference["peak_displacement [m]"][row];
    const double frequency = reference["frequency [Hz]"][row];
    EXPECT_NEAR(number_behind(peak, "displacement"), displacement, 1e-6 * displacement);
    EXPECT_NEAR(number_behind(peak, "frequency"), frequency, 1e-6 * frequency);
    EXPECT_EQ(number_behind(peak, "force"), reference["force [N]"][row]);
  }
}

// At constant response the mass is equivalent-linear: with the describing function of the joint
// F = a |k + k_eq(a) − ω² + i(cω + D(a)/(πa²))|. Tolerance: 4096 samples leave 2e-8 of the joint's
// force, and near resonance the sum is a hundredth of its parts.
TEST(frf, AtConstantResponseIsThatOfTheEquivalentLinearMass) {
  const Sandbox box = one_mass();
  const Joint joint = read_joint(box.file("joint.json")).joint;
  for (const std::string response : {"100mm", "1", "3"}) {
    expect_done(box, frf({"--response", response, "--frequency", "0.12:0.18", "--harmonics", "1",
                          "--samples", "4096"}));
    const CsvTable table(box.get("frf.csv"), "frf.csv");
    const std::vector<double> f = table.numbers("frequency", kFrequency);
    const std::vector<double> force = table.numbers("force", kForce);
    const std::vector<double> displacement = table.numbers("displacement", kLength);
    const std::vector<double> phase = table.numbers("phase", kAngle);
    ASSERT_GE(f.size(), 20U);
    EXPECT_EQ(f.front(), 0.12);
    EXPECT_NEAR(f.back(), 0.18, 1e-12);
    const double a = response == "100mm" ? 0.1 : std::stod(response);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double omega = 2.0 * pi * f[i];
      const std::complex<double> stiffness(0.75 + secant_stiffness(joint, a) - omega * omega,
                                           0.01 * omega + dissipation(joint, a) / (pi * a * a));
      EXPECT_NEAR(displacement[i], a, 1e-10 * a);
      EXPECT_NEAR(force[i], a * std::abs(stiffness), 1e-5 * force[i]) << f[i];
      EXPECT_NEAR(phase[i], std::arg(stiffness), 1e-5) << f[i];
    }
  }
}

// A joint that never slips on a mass that feels it only by its shortening, a Duffing oscillator:
// |1 − ω² + ¾βa² + iηω| a = F with β = ½kΓ². Two harmonics hold all of it.
TEST(frf, KeepsTheOrderOfACurveThatTurnsBack) {
  const Sandbox box;
  box.put("joint.json",
          R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 100, "density": []})");
  box.put("model.toml",
          "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [0.15915494309189535]\n"
          "damping_ratio = [0.01]\n[[structure.point]]\nname = \"mass\"\nshape = [1]\n"
          "[[joint]]\nname = \"tie\"\nfile = \"joint.json\"\nshape = [0]\n"
          "shortening_per_kg_m = [0.3]\n[excitation]\npoint = \"mass\"\n");
  const Outcome run = expect_done(box, frf({"--force", "10 mN", "--frequency", "0.08:0.32",
                                            "--harmonics", "2", "--samples", "16"}));
  const std::string text = box.get("frf.csv");
  expect_parts(text, {"# turns back: frequency ", "amplitude_tie [m]"});
  expect_parts(run.out, {"turns back", "peak"});
  const CsvTable table(text, "frf.csv");
  const std::vector<double> f = table.numbers("frequency", kFrequency);
  const std::vector<double> a = table.numbers("displacement", kLength);
  int turns = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (i > 1 && (f[i] - f[i - 1]) * (f[i - 1] - f[i - 2]) < 0.0) ++turns;
    const double omega = 2.0 * pi * f[i];
    const std::complex<double> z(1.0 - omega * omega + 0.75 * 4.5 * a[i] * a[i], 0.02 * omega);
    // Where the curve is steep a residual of 1e-12 is 1e-10 of the force.
    EXPECT_NEAR(std::abs(z) * a[i], 0.01, 1e-11) << f[i];
  }
  EXPECT_EQ(turns, 2);
}

// Two masses, k = 1e4 N/m three times, joints of 2000 N/m: with both stuck ω² is an eigenvalue of
// [2k + 2k_j, −k − k_j; −k − k_j, 2k + k_j], with both in macro-slip k and 3k. The forces are small
// and large enough for 1e-4 of the frequency.
TEST(frf, OfTwoJointsGoesFromStuckToSlip) {
  const Sandbox box = example_model("two_joints");
  const double root = std::hypot(1000.0, 12000.0);
  const std::vector<std::vector<double>> squares{{23000.0 - root, 23000.0 + root}, {1e4, 3e4}};
  for (const bool slip : {false, true}) {
    expect_done(box, frf({"--force", slip ? "1000" : "1e-9", "--frequency", "12:35"}));
    std::string text = box.get("frf.csv");
    for (const double square : squares[slip ? 1 : 0]) {
      text = text.substr(std::min(text.find("# peak:"), text.size()));
      const double expected = std::sqrt(square) / (2.0 * pi);
      EXPECT_NEAR(number_behind(text, "frequency"), expected, 1e-4 * expected);
      text.erase(0, 1);
    }
    EXPECT_EQ(text.find("# peak:"), std::string::npos);
  }
}

TEST(frf, HasTheColumnsOfEachJoint) {
  const Sandbox box = example_model("two_joints");
  const Outcome run = expect_done(box, frf({"--force", "0.5", "--frequency", "12:20"}));
  expect_parts(run.out, {"2 modes, 2 joints", "16.661, 29.793 Hz"});
  const CsvTable table(box.get("frf.csv"), "frf.csv");
  const std::vector<double> wall = table.numbers("dissipation_wall", kEnergy);
  const std::vector<double> middle = table.numbers("dissipation_middle", kEnergy);
  const std::vector<double> sum = table.numbers("dissipation", kEnergy);
  const std::vector<double> amplitude = table.numbers("amplitude_middle", kLength);
  const std::vector<double> reversals = table.numbers("reversals_wall", kDimensionless);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_NEAR(sum[i], wall[i] + middle[i], 1e-15 * sum[i]);
    EXPECT_GT(amplitude[i], 0.0);
    EXPECT_GE(reversals[i], 2.0);
  }
}

TEST(frf, OfTheExamplesRunsAsTheyShow) {
  for (const std::string example : {"one_mass", "two_joints"}) {
    const Sandbox box = example_model(example);
    if (example == "two_joints") {
      for (const std::string file : {"unknown.toml", "levels.csv"}) {
        box.put(file, test::get(MICROSLIP_EXAMPLES "/two_joints/" + file));
      }
    }
    const std::vector<Arguments> calls =
        shown_calls(test::get(MICROSLIP_EXAMPLES "/" + example + "/README.md"));
    EXPECT_GE(calls.size(), 2U);
    for (const Arguments& call : calls) expect_done(box, call);
  }
}

// ---- What is written and said. ----

TEST(frf, WritesColumnsCommentsAndASummary) {
  const Sandbox box = one_mass();
  const Arguments call = frf({"--force", "0.1", "--frequency", "0.1:0.2"});
  const Outcome run = expect_done(box, call);
  const std::string text = box.get("frf.csv");
  expect_parts(text, {": microslip frf model.toml --out frf.csv --force 0.1 --frequency 0.1:0.2\n",
                      "converged: reached the end of the range\n", "# peak: frequency 0.146",
                      "\n" + kHeader + "0.1,0.1,"});
  expect_parts(run.out, {"Frequency response at 0.1 N", "model.toml, 1 mode, 1 joint",
                         "stuck resonances     0.15915 Hz", "5 harmonics, 256 samples",
                         "0.1 to 0.2 Hz", "peak                 0.146", "damping 0.028"});
  EXPECT_EQ(run.out.find("warning"), std::string::npos) << run.out;
}

TEST(frf, WritesTheSameToStandardOutput) {
  const Sandbox box = one_mass();
  const Outcome file = expect_done(box, frf({"--force", "0.1", "--frequency", "0.1:0.2"}));
  const Outcome pipe = box.run(
      {"frf", "model.toml", "--force", "100mN", "--frequency", "100mHz:0.2Hz", "--out", "-"});
  EXPECT_EQ(pipe.status, 0);
  const auto without_call = [](const std::string& text) { return text.substr(text.find('\n')); };
  EXPECT_EQ(without_call(pipe.out), without_call(box.get("frf.csv")));
  EXPECT_EQ(pipe.err, file.out) << "the summary gives way";
}

TEST(frf, IsQuietWhereAsked) {
  const Sandbox box = one_mass();
  const Outcome run =
      expect_done(box, frf({"--force", "0.1", "--frequency", "0.1:0.2", "--quiet"}));
  EXPECT_EQ(run.out, "");
}

TEST(frf, ReadsTheModelFromStandardInput) {
  const Sandbox box = one_mass();
  const Outcome run =
      expect_done(box, {"frf", "-", "--force", "0.1", "--frequency", "0.1:0.2", "--out", "frf.csv"},
                  {.in = box.get("model.toml")});
  expect_parts(run.out, {"standard input, 1 mode"});
}

TEST(frf, WarnsWhereTheRangeHoldsNoResonance) {
  const Sandbox box = one_mass();
  const Outcome run = expect_done(box, frf({"--force", "0.1", "--frequency", "0.2:0.3"}));
  expect_parts(run.out, {"warning: no resonance in the range", "0.15915 Hz"});
  EXPECT_EQ(CsvTable(box.get("frf.csv"), "t").numbers("frequency", kFrequency).back(), 0.3);
}

TEST(frf, TellsInTheFileWhatItWarnsOf) {
  const Sandbox box = one_mass();
  expect_done(box, frf({"--force", "0.1", "--frequency", "0.2:0.3", "--quiet"}));
  expect_parts(box.get("frf.csv"),
               {"# warning: no_resonance: no resonance in the range", "0.15915 Hz"});
}

// The row of a peak is that of its comment, with all columns, and none is higher.
TEST(frf, HasItsPeaksAmongTheRows) {
  const Sandbox box = example_model("two_joints");
  expect_done(box, frf({"--force", "0.5", "--frequency", "12:35"}));
  const std::string text = box.get("frf.csv");
  const CsvTable table(text, "frf.csv");
  const std::vector<double> marks = table.numbers("peak", kDimensionless);
  const std::vector<double> f = table.numbers("frequency", kFrequency);
  const std::vector<double> a = table.numbers("displacement", kLength);
  std::string rest = text;
  int peaks = 0;
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    const bool is_highest = a[i] > a[i - 1] && a[i] > a[i + 1];
    EXPECT_EQ(marks[i] == 1.0, is_highest) << f[i];
    if (!is_highest) continue;
    ++peaks;
    rest = rest.substr(std::min(rest.find("# peak:") + 1, rest.size()));
    EXPECT_NEAR(f[i], number_behind(rest, "frequency"), 1e-8 * f[i]);
    EXPECT_NEAR(a[i], number_behind(rest, "displacement"), 1e-8 * a[i]);
  }
  EXPECT_EQ(peaks, 2);
}

/// The value of the polygon through points with rising x.
double on_polygon(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
  const std::size_t i = std::clamp<std::size_t>(next, 1, x.size() - 1);
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

// The ends of the range, and what --at names, stand in the table as they were written.
TEST(frf, HasRowsAtTheFrequenciesAsked) {
  const Sandbox box = one_mass();
  expect_done(box, frf({"--force", "0.1", "--frequency", "0.248:0.062", "--at",
                        "0.083,0.107,0.15,0.194,0.238", "--accuracy", "5%"}));
  const CsvTable table(box.get("frf.csv"), "frf.csv");
  const std::vector<double> f = table.numbers("frequency", kFrequency);
  for (const double asked : {0.248, 0.062, 0.083, 0.107, 0.15, 0.194, 0.238}) {
    EXPECT_NE(std::ranges::find(f, asked), f.end()) << asked;
  }
}

// Rows at given frequencies lie on the curve; the polygon through the others is as near to them as
// it is to be, and is the curve of 50 times that accuracy to that.
TEST(frf, DrawsItsCurveAsCloselyAsIsAsked) {
  const Sandbox box = one_mass();
  for (const std::string kept : {"--force", "--response"}) {
    const std::vector<std::string> common{kept, kept == "--force" ? "0.1" : "0.8", "--frequency",
                                          "0.1:0.2"};
    const auto table_of = [&](std::vector<std::string> more) {
      more.insert(more.begin(), common.begin(), common.end());
      expect_done(box, frf(more));
      return CsvTable(box.get("frf.csv"), "frf.csv");
    };
    const std::string drawn = kept == "--force" ? "displacement" : "force";
    const Dimension& dimension = kept == "--force" ? kLength : kForce;
    const CsvTable exact = table_of({"--at", "0.1:0.2:301", "--accuracy", "0.004%"});
    const std::vector<double> f = exact.numbers("frequency", kFrequency);
    const std::vector<double> y = exact.numbers(drawn, dimension);
    EXPECT_TRUE(std::ranges::is_sorted(f));
    for (int i = 0; i <= 300; ++i) {
      const double at = 0.1 + (0.2 - 0.1) * i / 300.0;
      EXPECT_NE(std::ranges::find_if(f, [at](double x) { return std::abs(x - at) < 1e-15; }),
                f.end());
    }
    std::size_t rows = 0;
    for (const double accuracy : {0.002, 0.0005}) {
      const CsvTable table = table_of({"--accuracy", std::to_string(accuracy)});
      const std::vector<double> x = table.numbers("frequency", kFrequency);
      const std::vector<double> z = table.numbers(drawn, dimension);
      EXPECT_GT(x.size(), rows);
      rows = x.size();
      const double top = kept == "--force" ? std::ranges::max(y) : std::ranges::min(y);
      for (std::size_t i = 0; i < f.size(); ++i) {
        const double allowed = kept == "--force" ? accuracy * top : accuracy * y[i];
        EXPECT_NEAR(on_polygon(x, z, f[i]), y[i], allowed) << kept << " " << f[i];
      }
    }
  }
}

// The same curve reversed.
TEST(frf, GoesDownward) {
  const Sandbox box = one_mass();
  expect_done(box, frf({"--force", "0.1", "--frequency", "0.1:0.2"}));
  const CsvTable up(box.get("frf.csv"), "frf.csv");
  expect_done(box, frf({"--force", "0.1", "--frequency", "0.2:0.1"}));
  const CsvTable down(box.get("frf.csv"), "frf.csv");
  const std::vector<double> f = down.numbers("frequency", kFrequency);
  const std::vector<double> a = down.numbers("displacement", kLength);
  EXPECT_EQ(f.front(), 0.2);
  EXPECT_EQ(f.back(), 0.1);
  EXPECT_TRUE(std::ranges::is_sorted(f, std::greater{}));
  const std::vector<double> before = up.numbers("displacement", kLength);
  EXPECT_NEAR(a.back(), before.front(), 1e-9 * a.back());
  EXPECT_NEAR(std::ranges::max(a), std::ranges::max(before), 1e-9 * std::ranges::max(a));
}

// A file of this kind stays one however many comments it has.
TEST(frf, ReplacesItsOwnFileBehindManyComments) {
  const Sandbox box = one_mass();
  const Arguments call = frf({"--force", "0.1", "--frequency", "0.1:0.2"});
  expect_done(box, call);
  std::string comments;
  for (int i = 0; i < 4000; ++i) comments += "# turns back: frequency 16.67 Hz, force 2.19 N\n";
  box.put("frf.csv", comments + box.get("frf.csv"));
  expect_done(box, {"plot", "frf.csv", "--out", "frf.svg"});
  expect_done(box, call);
  EXPECT_LT(box.get("frf.csv").size(), comments.size());
}

TEST(frf, ReplacesOnlyItsOwnKind) {
  const Sandbox box = one_mass();
  const Arguments call = frf({"--force", "0.1", "--frequency", "0.1:0.2"});
  expect_done(box, call);
  expect_done(box, call);
  box.put("frf.csv", "displacement [m],force [N],frequency [Hz],damping_ratio [1]\n1,1,1,1\n");
  expect_refused(box, call, {"frf.csv", "a table of a backbone"});
}

// ---- Faults. ----

struct BadCall {
  Arguments arguments;
  std::vector<std::string> parts;
};

TEST(frf, RefusesBadCalls) {
  const Sandbox box = one_mass();
  const std::vector<BadCall> calls{
      {{"--frequency", "0.1:0.2"},
       {"--force, --acceleration or --response is required", "microslip frf --help"}},
      {{"--force", "1"}, {"--frequency is required"}},
      {{"--force", "1", "--response", "1", "--frequency", "0.1:0.2"}, {"--force", "--response"}},
      {{"--force", "0", "--frequency", "0.1:0.2"}, {"--force = 0", "above 0 N"}},
      {{"--force", "-1", "--frequency", "0.1:0.2"}, {"--force = -1", "above 0 N"}},
      {{"--force", "nan", "--frequency", "0.1:0.2"}, {"--force = 'nan'", "finite"}},
      {{"--force", "1e13", "--frequency", "0.1:0.2"}, {"--force", "1e12"}},
      {{"--force", "1mm", "--frequency", "0.1:0.2"}, {"--force: unit = 'mm'", "length"}},
      {{"--response", "0", "--frequency", "0.1:0.2"}, {"--response = 0", "above 0 m"}},
      {{"--response", "1N", "--frequency", "0.1:0.2"}, {"--response: unit = 'N'", "force"}},
      {{"--force", "1", "--frequency", "0.2"}, {"--frequency = '0.2'", "FROM:TO"}},
      {{"--force", "1", "--frequency", "0.1:0.2:5"}, {"--frequency = '0.1:0.2:5'", "FROM:TO"}},
      {{"--force", "1", "--frequency", "0.2:0.2"}, {"FROM and TO must differ"}},
      {{"--force", "1", "--frequency", "0.2:0"}, {"TO of --frequency = 0", "above 0 Hz"}},
      {{"--force", "1", "--frequency", "1e10:1"}, {"FROM of --frequency = 10000000000", "1e9"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--accuracy", "0"},
       {"--accuracy = '0'", "from 0.0001% to 100%"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--accuracy", "2mm"}, {"--accuracy: unit"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--at", "0.25"},
       {"--at = 0.25", "0.1 to 0.2 Hz", "Widen"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--at", "0.15,x"}, {"--at = 'x'", "finite"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--at", "0.1:0.2"}, {"--at", "FROM:TO:COUNT"}},
      {{"--force", "1", "--frequency", "0:0.2"}, {"FROM of --frequency = 0", "above 0 Hz"}},
      {{"--force", "1", "--frequency", "1:1e10"}, {"TO of --frequency = 10000000000", "1e9"}},
      {{"--force", "1", "--frequency", "1:2 rad/s"}, {"TO of --frequency: unit", "Hz"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--harmonics", "0"},
       {"--harmonics = '0'", "from 1"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--harmonics", "1001"},
       {"--harmonics = '1001'", "to 1000"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--harmonics", "200"},
       {"--samples = 256", "from 402", "fewer harmonics"}},
      {{"--force", "1", "--frequency", "0.1:0.2", "--samples", "many"}, {"--samples = 'many'"}},
  };
  for (const BadCall& call : calls) expect_refused(box, frf(call.arguments), call.parts);
}

TEST(frf, RefusesBadModels) {
  const Sandbox box = one_mass();
  const Arguments call = frf({"--force", "0.1", "--frequency", "0.1:0.2"});
  const std::string model = box.get("model.toml");
  box.put("model.toml", model + "harmonics = [1, 0, 0, 0, 0, 0.1]\n");
  expect_refused(box, call, {"--harmonics = 5", "highest of the excitation, 6"});
  box.put("model.toml", model + "[response]\npoint = \"masss\"\n");
  expect_refused(box, call, {"model.toml:19:9: response.point = 'masss'", "Did you mean 'mass'?"});
  box.put("model.toml", model);
  box.put("joint.json", "{}");
  expect_refused(box, call, {"joint.json", "schema"});
  const Sandbox alone{{"model.toml", model}};
  expect_refused(alone, call, {"model.toml:13:8: joint[0].file: ", "joint.json: cannot be read"});
  expect_refused(Sandbox{}, call, {"model.toml: cannot be read"});
}

// An elastic tie that bending shortens, a softening mass: from 0.165 Hz the curve goes up to a
// fold, and back from there on the branch that no test would see, past where it began.
TEST(frf, MarksWhatDoesNotConverge) {
  const Sandbox box{
      {"joint.json", R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1, "density": []})"},
      {"model.toml",
       "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [0.0711762543417177]\n"
       "damping_ratio = [0.02]\n[[structure.point]]\nname = \"mass\"\nshape = [1]\n[[joint]]\n"
       "file = \"joint.json\"\nshape = [1]\nshortening_per_kg_m = [0.3]\n[excitation]\npoint = "
       "\"mass\"\n"}};
  Outcome run = box.run(frf({"--force", "0.05", "--frequency", "0.165:0.2"}));
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "");
  expect_parts(run.out, {"NOT CONVERGED: the curve turned back", "turns back"});
  EXPECT_EQ(run.out.find("warning"), std::string::npos) << "the range was not all seen";
  const std::string text = box.get("frf.csv");
  expect_parts(text, {"NOT CONVERGED: the curve turned back", "# turns back: "});
  EXPECT_EQ(CsvTable(text, "frf.csv").numbers("frequency", kFrequency).front(), 0.165);
  run = box.run(frf({"--force", "0.05", "--frequency", "0.165:0.2", "--quiet"}));
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.out, "");
  expect_parts(run.err, {"model.toml: not converged: ", "the result so far is written and marked"});
}

TEST(frf, WritesNothingWhereNothingIsFound) {
  const Sandbox box{{"model.toml", kUndamped}};
  const auto before = box.content();
  const Outcome run = box.run(frf({"--force", "1", "--frequency", "10:20"}));  // from the pole on
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.out, "");
  expect_parts(run.err, {"model.toml: not converged: ", "nothing is written"});
  EXPECT_TRUE(box.content() == before);
}

// ---- On a terminal. ----

TEST(frf, ShowsProgressAndEndsOnInterrupt) {
  const Sandbox box = one_mass();
  expect_interruptible(box,
                       frf({"--force", "0.1", "--frequency", "0.1:0.2", "--samples", "300000"}));
}

}  // namespace
}  // namespace microslip::cli_test::frf_test
