// SPDX-License-Identifier: MIT
// `verify` by a model.toml or a joint.json.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/base/random.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/virtual_lap_joint.hpp"

namespace microslip::cli_test::verify_tests_test {
namespace {

/// A structure with the true joint, as the virtual tests have it.
Sandbox laboratory() { return {{"true.toml", test::kLapModel}, {"joint.json", test::kLapJoint}}; }

/// A stepped sine at a constant response, of frf, of which force and acceleration are read with
/// noise and the phase is that of the acceleration.
std::string swept(const Sandbox& box, double micrometres, RandomStream& random) {
  expect_done(box, {"frf", "true.toml", "--response", fmt::format("{}um", micrometres),
                    "--frequency", "79:80.5", "--at", "79:80.5:61", "--out", "frf.csv", "--quiet"});
  return test::noisy_sweep(box.get("frf.csv"), random);
}

/// The free decay of the structure from 320 µm as its accelerometer sees it, noise 20 mm/s².
std::string decayed(const Sandbox& box) {
  expect_done(box,
              {"march", "true.toml", "--release", "1:320um", "--duration", "4", "--sampling-rate",
               "4096", "--no-error-estimate", "--out", "march.csv", "--quiet"});
  RandomStream random(11, 1);
  return test::noisy_record(box.get("march.csv"), 0.02, random);
}

/// One column of the rows of a quantity.
std::vector<std::string> cells(const CsvTable& table, const std::string& quantity,
                               const std::string& part, const std::string& column) {
  const std::vector<std::string> quantities = table.text("quantity");
  const std::vector<std::string> parts = table.text("part");
  const std::vector<std::string> all = table.text(column);
  std::vector<std::string> found;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (quantities[row] == quantity && parts[row] == part) found.push_back(all[row]);
  }
  return found;
}

// A campaign: levels of eleven sweeps with noise, a joint from them, and the decay of the same
// structure, which was not used, predicted. Frequency and damping of the decay lie within what its
// analysis and the draws say: rms below 1.5 of the standard deviations of the decay alone where the
// joint is the true one, and at least 90 % of all values in a band of 95 % by the identified one.
TEST(verifyTests, AHammerBlowFollowsFromSweeps) {
  const Sandbox box = laboratory();
  box.put("rig.toml", test::kLapRig);
  Arguments reduce{"reduce", "rig.toml"};
  RandomStream random(5, 1);
  for (const int x : {20, 40, 60, 80, 100, 130, 160, 200, 240, 280, 320}) {
    const std::string name = fmt::format("sweep_{}.csv", x);
    box.put(name, swept(box, x, random));
    reduce.push_back(name);
  }
  box.put("decay.csv", decayed(box));
  const Outcome truth = expect_done(box, {"verify", "true.toml", "decay.csv", "--out", "t.csv"});
  EXPECT_NE(truth.out.find("decay.csv: ringdown"), std::string::npos) << truth.out;
  const CsvTable by_truth(box.get("t.csv"), "t.csv");
  for (const char* quantity : {"frequency", "damping_ratio"}) {
    const auto column = [&](const char* name) { return cells(by_truth, quantity, "curve", name); };
    const std::vector<std::string> measured = column("measured");
    const std::vector<std::string> deviation = column("measured_std");
    const std::vector<std::string> predicted = column("predicted");
    ASSERT_GE(measured.size(), 8U);
    double sum = 0.0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      sum +=
          std::pow((std::stod(measured[i]) - std::stod(predicted[i])) / std::stod(deviation[i]), 2);
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(measured.size())), 1.5) << quantity;
  }

  expect_done(box, with(reduce, {"--out", "levels.csv", "--quiet"}));
  std::filesystem::remove(box.file("joint.json"));  // by hand: it would not be replaced
  expect_done(box, {"identify", "levels.csv", "--stiffness", "4e5", "--samples", "1000",
                    "--samples-out", "s.h5", "--out", "joint.json", "--quiet"});
  std::string model = test::kLapModel;
  model.insert(model.find("shape = [0.7]\nspring"), "samples = \"s.h5\"\n");
  box.put("model.toml", model);
  const Outcome run = expect_done(box, {"verify", "model.toml", "decay.csv", "--draws", "400",
                                        "--out", "c.csv", "--picture", "c.svg"});
  const CsvTable table(box.get("c.csv"), "c.csv");
  const std::vector<std::string> verdicts = table.text("verdict");
  const auto inside = std::ranges::count(verdicts, "inside");
  EXPECT_GE(inside, 0.9 * static_cast<double>(verdicts.size())) << run.out;
  EXPECT_NE(box.get("c.svg").find("band of draws"), std::string::npos);
  const Outcome plot = expect_done(box, {"plot", "c.csv", "--out", "p.svg"});
  EXPECT_NE(plot.out.find("comparison"), std::string::npos) << plot.out;
}

