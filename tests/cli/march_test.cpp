// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::cli_test::march_test {
namespace {

const std::string kHeader =
    "time [s],force [N],displacement [m],velocity [m/s],acceleration [m/s^2],joint displacement "
    "[m],joint force [N]\n";

Arguments march_call(const Arguments& more = {}) {
  Arguments all{"march", "model.toml", "--force-file", "force.csv", "--out", "march.csv"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// 0.05 N near resonance, four samples a second.
LoadHistory vibration(std::size_t count = 401) {
  LoadHistory loads{{}, {{"mass", {}}}};
  for (std::size_t i = 0; i < count; ++i) {
    loads.time.push_back(0.25 * static_cast<double>(i));
    loads.forces[0].force.push_back(0.05 * std::sin(0.95 * loads.time.back()));
  }
  return loads;
}

std::string force_text(const LoadHistory& loads) {
  CsvWriter writer;
  writer.add_numbers("time", kTime, loads.time);
  writer.add_numbers("force", kForce, loads.forces[0].force);
  return writer.str();
}

Sandbox one_mass_with_force() {
  const std::string folder = MICROSLIP_EXAMPLES "/one_mass/";
  return Sandbox{{"model.toml", test::get(folder + "model.toml")},
                 {"joint.json", test::get(folder + "joint.json")},
                 {"force.csv", force_text(vibration())}};
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

// ---- The numbers. ----

// The columns are what the library computes, digit by digit.
TEST(march, WritesTheMotion) {
  const Sandbox box = one_mass_with_force();
  const Outcome run = expect_done(box, march_call());
  expect_parts(run.out, {"March from 0 to 100 s", "1 mode, 1 joint", "401 times", "input",
                         "linear dissipation", "J dissipated", "energy imbalance"});
  const std::string text = box.get("march.csv");
  expect_parts(text, {kHeader, "# energy: input ", "# energy of joint 'joint': dissipation "});
  const CsvTable table(text, "march.csv");
  const ModelFile model = read_model(box.file("model.toml"));
  const LoadHistory loads = vibration();
  const MarchResult found = march(model.structure, loads, {.points = {"mass"}});
  EXPECT_EQ(table.numbers("time", kTime), loads.time);
  EXPECT_EQ(table.numbers("force", kForce), loads.forces[0].force);
  EXPECT_EQ(table.numbers("displacement", kLength), found.points[0].displacement);
  EXPECT_EQ(table.numbers("velocity", kVelocity), found.points[0].velocity);
  EXPECT_EQ(table.numbers("acceleration", kAcceleration), found.points[0].acceleration);
  EXPECT_EQ(table.numbers("joint displacement", kLength), found.joints[0].displacement);
  EXPECT_EQ(table.numbers("joint force", kForce), found.joints[0].force);
}

TEST(march, ConvertsUnitsAndTakesPointsByName) {
  const Sandbox box = one_mass_with_force();
  expect_done(box, march_call());
  const std::string all = box.get("march.csv");
  std::string text = "time [ms];force at mass [mN];note\n";
  const LoadHistory loads = vibration();
  for (std::size_t i = 0; i < loads.time.size(); ++i) {
    text += std::to_string(1e3 * loads.time[i]) + ";" +
            std::to_string(1e3 * loads.forces[0].force[i]) + ";any\n";
  }
  box.put("force.csv", text);
  expect_done(box, march_call());
  const CsvTable expected(all, "");
  const CsvTable found(box.get("march.csv"), "");
  const auto a = expected.numbers("displacement", kLength);
  const auto b = found.numbers("displacement", kLength);
  ASSERT_EQ(a.size(), b.size());
  // Six digits of the force in mN: 1e-9 N of 0.05 N, and resonance.
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6);
}

TEST(march, WritesEveryNthTimeAndTheLast) {
  const Sandbox box = one_mass_with_force();
  const Outcome run = expect_done(box, {"march", "model.toml", "--force-file", "force.csv",
                                        "--every", "150", "--out", "-", "--quiet"});
  const CsvTable table(run.out.substr(run.out.find('#')), "");
  EXPECT_EQ(table.numbers("time", kTime), (std::vector<double>{0.0, 37.5, 75.0, 100.0}));
  const std::vector<double> force = vibration().forces[0].force;
  EXPECT_EQ(table.numbers("force", kForce),
            (std::vector<double>{force[0], force[150], force[300], force[400]}));
}

// What a summary says of the motion does not depend on which rows are written.
TEST(march, TellsTheLargestOfAllTimes) {
  const Sandbox box = one_mass_with_force();
  const auto largest = [&](const std::string& every) {
    const std::string out = expect_done(box, march_call({"--every", every})).out;
    const std::size_t at = out.find("largest response");
    EXPECT_NE(at, std::string::npos) << out;
    return out.substr(at, out.find('\n', at) - at);
  };
  EXPECT_EQ(largest("2000"), largest("1"));
}

TEST(march, TakesANormalLoad) {
  const Sandbox box = one_mass_with_force();
  const LoadHistory loads = vibration();
  CsvWriter writer;
  writer.add_numbers("time", kTime, loads.time);
  writer.add_numbers("force", kForce, loads.forces[0].force);
  std::vector<double> normal;
  for (const double t : loads.time) normal.push_back(1.0 + 0.9 * std::pow(std::sin(0.95 * t), 2));
  writer.add_numbers("normal_load", kDimensionless, normal);
  box.put("force.csv", writer.str());
  expect_done(box, march_call({"--quiet"}));
  const std::string incremental = box.get("march.csv");
  expect_done(box, march_call({"--quiet", "--normal-load-law", "total"}));
  const CsvTable total(box.get("march.csv"), "");
  const auto a = CsvTable(incremental, "").numbers("displacement", kLength);
  EXPECT_NE(a, total.numbers("displacement", kLength));
}

// What a reader of the file must know is in it, also where nothing is said.
TEST(march, WritesWarningsAndTheErrorIntoTheFile) {
  const Sandbox box = one_mass_with_force();
  std::string model = box.get("model.toml");
  const std::string viscous = "damping_ratio";
  model.replace(model.find(viscous), viscous.size(), "loss_factor");  // hysteretic
  box.put("model.toml", model);
  const Outcome run = expect_done(box, march_call({"--quiet"}));
  EXPECT_EQ(run.out, "");
  expect_parts(box.get("march.csv"),
               {"# warning: hysteretic_as_viscous: hysteretic damping has no time-domain form",
                "# estimated error of the displacements: "});
  expect_done(box, march_call({"--quiet", "--no-error-estimate"}));
  EXPECT_EQ(box.get("march.csv").find("estimated error"), std::string::npos);
}

// The rows come as they are found; what is known at the end follows them, and reads back.
TEST(march, StreamsToStandardOutput) {
  const Sandbox box = one_mass_with_force();
  expect_done(box, march_call({"--quiet"}));
  const Outcome run = expect_done(
      box, {"march", "model.toml", "--force-file", "force.csv", "--out", "-", "--quiet"});
  const CsvTable file(box.get("march.csv"), "");
  const CsvTable stream(run.out, "");
  EXPECT_EQ(file.numbers("displacement", kLength), stream.numbers("displacement", kLength));
  EXPECT_GT(run.out.find("# energy: "), run.out.find(kHeader));
}

// ---- Bad calls and input. ----

TEST(march, RefusesBadCalls) {
  const Sandbox box = one_mass_with_force();
  expect_refused(box, march_call({"--step", "0"}), {"--step = 0", "above 0 s"});
  expect_refused(box, march_call({"--step", "1mm"}), {"--step"});
  expect_refused(box, march_call({"--every", "0"}), {"--every = '0'", "from 1"});
  expect_refused(box, march_call({"--normal-load-law", "any"}), {"--normal-load-law"});
  expect_refused(box, {"march", "model.toml", "--out", "march.csv"}, {"--force-file"});
}

TEST(march, RefusesBadForces) {
  const Sandbox box = one_mass();
  const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    box.put("force.csv", text);
    expect_refused(box, march_call(), parts);
  };
  refused("time [s],force [N]\n0,1\n0,1\n", {"force.csv:3:1", "later than that of the row before"});
  refused("time [s],force [N]\n0,1\n", {"force.csv", "two rows or more"});
  refused("time [s],force\n0,1\n1,1\n", {"force.csv:1", "unit"});
  refused("time [s],force [N]\n0,1\n1,nan\n", {"force.csv:3:3", "nan"});
  refused("time [s],push [N]\n0,1\n1,1\n", {"force.csv", "'force [N]' or 'force at POINT [N]'"});
  refused("time [s],force at mas [N]\n0,1\n1,1\n",
          {"a point of the model, 'mass'", "of the model, 'mass'"});
  refused("time [s],force [N],force at mass [N]\n0,1,1\n1,1,1\n", {"one column for 'mass'"});
  refused("time [s],force [N],normal_load [1]\n0,1,1\n1,1,-1\n",
          {"force.csv:3:5", "a number of 0 or more"});
  refused("time [s],force [N],normal_load of knee [1]\n0,1,1\n1,1,1\n", {"'joint'", "knee"});
  expect_refused(one_mass(), march_call(), {"force.csv: cannot be read"});
}

// Before the march: there is no file of forces yet.
TEST(march, ReplacesOnlyAMarch) {
  const Sandbox box = one_mass();
  box.put("march.csv", "time [s],displacement [m],velocity [m/s],acceleration [m/s^2]\n0,1,1,1\n");
  expect_refused(box, march_call(), {"march.csv", "was not written by microslip"});
}

TEST(march, MarksWhatDoesNotConverge) {
  const Sandbox box = one_mass();
  LoadHistory loads = vibration(60);
  for (double& time : loads.time) time *= 14.0;  // 3.5 s: beyond the bound of stability
  for (std::size_t i = 0; i < 60; ++i) loads.forces[0].force[i] = i % 2 == 0 ? 1.0 : -1.0;
  box.put("force.csv", force_text(loads));
  Outcome run = box.run(march_call({"--step", "100"}));
  EXPECT_EQ(run.status, 3) << run.out << run.err;
  EXPECT_EQ(run.err, "");
  expect_parts(run.out, {"NOT CONVERGED"});
  expect_parts(box.get("march.csv"), {"NOT CONVERGED: ", kHeader});
  run = box.run(march_call({"--step", "100", "--quiet"}));
  EXPECT_EQ(run.status, 3);
  expect_parts(run.err, {"model.toml: not converged: ", "the result so far is written and marked"});
  expect_done(box, march_call());  // with steps that fit
}

// ---- On a terminal. ----

TEST(march, ShowsProgressAndEndsOnInterrupt) {
  const Sandbox box = one_mass_with_force();
  expect_interruptible(box, march_call({"--step", "1us"}));
}

// Neither the march nor its peaks are written of some of the draws.
TEST(march, EndsOnInterruptWhileItDraws) {
  const Sandbox box = one_mass_with_force();
  std::string model = box.get("model.toml");
  const std::string section = "[structure]";
  model.insert(model.find(section) + section.size(), "\nfrequency_std = [0.01]\n");
  box.put("model.toml", model);
  for (const int signal : {SIGINT, SIGTERM}) {
    expect_interruptible(
        box, march_call({"--draws", "1000000", "--every", "400", "--peaks-csv", "peaks.csv"}),
        signal, "draws");
  }
}

}  // namespace
}  // namespace microslip::cli_test::march_test
