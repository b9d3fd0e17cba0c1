// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "microslip/base/random.hpp"

/// `microslip ensemble` as a user runs it. What it computes is tested in tests/ensemble.

namespace microslip::cli_test::ensemble_test {
namespace {

const std::string kPlan = R"(schema = "microslip.ensemble/1"
kind = "predict"
raw = ["peak_frequency"]
[predict]
model = "model.toml"
draws = 400
[[case]]
name = "0.05 N"
kind = "frf"
force_N = 0.05
frequency_Hz = [0.12, 0.18]
)";

Sandbox uncertain_mass() {
  std::string model = test::get(MICROSLIP_EXAMPLES "/one_mass/model.toml");
  model.insert(model.find("damping_ratio"), "frequency_std = [0.01]\n");
  return Sandbox{{"model.toml", model},
                 {"joint.json", test::get(MICROSLIP_EXAMPLES "/one_mass/joint.json")},
                 {"plan.toml", kPlan}};
}

const Arguments kCall{"ensemble", "plan.toml", "--out", "r.h5"};

TEST(Ensemble, TellsPeaksAndHowFast) {
  const Sandbox box = uncertain_mass();
  const Outcome run = expect_done(box, kCall);
  for (const char* part :
       {"jobs", "400", "a second", "failed", "result", "r.h5", "table", "r.csv"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " is not in\n" << run.out;
  }
  const std::string table = box.get("r.csv");
  for (const char* part : {"# microslip ", "microslip ensemble plan.toml --out r.h5",
                           "# predict of seed 1, 95 % between lower and upper",
                           "# sha256[model.toml] = ", "# uncertain: frequency_std",
                           "# 0.05 N: 400 jobs, 0 failed", "group,output,unit,axis,at,count,mean",
                           "0.05 N,peak_frequency,Hz,peak_of_model [Hz],0.1"}) {
    EXPECT_NE(table.find(part), std::string::npos) << part;
  }
}

// Killed at any moment, it goes on: the bytes are those of a run that nothing stopped, and no file
// stays behind but what it was to write.
TEST(Ensemble, SurvivesKills) {
  const Sandbox box = uncertain_mass();
  (void)expect_done(box, {"ensemble", "plan.toml", "--out", "whole.h5"});
  const auto names = [&] {
    std::vector<std::string> all;
    for (const auto& [name, content] : box.content()) all.push_back(name);
    return all;
  };
  const std::vector<std::string> before = names();
  RandomStream random(1, 0);
  for (const int signal : {SIGKILL, SIGINT, SIGTERM, SIGKILL}) {
    {
      Running running(kCall, box.path(), {});
      std::this_thread::sleep_for(
          std::chrono::milliseconds(static_cast<int>(5.0 + 300.0 * random.uniform())));
      running.send(signal);
      (void)running.wait();
    }
    (void)expect_done(box, kCall);
    EXPECT_EQ(box.get("r.h5"), box.get("whole.h5"));
    EXPECT_EQ(names().size(), before.size() + 2) << "r.h5 and r.csv";
  }
}

TEST(Ensemble, RefusesWhatCannotBe) {
  const Sandbox box = uncertain_mass();
  expect_refused(box, {"ensemble", "plan.toml", "--out", "-"}, {"--out", "must be a file"});
  expect_refused(box, with(kCall, {"--shard", "4/3"}), {"--shard", "NUMBER/COUNT"});
  expect_refused(box, with(kCall, {"--shard", "1/3", "--merge"}), {"--merge"});
  expect_refused(box, {"ensemble", "model.toml", "--out", "r.h5"},
                 {"model.toml", "microslip.ensemble/1", "microslip.model/1"});
  expect_refused(box, {"ensemble", "plan.toml", "--out", "model.toml"}, {"model.toml", "exists"});
  expect_refused(box, {"ensemble", "nothing.toml", "--out", "r.h5"}, {"nothing.toml"});
  box.put("model.toml", one_mass().get("model.toml"));
  expect_refused(box, kCall, {"uncertainty = none"});
}

// A full disk, at any size: status 1, and with room it goes on.
TEST(Ensemble, GoesOnWhenTheDiskHasRoomAgain) {
  const Sandbox box = uncertain_mass();
  (void)expect_done(box, {"ensemble", "plan.toml", "--out", "whole.h5"});
  for (const std::size_t size : {600U, 3000U, 20'000U}) {
    const Outcome full = box.run(kCall, {.file_size = size});
    EXPECT_EQ(full.status, 1) << size << ": " << full.err;
    EXPECT_NE(full.err.find("cannot be written"), std::string::npos) << full.err;
    EXPECT_FALSE(box.has("r.h5"));
  }
  (void)expect_done(box, kCall);
  EXPECT_EQ(box.get("r.h5"), box.get("whole.h5"));
}

TEST(Ensemble, ShowsItsProgress) {
  const Sandbox box = uncertain_mass();
  Running running(kCall, box.path(), {.columns = static_cast<unsigned short>(80)});
  const std::string shown = running.read_terminal(
      [](const std::string& text) { return text.find(" s left") != std::string::npos; });
  EXPECT_NE(shown.find("jobs ["), std::string::npos) << shown;
}

}  // namespace
}  // namespace microslip::cli_test::ensemble_test