// A sweep of this program's own is predicted by its model: rows of frf lie on the curve that
// verify solves point by point, to the tolerance of both.
TEST(verifyTests, AFrequencyResponseIsASweep) {
  const Sandbox box = laboratory();
  for (const Arguments& kept : {Arguments{"--force", "0.5"}, Arguments{"--response", "100um"}}) {
    const bool of_force = kept.front() == "--force";
    expect_done(
        box,
        with({"frf", "true.toml", "--frequency", "78:81", "--out", "frf.csv", "--quiet"}, kept));
    expect_done(box, {"verify", "true.toml", "frf.csv", "--out", "c.csv"});
    const CsvTable table(box.get("c.csv"), "c.csv");
    const std::string quantity = of_force ? "displacement" : "force";
    EXPECT_EQ(table.text("kind").front(), of_force ? "sweep" : "constant-response");
    const std::vector<std::string> measured = cells(table, quantity, "curve", "measured");
    const std::vector<std::string> predicted = cells(table, quantity, "curve", "predicted");
    ASSERT_GE(measured.size(), 20U);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      EXPECT_NEAR(std::stod(predicted[i]) / std::stod(measured[i]), 1.0, 1e-8);
    }
    EXPECT_EQ(cells(table, "damping_ratio", "peak", "at").size(), 1U);
  }
}

TEST(verifyTests, LoopsOfAJointNeedNoModel) {
  const Sandbox box{{"joint.json", kJointText}, {"record.csv", record_text(sample_record())}};
  const Outcome run = expect_done(box, {"verify", "joint.json", "record.csv", "--draws", "100",
                                        "--normal-load-std", "5%", "--out", "c.csv"});
  EXPECT_NE(run.out.find("force nrmse"), std::string::npos) << run.out;
  const CsvTable table(box.get("c.csv"), "c.csv");
  EXPECT_LT(std::stod(cells(table, "force_nrmse", "record", "predicted").front()), 0.02);
  EXPECT_EQ(cells(table, "force_nrmse", "record", "verdict").front(), "");
  EXPECT_GE(cells(table, "dissipation", "curve", "at").size(), 3U);
  EXPECT_EQ(cells(table, "dissipation", "curve", "verdict").front(), "inside");
}

TEST(verifyTests, RefusesWhatDoesNotBelong) {
  const Sandbox box = laboratory();
  box.put("sweep.csv",
          "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n"
          "79.5,1,10,0.3\n79.9,1,50,1.5\n80.3,1,12,2.8\n");
  box.put("record.csv", record_text(sample_record()));
  box.put("noise.csv", "time [s],acceleration [m/s^2]\n0,1\n1,2\n");
  const auto refuse = [&](const Arguments& call, const std::string& part) {
    const Outcome run = box.run(with(call, {"--out", "c.csv"}));
    EXPECT_EQ(run.status, 2) << run.out;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_FALSE(box.has("c.csv"));
  };
  refuse({"verify", "true.toml", "sweep.csv", "--kind", "loops"}, "--kind");
  refuse({"verify", "true.toml", "record.csv", "--kind", "sweep"}, "no stepped-sine table");
  refuse({"verify", "true.toml", "sweep.csv", "--histories", "h.csv"}, "--histories");
  refuse({"verify", "true.toml", "sweep.csv", "--draws", "40"}, "uncertainty");
  refuse({"verify", "true.toml", "sweep.csv", "--draws", "40", "--samples", "s.h5"}, "--samples");
  refuse({"verify", "true.toml", "record.csv", "--joint", "bolt"}, "--joint");
  refuse({"verify", "true.toml", "sweep.csv", "sweep.csv"}, "sweep.csv");
  refuse({"verify", "joint.json", "sweep.csv"}, "must be a model.toml");
  refuse({"verify", "joint.json", "record.csv", "--mode", "1"}, "--mode");
  refuse({"verify", "joint.json", "record.csv", "--harmonics", "3"}, "--harmonics");
  refuse({"verify", "joint.json", "noise.csv"}, "channel of force");
  refuse({"verify", "true.toml", "missing.csv"}, "missing.csv");
  refuse({"verify", "true.toml", "-"}, "must be files");
  refuse({"verify", "missing.toml", "sweep.csv"}, "missing.toml: cannot be read");
}

