// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "io/support.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test::modes_test {
namespace {

const std::string kTwoJoints = MICROSLIP_TEST_DATA "/two_joints/";

/// The matrices of tests/data/two_joints with their joints.
const std::string kStructure =
    "schema = \"microslip.structure/1\"\n"
    "[matrices]\nstiffness = \"stiffness.mtx\"\nmass = \"mass.mtx\"\n"
    "[[point]]\nname = \"drive\"\nrow = 1\n"
    "[[joint]]\nname = \"joint1\"\nfrom = { row = 2 }\nto = { row = 3 }\nfile = "
    "\"truth_joint1.json\"\n"
    "[[joint]]\nname = \"joint2\"\nto = { row = 6 }\nfile = \"truth_joint2.json\"\n"
    "[modes]\ncount = 6\njoints = \"stuck\"\nloss_factor = [0.003, 0.003]\n"
    "[excitation]\npoint = \"drive\"\n";

Sandbox sandbox(const std::string& structure = kStructure) {
  return Sandbox{{"s.toml", structure},
                 {"stiffness.mtx", test::get(kTwoJoints + "stiffness.mtx")},
                 {"mass.mtx", test::get(kTwoJoints + "mass.mtx")},
                 {"truth_joint1.json", test::get(kTwoJoints + "truth_joint1.json")},
                 {"truth_joint2.json", test::get(kTwoJoints + "truth_joint2.json")}};
}

const Arguments kModes{"modes", "s.toml", "--out", "model.toml"};

// The modes of tests/data/two_joints/model.toml are of a dense solver that shares nothing with this
// one.
TEST(modes, AreThoseOfAnIndependentSolver) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, kModes);
  EXPECT_NE(run.out.find("6 modes, joints stuck"), std::string::npos) << run.out;
  EXPECT_EQ(run.err, "");
  const ModelFile found = read_model(box.file("model.toml"));
  // All six modes of six degrees of freedom: nothing is left out.
  EXPECT_EQ(found.static_attachments, std::optional<std::size_t>(0));
  const ModelFile expected = read_model(kTwoJoints + "model.toml", JointsToFind::kAllowed);
  for (std::size_t i = 0; i < 6; ++i) {
    test::record_deviation("frequency", found.structure.linear().modes()[i].angular_frequency,
                           expected.structure.linear().modes()[i].angular_frequency);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR(std::abs(found.structure.joints()[j].shape[i]),
                  std::abs(expected.structure.joints()[j].shape[i]), 1e-10);
    }
  }
}

// One loss factor for all is that of a material, which the springs of stuck joints are not of.
TEST(modes, WarnOfSpringsThatAreDampedAsTheRest) {
  const std::string two = "[0.003, 0.003]";
  std::string one = kStructure;
  const Sandbox box = sandbox(one.replace(one.find(two), two.size(), "[0.003]"));
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("which have 52 % of the strain energy of mode 6"), std::string::npos)
      << run.err;
  EXPECT_NE(test::get(box.file("model.toml")).find("springs of the joints"), std::string::npos);
}

// truth.csv is of an independent harmonic balance, exact to some 3e-6.
TEST(modes, LeadToTheBackboneThatIsKnown) {
  const Sandbox box = sandbox();
  expect_done(box, kModes);
  const testing::ReferenceTable truth = testing::reference_table("two_joints/truth.csv");
  const ModelFile model = read_model(box.file("model.toml"));
  const HarmonicBalance balance(model.structure, {model.response}, {.harmonics = 9});
  for (std::size_t i = 0; i < truth["mode [1]"].size(); i += 4) {
    const auto mode = static_cast<std::size_t>(truth["mode [1]"][i]) - 1;
    const VibrationResult found =
        balance.solve({Quantity::kResponse, truth["displacement [m]"][i]}, kPhaseResonance, mode);
    ASSERT_TRUE(found.summary.converged()) << i;
    test::record_deviation("frequency", found.vibration.frequency(), truth["frequency [Hz]"][i]);
  }
}

// A model of another folder names its joints from there.
TEST(modes, NameJointsFromWhereTheModelLies) {
  const Sandbox box = sandbox();
  std::filesystem::create_directory(box.file("out"));
  expect_done(box, {"modes", "s.toml", "--out", "out/model.toml"});
  EXPECT_EQ(read_model(box.file("out/model.toml")).joint_files[0],
            box.file("out/../truth_joint1.json"));
}

// Of a joint that is still to be found: a model that calibrate takes.
TEST(modes, KeepJointsThatAreToBeFound) {
  const Sandbox box = sandbox(
      test::replaced(kStructure, "file = \"truth_joint2.json\"", "stiffness_N_per_m = 5e5"));
  expect_done(box, kModes);
  const ModelFile model = read_model(box.file("model.toml"), JointsToFind::kAllowed);
  EXPECT_EQ(model.to_find, (std::vector<std::size_t>{1}));
  EXPECT_EQ(model.structure.joints()[1].spring_in_modes, 5e5);
}

// Without the joints nothing holds the masses behind them; the file says so as well.
TEST(modes, SayThatASupportIsMissing) {
  const std::size_t joints = kStructure.find("[[joint]]");
  const std::size_t modes = kStructure.find("[modes]");
  const Sandbox box = sandbox(std::string(kStructure).erase(joints, modes - joints));
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("1 mode of 0 Hz is restrained by nothing. Is a support missing?"),
            std::string::npos)
      << run.err;
  EXPECT_NE(box.get("model.toml").find("# warning: rigid_bodies: "), std::string::npos);
}

// K for M and M for K: both have no negative eigenvalue, but nothing vibrates so slowly.
TEST(modes, SayThatMatricesMayBeExchanged) {
  const Sandbox box =
      sandbox(test::replaced(kStructure, "stiffness = \"stiffness.mtx\"\nmass = \"mass.mtx\"",
                             "stiffness = \"mass.mtx\"\nmass = \"stiffness.mtx\""));
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("Are the matrices exchanged, or in other units?"), std::string::npos)
      << run.err;
  EXPECT_NE(box.get("model.toml").find("# warning: slow_modes: "), std::string::npos);
}

TEST(modes, RefuseByName) {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    const Sandbox box = sandbox(test::replaced(kStructure, from, to));
    expect_refused(box, kModes, {part});
  };
  refused("\"stiffness.mtx\"", "\"k.mtx\"",
          "s.toml:3:13: matrices.stiffness: k.mtx: cannot be read");
  refused("row = 1\n", "row = 7\n", "point[0].row = row 7; must be from 1 to 6");
  refused("row = 1\n", "node = 1\ndirection = \"x\"\n",
          "the degrees of freedom of the rows are not given");
  refused("name = \"joint2\"", "name = \"joint1\"", "must differ from joint[0].name");
}

TEST(modes, LeaveOtherFilesAsTheyAre) {
  const Sandbox box = sandbox();
  box.put("model.toml", "not = \"a model\"\n");
  expect_refused(box, kModes, {"model.toml"});
}

}  // namespace
}  // namespace microslip::cli_test::modes_test
