// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/effort.hpp"
#include "support/thinned_table.hpp"

namespace microslip::cli_test::calibrate_test {
namespace {

const std::string kFolder = MICROSLIP_TEST_DATA "/two_joints/";

std::string edited(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

Sandbox two_joints() {
  return Sandbox{{"model.toml", test::get(kFolder + "model.toml")},
                 {"levels.csv", testing::every_third_row(test::get(kFolder + "modal_levels.csv"))},
                 {"truth_joint2.json", test::get(kFolder + "truth_joint2.json")}};
}

const Arguments kCall{"calibrate", "model.toml", "levels.csv", "--samples",
                      "100",       "--out",      "found"};

/// Whether the model names draws of each joint that are there.
void expect_draws_of_both(const std::string& path) {
  const ModelFile model = read_model(path);
  ASSERT_EQ(model.joint_samples.size(), 2U);
  for (const std::string& samples : model.joint_samples) {
    EXPECT_TRUE(std::filesystem::exists(samples)) << samples;
  }
}

/// The model with its frequencies times a factor.
std::string with_frequencies_times(const std::string& model, double factor) {
  const std::string key = "frequency_Hz = [";
  const std::size_t begin = model.find(key) + key.size();
  const std::size_t end = model.find(']', begin);
  std::string scaled;
  std::istringstream values(model.substr(begin, end - begin));
  for (std::string value; std::getline(values, value, ',');) {
    scaled += fmt::format("{}{:.12g}", scaled.empty() ? "" : ", ", factor * std::stod(value));
  }
  return model.substr(0, begin) + scaled + model.substr(end);
}

// The levels are those of a structure whose frequencies the model has 0.75 % too high: they are
// corrected to 0.05 %, or 0.75 % are its standard deviation.
TEST(calibrate, CorrectsTheFrequenciesOfTheModel) {
  const Sandbox box = two_joints();
  const ModelFile truth = read_model(box.file("model.toml"), JointsToFind::kAllowed);
  box.put("model.toml", with_frequencies_times(box.get("model.toml"), 1.0075));
  const Outcome given = expect_done(box, kCall);
  EXPECT_NE(given.out.find("--model-frequencies corrected"), std::string::npos) << given.out;
  const Outcome run = expect_done(box, {"calibrate", "model.toml", "levels.csv", "--samples", "100",
                                        "--out", "corrected", "--model-frequencies", "corrected"});
  EXPECT_NE(run.out.find("corrected in model.toml"), std::string::npos) << run.out;
  const ModelFile as_given = read_model(box.file("found/model.toml"));
  const ModelFile corrected = read_model(box.file("corrected/model.toml"));
  for (std::size_t i = 0; i < truth.structure.linear().size(); ++i) {
    const double omega = truth.structure.linear().modes()[i].angular_frequency;
    EXPECT_NEAR(as_given.structure.linear().modes()[i].angular_frequency, 1.0075 * omega,
                1e-9 * omega);
    EXPECT_NEAR(as_given.spread.frequency[i], 0.0075, 0.0005);
    EXPECT_NEAR(corrected.structure.linear().modes()[i].angular_frequency, omega, 5e-4 * omega);
    EXPECT_LT(corrected.spread.frequency[i], 5e-4);
  }
}

// The draws that are kept are those that predictions by the model vary, also where a later
// calibration of another joint writes it to another folder.
TEST(calibrate, NamesTheDrawsInTheModel) {
  const Sandbox box = two_joints();
  expect_done(box, with(kCall, {"--keep-samples"}));
  expect_draws_of_both(box.file("found/model.toml"));
  const std::string given = edited(box.get("model.toml"), "stiffness_N_per_m = 500000",
                                   "file = \"found/joint2.json\"\n"
                                   "samples = \"found/joint2_samples.h5\"");
  box.put("known.toml", given);
  expect_done(box, {"calibrate", "known.toml", "levels.csv", "--samples", "100", "--out", "again",
                    "--keep-samples"});
  expect_draws_of_both(box.file("again/model.toml"));
}

// The folder predicts what was measured: the backbone of its model has the frequencies of the
// truth.
TEST(calibrate, WritesAFolderThatPredicts) {
  const Sandbox box = two_joints();
  box.put("levels.csv", test::get(kFolder + "modal_levels.csv"));
  const Outcome run = expect_done(box, with(kCall, {"--keep-samples"}));
  for (const std::string part : {"75 of 1 file", "joint1", "joint2", "known to"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in:\n" << run.out;
  }
  const CsvTable calibration(box.get("found/calibration.csv"), "calibration.csv");
  EXPECT_EQ(calibration.rows(), 75U);
  for (const double residual : calibration.numbers("residual", kDimensionless)) {
    EXPECT_LT(std::abs(residual), 5.0);
  }
  const CsvTable table(box.get("found/identifiability.csv"), "identifiability.csv");
  EXPECT_GT(std::ranges::max(table.numbers("told", kDimensionless)), 0.9);

  const JointFile joint = parse_joint(box.get("found/joint2.json"), "joint2.json");
  EXPECT_EQ(joint.joint.stiffness(), 5e5);
  ASSERT_TRUE(joint.provenance.has_value());
  EXPECT_EQ(joint.provenance->inputs.size(), 2U);
  // The largest amplitude of the truth, which is found within 0.5 %.
  const CsvTable truth(test::get(kFolder + "truth.csv"), "truth.csv");
  const double covered = 5e5 * std::ranges::max(truth.numbers("amplitude_joint2", kLength));
  EXPECT_NEAR(covered_to(joint).value(), covered, 0.005 * covered);
  const JointSamples samples = read_joint_samples(box.file("found/joint2_samples.h5"));
  EXPECT_EQ(samples.size(), 100U);

  // At the largest level of the first mode. Its frequency falls as the joints soften, which the
  // losses tell as well as they are known themselves, to 0.5 %.
  const std::vector<double> mode = truth.numbers("mode", kDimensionless);
  const auto count = static_cast<std::size_t>(std::ranges::count(mode, 1.0));
  const double displacement = truth.numbers("displacement", kLength)[count - 1];
  const std::vector<double> frequency = truth.numbers("frequency", kFrequency);
  expect_done(box, {"backbone", "found/model.toml", "--response",
                    fmt::format("{:.12g}:{:.12g}:2", displacement, 1.001 * displacement), "--out",
                    "b.csv"});
  const CsvTable curve(box.get("b.csv"), "b.csv");
  const double fall = frequency[0] - frequency[count - 1];
  EXPECT_GT(fall, 0.5);
  EXPECT_NEAR(curve.numbers("frequency", kFrequency)[0], frequency[count - 1], 0.005 * fall);
}

TEST(calibrate, WritesTheSameBytesAgain) {
  MICROSLIP_STUDY();  // Calibration.IsTheSameOnAnyNumberOfThreads compares two results, too
  const Sandbox box = two_joints();
  expect_done(box, kCall);
  const std::string first = box.get("found/joint1.json");
  expect_done(box, kCall);
  EXPECT_EQ(box.get("found/joint1.json"), first);
}

// A joint with a file is known: it is used, named from the new folder, and not written.
TEST(calibrate, UsesAJointThatIsKnown) {
  const Sandbox box = two_joints();
  box.put("model.toml", edited(box.get("model.toml"), "stiffness_N_per_m = 500000\n",
                               "file = \"truth_joint2.json\"\n"));
  expect_done(box, kCall);
  EXPECT_FALSE(box.has("found/joint2.json"));
  EXPECT_NE(box.get("found/model.toml").find("file = \"../truth_joint2.json\""), std::string::npos);
  expect_done(box, {"backbone", "found/model.toml", "--response", "1e-5:2e-5:2", "--out", "b.csv"});
}

TEST(calibrate, NamesWhatIsWrong) {
  const std::string model = test::get(kFolder + "model.toml");
  const std::string levels = test::get(kFolder + "modal_levels.csv");
  const auto expect = [&](const std::string& part, const std::string& model_text,
                          const std::string& levels_text, const Arguments& more = {}) {
    const Sandbox box{{"model.toml", model_text},
                      {"levels.csv", levels_text},
                      {"truth_joint2.json", test::get(kFolder + "truth_joint2.json")}};
    expect_refused(box, with(kCall, more), {part});
  };
  expect("a mode of the model, from 1 to 6", model, edited(levels, "\n1,", "\n7,"));
  expect("file", edited(model, "stiffness_N_per_m = 900000\n", ""), levels);
  expect("must differ from joint[0].name", edited(model, "\"joint2\"", "\"joint1\""), levels);
  expect("must be usable as the name of a file", edited(model, "\"joint2\"", "\"a/b\""), levels);
  // dissipation_lower_joint1 is of the band of joint1.
  expect("must not begin with lower_ or upper_", edited(model, "\"joint2\"", "\"lower_joint1\""),
         levels);
  expect("the loss of joint 'std'", edited(model, "\"joint2\"", "\"std\""), levels);
  expect("must be absolute to find stiffnesses", model, levels, {"--stiffness", "fit"});
  expect("--samples", model, levels, {"--samples", "10"});
  expect("--harmonics", model, levels, {"--harmonics", "0"});
  expect("--edges", model, levels, {"--edges", "maybe"});
  std::string known =
      edited(model, "stiffness_N_per_m = 500000\n", "file = \"truth_joint2.json\"\n");
  known = edited(known, "stiffness_N_per_m = 900000\n", "file = \"truth_joint2.json\"\n");
  expect("joints to find is none", known, levels);
}

// What a prediction needs is there, or it says what to do.
TEST(calibrate, APredictionRefusesJointsThatAreToBeFound) {
  const Sandbox box = two_joints();
  const Outcome run =
      box.run({"backbone", "model.toml", "--response", "1e-5:2e-5:2", "--out", "b.csv"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("Identify it first with calibrate"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace microslip::cli_test::calibrate_test