// Each option is for some kind of test: where no test of the call is of that kind, it would change
// nothing.
TEST(verifyTests, RefusesOptionsThatNoTestUses) {
  const Sandbox box = laboratory();
  box.put("sweep.csv",
          "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n"
          "79.5,1,10,0.3\n79.9,1,50,1.5\n80.3,1,12,2.8\n");
  box.put("modes.csv",
          "mode [1],displacement [m],frequency [Hz],damping_ratio [1]\n1,1e-4,79.8,0.002\n"
          "1,2e-4,79.6,0.003\n");
  box.put("record.csv", record_text(sample_record()));
  const auto refuse = [&](const std::string& test, const Arguments& option,
                          const std::string& part) {
    const Outcome run = box.run(with({"verify", "true.toml", test, "--out", "c.csv"}, option));
    EXPECT_EQ(run.status, 2) << run.out;
    for (const std::string& all : {option.front(), std::string("has no effect"), part}) {
      EXPECT_NE(run.err.find(all), std::string::npos) << run.err << " has no " << all;
    }
    EXPECT_FALSE(box.has("c.csv"));
  };
  refuse("sweep.csv", {"--joint", "contact"}, "applies to records of force and displacement");
  refuse("sweep.csv", {"--force", "f"}, "the tests are stepped-sine tables");
  refuse("modes.csv", {"--displacement", "x"}, "the tests are tables of modal levels");
  refuse("sweep.csv", {"--sensor", "acceleration=drive"}, "recordings of ring-downs");
  refuse("modes.csv", {"--sensor", "acceleration=drive"}, "recordings of ring-downs");
  refuse("sweep.csv", {"--mode", "1"}, "ring-downs");
  refuse("modes.csv", {"--mode", "1", "--mode", "2"}, "no test has this mode");
  refuse("sweep.csv", {"--assume-units", "SI"}, "recordings over time");
  refuse("modes.csv", {"--allow-truncated"}, "recordings over time");
  refuse("record.csv", {"--harmonics", "3"}, "tests of a structure");
  refuse("record.csv", {"--mode", "1"}, "the tests are records of force and displacement");
  // One test that uses it is enough.
  expect_done(box, {"verify", "true.toml", "sweep.csv", "modes.csv", "--mode", "1", "--harmonics",
                    "3", "--out", "c.csv"});
}

// A file of this program in the place of another is reported as what it is.
TEST(verifyTests, TellsWhichFileStandsInThePlaceOfAnother) {
  const Sandbox box = laboratory();
  box.put("rig.toml", test::kLapRig);
  box.put("sweep.csv",
          "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n"
          "79.5,1,10,0.3\n79.9,1,50,1.5\n80.3,1,12,2.8\n");
  box.put("levels.csv",
          "amplitude [m],dissipation [J],frequency [Hz]\n1e-5,1e-6,80\n2e-5,4e-6,79\n");
  const auto refuse = [&](const Arguments& call, const std::vector<std::string>& parts) {
    const Outcome run = box.run(with(call, {"--out", "c.csv"}));
    EXPECT_EQ(run.status, 2) << run.out;
    for (const std::string& part : parts) {
      EXPECT_NE(run.err.find(part), std::string::npos) << run.err << " has no " << part;
    }
  };
  refuse({"verify", "sweep.csv", "true.toml"}, {"a stepped-sine table", "true.toml before it"});
  refuse({"verify", "true.toml", "levels.csv"},
         {"a table of levels (levels.csv)", "must be a test"});
  refuse({"verify", "true.toml", "joint.json"}, {"a joint (joint.json)", "must be a test"});
  refuse({"verify", "rig.toml", "sweep.csv"}, {"a stepped-sine table", "must be a joint.json"});
  refuse({"verify", "rig.toml", "sweep.csv", "joint.json"},
         {"must be named directly after rig.toml", "Name sweep.csv after it"});
  refuse({"reduce", "rig.toml", "levels.csv"}, {"expected a recording", "a table of levels"});
  refuse({"reduce", "levels.csv", "sweep.csv"}, {"expected TOML", "a table of levels"});
  refuse({"identify", "true.toml", "--stiffness", "1e5"}, {"a structure with joints (model.toml)"});
  refuse({"loop", "true.toml", "--amplitude", "1e-5"}, {"expected JSON", "model.toml"});
  refuse({"frf", "joint.json", "--force", "1", "--frequency", "1:2"},
         {"expected TOML", "joint.json"});
  refuse({"modes", "true.toml"}, {"This is a structure with joints (model.toml), not a structure"});
}

TEST(verifyTests, SaysHowManyDrawsThereMustBe) {
  const Sandbox box = laboratory();
  box.put("record.csv", record_text(sample_record()));
  for (const char* draws : {"0", "1", "39", "x"}) {
    const Outcome run = box.run({"verify", "joint.json", "record.csv", "--normal-load-std", "5%",
                                 "--draws", draws, "--out", "c.csv"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("from 40 to 1000000"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("Leave it out for a prediction without bands"), std::string::npos);
  }
}

TEST(verifyTests, SaysThatACopyCountsTwice) {
  const Sandbox box = laboratory();
  const std::string record = record_text(sample_record());
  box.put("record.csv", record);
  box.put("copy.csv", record);
  expect_done(box, {"verify", "joint.json", "record.csv", "copy.csv", "--out", "c.csv", "--quiet"});
  EXPECT_NE(box.get("c.csv").find("# warning: same_content: copy.csv has the same content"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::cli_test::verify_tests_test
