// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip::cli_test::backbone_test {
namespace {

constexpr double pi = std::numbers::pi;

const std::string kHeader =
    "displacement [m],force [N],frequency [Hz],damping_ratio [1],dissipation "
    "[J],linear_dissipation "
    "[J],amplitude_joint [m],dissipation_joint [J],reversals_joint [1],energy_imbalance [1]\n";

Arguments backbone(const Arguments& more) {
  Arguments all{"backbone", "model.toml", "--out", "backbone.csv"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

// One harmonic in closed form: ω² = k + k_eq(a), F = a (cω + D(a)/(πa²)), ζ = F/(2ω²a). 4096
// samples leave 2e-8 of the joint's force, a hundredth of which is its loss.
TEST(backbone, IsThatOfTheDescribingFunction) {
  const Sandbox box = one_mass();
  const Joint joint = read_joint(box.file("joint.json")).joint;
  expect_done(box,
              backbone({"--response", "10mm:5:12:log", "--harmonics", "1", "--samples", "4096"}));
  const CsvTable table(box.get("backbone.csv"), "backbone.csv");
  const std::vector<double> displacement = table.numbers("displacement", kLength);
  const std::vector<double> force = table.numbers("force", kForce);
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> damping = table.numbers("damping_ratio", kDimensionless);
  ASSERT_EQ(displacement.size(), 12U);
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double a = 0.01 * std::pow(500.0, static_cast<double>(i) / 11.0);
    const double omega = std::sqrt(0.75 + secant_stiffness(joint, a));
    const double expected = a * (0.01 * omega + dissipation(joint, a) / (pi * a * a));
    EXPECT_NEAR(displacement[i], a, 1e-10 * a);
    EXPECT_NEAR(frequency[i], omega / (2.0 * pi), 1e-7 * frequency[i]);
    EXPECT_NEAR(force[i], expected, 1e-5 * expected);
    EXPECT_NEAR(damping[i], expected / (2.0 * omega * omega * a), 1e-5 * damping[i]);
  }
}

TEST(backbone, FollowsTheModeThatIsAskedFor) {
  const Sandbox box;
  box.put(
      "model.toml",
      "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [50, 300]\n"
      "loss_factor = [0.002, 0.004]\n"
      "[[structure.point]]\nname = \"tip\"\nshape = [1.4, -1.2]\n[excitation]\npoint = \"tip\"\n");
  for (const std::string mode : {"1", "2"}) {
    const Outcome run = expect_done(box, backbone({"--response", "1um:2um:2", "--mode", mode}));
    expect_parts(run.out, {"Backbone of mode " + mode, "2 modes, 0 joints", "50, 300 Hz"});
    const CsvTable table(box.get("backbone.csv"), "backbone.csv");
    // The other mode, far off, moves it by some 1e-6 of the frequency and, squared, of the energy.
    const double f = mode == "1" ? 50.0 : 300.0;
    EXPECT_NEAR(table.numbers("frequency", kFrequency)[0], f, 1e-4 * f);
    EXPECT_NEAR(table.numbers("damping_ratio", kDimensionless)[1], mode == "1" ? 0.001 : 0.002,
                1e-5);
  }
}

TEST(backbone, WritesColumnsCommentsAndASummary) {
  const Sandbox box = one_mass();
  const Arguments call = backbone({"--response", "0.1:2:20"});
  const Outcome run = expect_done(box, call);
  expect_parts(box.get("backbone.csv"),
               {": microslip backbone model.toml --out backbone.csv --response 0.1:2:20\n",
                "harmonic balance, backbone: converged: all responses "
                "reached\n" +
                    kHeader});
  expect_parts(run.out, {"Backbone of mode 1", "model.toml, 1 mode, 1 joint", "0.15915 Hz",
                         "points               20", "damping ratio", "largest damping"});
  const Outcome pipe =
      box.run({"backbone", "model.toml", "--response", "100mm:2:20", "--out", "-"});
  EXPECT_EQ(pipe.status, 0);
  const auto without_call = [](const std::string& text) { return text.substr(text.find('\n')); };
  EXPECT_EQ(without_call(pipe.out), without_call(box.get("backbone.csv")));
  EXPECT_EQ(pipe.err, run.out) << "the summary gives way";
  EXPECT_EQ(expect_done(box, backbone({"--response", "0.1:2:2", "--quiet"})).out, "");
}

/// The second mode hardly moves the point that is driven.
Sandbox weak_mode() {
  return Sandbox{
      {"joint.json",
       R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 158478.48402568328, "density": )"
       R"([{"type": "four_parameter", "macroslip_force_N": 13.206133047334411, )"
       R"("chi": -0.6761657090641489, "beta": 1.2355182600944188}]})"},
      {"model.toml",
       "schema = \"microslip.model/1\"\n[structure]\n"
       "frequency_Hz = [12.143849549953952, 23.644770858773224]\n"
       "damping_ratio = [0.00067]\n[[structure.point]]\nname = \"m2\"\n"
       "shape = [-0.87903385625902464, 0.49152919407096346]\n[[joint]]\nname = \"J0\"\n"
       "file = \"joint.json\"\nshape = [-0.35102479256756741, -0.62776063105754187]\n"
       "[excitation]\npoint = \"m2\"\n"}};
}

TEST(backbone, SaysThatPhaseResonanceDoesNotExist) {
  const Sandbox box = weak_mode();
  const Outcome none =
      box.run(backbone({"--mode", "2", "--response", "1nm:0.8mm:40:log", "--quiet"}));
  EXPECT_EQ(none.status, 3);
  expect_parts(
      none.err,
      {"phase resonance of mode 2 at 'm2' with this excitation exists only up to", "antiresonance",
       "drive or observe another point", "modal forcing", "nothing is written"});
  EXPECT_FALSE(box.has("backbone.csv"));
  // A part of it: what there is is written, and marked, where it ends too.
  const Outcome some = box.run(backbone({"--mode", "2", "--response", "0.1nm:10nm:21:log"}));
  EXPECT_EQ(some.status, 3);
  expect_parts(box.get("backbone.csv"),
               {"# harmonic balance, backbone: NOT CONVERGED: phase resonance of mode 2 at 'm2'",
                "# turns back: frequency 50.1", "displacement 5.92"});
  expect_parts(some.out, {"NOT CONVERGED", "turns back"});
}

TEST(backbone, TakesModalForcing) {
  const Sandbox box = weak_mode();
  const Outcome run = expect_done(
      box, backbone({"--mode", "2", "--response", "1nm:0.8mm:40:log", "--forcing", "modal"}));
  expect_parts(run.out, {"Backbone of mode 2, modal forcing", "harmonics above"});
  const std::string text = box.get("backbone.csv");
  expect_parts(text, {"# harmonic balance, backbone, modal forcing: converged"});
  const CsvTable table(text, "backbone.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  ASSERT_EQ(frequency.size(), 40U);
  EXPECT_NEAR(frequency.front(), 50.18, 0.01);  // stuck: 50.5 Hz
  EXPECT_NEAR(frequency.back(), 24.5, 0.1);     // free: 23.6 Hz
  // What feeds the motion is what it loses.
  const std::vector<double> force = table.numbers("force", kForce);
  const std::vector<double> displacement = table.numbers("displacement", kLength);
  const std::vector<double> joint = table.numbers("dissipation", kEnergy);
  const std::vector<double> linear = table.numbers("linear_dissipation", kEnergy);
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_NEAR(pi * force[i] * displacement[i], joint[i] + linear[i],
                1e-8 * (joint[i] + linear[i]));
  }
}

TEST(backbone, WarnsOfTooFewHarmonicsInTheFileToo) {
  const Sandbox box = one_mass();
  expect_done(box, backbone({"--response", "0.3:2:5", "--harmonics", "1", "--quiet"}));
  EXPECT_EQ(box.get("backbone.csv").find("# warning: "), std::string::npos);
  box.put("model.toml",
          "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [0.159, 0.41]\n"
          "damping_ratio = [0.005]\n[[structure.point]]\nname = \"a\"\nshape = [1, 0.8]\n"
          "[[joint]]\nname = \"joint\"\nfile = \"joint.json\"\nshape = [1, 1]\n"
          "[excitation]\npoint = \"a\"\n");
  const Arguments call = backbone({"--response", "0.5:2:5", "--harmonics", "1"});
  const Outcome run = expect_done(box, call);
  expect_parts(run.out, {"warning: with 3 harmonics the dissipation of 'joint' changes by"});
  expect_parts(box.get("backbone.csv"),
               {"# warning: truncated: with 3 harmonics the dissipation of 'joint'",
                "take 3 harmonics (`harmonics 3`)\n"});
}

struct BadCall {
  Arguments arguments;
  std::vector<std::string> parts;
};

TEST(backbone, RefusesBadCalls) {
  const Sandbox box = one_mass();
  const std::vector<BadCall> calls{
      {{}, {"--response is required", "microslip backbone --help"}},
      {{"--response", "0.1:0.2"}, {"--response = '0.1:0.2'", "FROM:TO:COUNT"}},
      {{"--response", "0.2:0.1:3"}, {"FROM must be below TO"}},
      {{"--response", "0:0.1:3"}, {"FROM of --response = 0", "above 0 m"}},
      {{"--response", "-1:0.1:3"}, {"FROM of --response = -1", "above 0 m"}},
      {{"--response", "1:1e7:3"}, {"TO of --response = 10000000", "1e6"}},
      {{"--response", "1N:2N:3"}, {"FROM of --response: unit = 'N'"}},
      {{"--response", "1:2:1"}, {"COUNT of --response = '1'", "from 2"}},
      {{"--response", "1:2:3", "--mode", "0"}, {"--mode = '0'", "from 1 to 1"}},
      {{"--response", "1:2:3", "--mode", "2"}, {"--mode = '2'", "that many modes"}},
      {{"--response", "1:2:3", "--forcing", "shaker"}, {"--forcing", "modal"}},
      {{"--response", "1:2:3", "--harmonics", "0"}, {"--harmonics = '0'"}},
      {{"--response", "1:2:3", "--samples", "8"}, {"--samples = 8", "from 12"}},
  };
  for (const BadCall& call : calls) expect_refused(box, backbone(call.arguments), call.parts);
}

TEST(backbone, RefusesARigidBody) {
  const Sandbox box;
  box.put("model.toml",
          "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [0, 30]\n"
          "damping_ratio = [0.01]\n[[structure.point]]\nname = \"tip\"\nshape = [1, 1]\n"
          "[excitation]\npoint = \"tip\"\n");
  expect_refused(box, backbone({"--response", "1um:2um:2"}),
                 {"--mode = 1; must be elastic", "rigid-body", "higher mode"});
  expect_done(box, backbone({"--response", "1um:2um:2", "--mode", "2"}));
}

TEST(backbone, ReplacesOnlyItsOwnKind) {
  const Sandbox box = one_mass();
  const Arguments call = backbone({"--response", "0.1:0.2:2"});
  expect_done(box, call);
  expect_done(box, call);
  box.put("backbone.csv", "frequency [Hz],displacement [m],phase [rad]\n1,1,1\n");
  expect_refused(box, call, {"backbone.csv", "a table of a frequency response"});
}

TEST(backbone, ShowsProgressOnANarrowTerminalToo) {
  const Sandbox box = one_mass();
  const Arguments call = backbone({"--response", "10mm:2:3000:log"});
  const Outcome wide = box.run(call, {.columns = 80});
  EXPECT_NE(wide.out.find("responses ["), std::string::npos) << wide.out;
  EXPECT_NE(wide.out.find("\r\033[KBackbone of mode 1"), std::string::npos)
      << "the bar is gone before the summary";
  const Outcome narrow = box.run(call, {.columns = 20});
  EXPECT_NE(narrow.out.find(" %, "), std::string::npos) << narrow.out;
  EXPECT_EQ(narrow.out.find("responses ["), std::string::npos) << "the bar would break the line";
}

TEST(backbone, EndsOnInterrupt) {
  const Sandbox box = one_mass();
  expect_interruptible(box, backbone({"--response", "10mm:2:300000:log"}));
}

}  // namespace
}  // namespace microslip::cli_test::backbone_test
