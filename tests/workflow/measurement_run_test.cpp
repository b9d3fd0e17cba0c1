// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/workflow/compare/recordings_verification.hpp"
#include "microslip/workflow/measure/measurement_run.hpp"
#include "microslip/workflow/predict/rig_model.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"
#include "support/rigs.hpp"

// The chains from files to files, each compared with the truth of the virtual test before it.
namespace microslip::measurement_run_test {
namespace {

/// Four levels of the reference rig with a uniform joint, in a folder.
class MeasurementRunFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    Rig rig = testing::reference_rig();
    rig.test->count = 4;
    rig.test->response_to = 20.0;
    rig.contact.joint = "truth.json";
    const Joint truth(1.7e5, SlipDensity({UniformPart{.from = 0.0, .to = 60.0, .weight = 1.0}}));
    test::put(folder_.file("rig.toml"), format_rig(rig));
    test::put(folder_.file("truth.json"), format_joint({truth, {}, {}}));
    plan_ = {.rig = folder_.file("rig.toml"), .out = folder_.file("test"), .command = "call"};
  }

  [[nodiscard]] std::string file(const std::string& name) const {
    return folder_.file("test/" + name);
  }

  [[nodiscard]] std::vector<std::string> records() const {
    std::vector<std::string> paths;
    for (int i = 1; i <= 4; ++i) paths.push_back(file("level_0" + std::to_string(i) + ".csv"));
    return paths;
  }

  test::TemporaryFolder folder_;
  MeasurementRun plan_;
};

// Of 1 s with 55 cycles; the noise of the reference rig leaves fractions of a per cent of D.
TEST_F(MeasurementRunFiles, LevelsAreThoseOfTheTruth) {
  const FinishedMeasurement done = run_measurement(plan_);
  EXPECT_EQ(done.records.front(), "level_01.csv");
  const ReducedRecordings reduced =
      reduce_recordings({.test = file("rig.toml"), .recordings = records()});
  const CsvTable levels(levels_text(reduced, "call"), "levels.csv");
  const CsvTable truth(read_file(file("truth.csv")), "truth.csv");
  const std::vector<double> found = levels.numbers("dissipation", kEnergy);
  const std::vector<double> exact = truth.numbers("dissipation", kEnergy);
  ASSERT_EQ(found.size(), 4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i] / exact[i], 1.0, 0.02) << i;
}

// By the true joint only the noise is left: some 1e-3 of the signals.
TEST_F(MeasurementRunFiles, TheTrueJointPredictsItsRecords) {
  (void)run_measurement(plan_);
  const VerifiedRecordings verified = verify_recordings(
      {.rig = file("rig.toml"), .joint = folder_.file("truth.json"), .recordings = records()});
  ASSERT_EQ(verified.batch.records.size(), 4);
  for (const ChannelComparison& channel : verified.batch.records.back().channels) {
    EXPECT_LT(channel.nrmse, 0.01) << channel.name;
  }
  OutputFiles files;
  add_tables(verified, {.table = file("verification.csv"), .harmonics = {}, .histories = {}},
             "call", files);
  files.commit();
  EXPECT_EQ(read_experiment(file("")).comparisons.size(), 4 * 5);
}

TEST_F(MeasurementRunFiles, AFolderOfAnotherTestIsRefused) {
  (void)run_measurement(plan_);
  test::put(file("level_05.csv"), "time [s],force [N]\n0,1\n1,2\n");
  EXPECT_THROW((void)run_measurement(plan_), InputError);
}

// The file holds all digits; the first resonance is that of the stuck beam, which seven modes on
// the spring of the contact give to 1e-3.
TEST_F(MeasurementRunFiles, TheModelHasTheResonancesOfTheRig) {
  const RigModel model =
      model_of_rig(plan_.rig, folder_.file("truth.json"), folder_.file("model.toml"), 7, "call");
  const ModelFile read = parse_model(model.text, folder_.file("model.toml"));
  const std::vector<double> omega = read.structure.stuck_frequencies();
  const std::vector<double> made = model.file.structure.stuck_frequencies();
  ASSERT_EQ(omega.size(), 7);
  for (std::size_t i = 0; i < omega.size(); ++i) EXPECT_NEAR(omega[i] / made[i], 1.0, 1e-12);
  EXPECT_NEAR(omega[0] / stick_state(testing::reference_rig(), 7).omega[0], 1.0, 1e-3);
}

TEST_F(MeasurementRunFiles, FoldersThatHoldAFile) {
  (void)run_measurement(plan_);
  const std::string all = folder_.file("");
  EXPECT_EQ(folders_holding(all, {"levels.csv", "rig.toml"}).size(), 1);
  EXPECT_TRUE(folders_holding(all, {"levels.csv"}).empty());
  EXPECT_THROW((void)read_experiment(folder_.file("rig.toml")), FileError);
}

// Of four records two are over time, all have their harmonics, and the first of the force is that
// of the truth; noise of 2 mN over 8192 samples.
TEST_F(MeasurementRunFiles, RecordsOfAFolderAreRead) {
  (void)run_measurement(plan_);
  const ExperimentResults results = read_experiment(file(""), 2);
  ASSERT_EQ(results.records.size(), 4);
  EXPECT_FALSE(results.records[0].signals.empty());
  EXPECT_TRUE(results.records[1].signals.empty());
  const std::vector<double>& force = results.true_levels->force_amplitude;
  ASSERT_EQ(force.size(), 4);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(results.records[i].harmonics[0].recorded[0], force[i], 2e-3) << i;
  }
}

}  // namespace
}  // namespace microslip::measurement_run_test
