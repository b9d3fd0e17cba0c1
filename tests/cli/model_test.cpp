// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::cli_test::model_test {
namespace {

namespace fs = std::filesystem;

/// The reference rig and its true joint, one folder below.
class RigSandbox : public Sandbox {
 public:
  RigSandbox() {
    fs::create_directory(file("test"));
    for (const char* name : {"rig.toml", "joint.json"}) {
      fs::copy_file(std::string(MICROSLIP_EXAMPLES "/reference_rig/") + name,
                    file(std::string("test/") + name));
    }
  }
};

const Arguments kCall{"model", "test/rig.toml", "test/joint.json", "--out", "model.toml"};

/// The response of the first mode, from a model.
std::vector<double> response(const Sandbox& box, const std::string& model) {
  expect_done(box, {"frf", model, "--force", "1", "--frequency", "54:57", "--out", "frf.csv"});
  const CsvTable table(box.get("frf.csv"), "frf.csv");
  return table.numbers("displacement", kLength);
}

// The model of the example was made by another route; its shapes have ten digits.
TEST(model, RespondsAsTheModelOfTheExample) {
  const RigSandbox box;
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("7 modes, 1 joint"), std::string::npos) << run.out;
  fs::copy_file(MICROSLIP_EXAMPLES "/reference_rig/model.toml", box.file("test/example.toml"));
  const std::vector<double> found = response(box, "model.toml");
  const std::vector<double> expected = response(box, "test/example.toml");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]);
  }
}

TEST(model, NamesTheJointFromItsOwnFolder) {
  const RigSandbox box;
  expect_done(box, kCall);
  EXPECT_NE(box.get("model.toml").find("file = \"test/joint.json\""), std::string::npos);
  fs::create_directory(box.file("other"));
  expect_done(box, {"model", "test/rig.toml", "test/joint.json", "--out", "other/model.toml"});
  EXPECT_NE(box.get("other/model.toml").find("file = \"../test/joint.json\""), std::string::npos);
  expect_done(box, {"backbone", "other/model.toml", "--response", "1um:50um:3", "--out", "b.csv"});
}

TEST(model, TellsItsOriginAndAnotherStiffness) {
  const RigSandbox box;
  std::string joint = box.get("test/joint.json");
  const std::string k = "\"stiffness_N_per_m\": ";
  const std::size_t at = joint.find(k);
  ASSERT_NE(at, std::string::npos);
  joint.replace(at + k.size(), joint.find(',', at) - at - k.size(), "2e5");
  box.put("test/joint.json", joint);
  const Outcome run = box.run(kCall);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("The joint has k = 2e+05 N/m"), std::string::npos) << run.err;
  const std::string text = box.get("model.toml");
  EXPECT_EQ(text.rfind("# microslip ", 0), 0U);
  EXPECT_NE(text.find("# sha256[test/rig.toml] = "), std::string::npos);
  EXPECT_NE(text.find("# sha256[test/joint.json] = "), std::string::npos);
  EXPECT_NE(text.find("\n# warning: stiffness_differs: The joint has k = 2e+05 N/m"),
            std::string::npos)
      << text;
}

// What a model cannot hold is named where the user wrote it, not in a file that is not written.
TEST(model, NamesTheRigAndTheJointThatDoNotFit) {
  const RigSandbox box;
  std::string rig = box.get("test/rig.toml");
  const std::size_t at = rig.find("\"acc1\"");
  ASSERT_NE(at, std::string::npos);
  rig.replace(at, 6, "\"a,1\"");
  box.put("test/comma.toml", rig);
  Outcome run = box.run({"model", "test/comma.toml", "test/joint.json", "--out", "model.toml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.starts_with("microslip: test/comma.toml: channel = 'a,1'; ")) << run.err;
  fs::copy_file(box.file("test/joint.json"), box.file("\xff.json"));
  run = box.run({"model", "test/rig.toml", "\xff.json", "--out", "model.toml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.starts_with("microslip: joint = '\\xFF.json'; ")) << run.err;
  EXPECT_FALSE(fs::exists(box.file("model.toml")));
}

// All the stiffness of one mode is the joint's, and the shape is rounded to three digits: what the
// message proposes does.
TEST(model, SaysHowModesHoldTheJoint) {
  const RigSandbox box;
  const auto rig = [](const std::string& shape) {
    return "schema = \"microslip.rig/1\"\n[modes]\nfrequency_Hz = [80.38]\nexcitation = [" + shape +
           "]\njoint = [" + shape +
           "]\n[damping]\nloss_factor = [0]\n[excitation]\nchannel = \"force\"\n"
           "[[accelerometer]]\nchannel = \"acc\"\nshape = [" +
           shape + "]\n";
  };
  box.put("spring.json",
          "{\"schema\": \"microslip.joint/1\", \"stiffness_N_per_m\": 508000, \"density\": "
          "[{\"type\": \"uniform\", \"from_N\": 0, \"to_N\": 5, \"weight\": 0.1}]}");
  box.put("beam.toml", rig("0.709"));
  const Outcome run = box.run({"model", "beam.toml", "spring.json", "--out", "model.toml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.starts_with("microslip: beam.toml")) << run.err;
  EXPECT_NE(run.err.find("modes.joint = [0.709]; "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("belongs to a joint of 507415 N/m at most, and k is 508000 N/m"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("0.063 % smaller"), std::string::npos) << run.err;
  box.put("beam.toml", rig("0.7085"));  // 0.07 % smaller
  expect_done(box, {"model", "beam.toml", "spring.json", "--out", "model.toml"});
}

/// Adds to a joint file what an identification says of its levels.
std::string covered_to(std::string joint, const std::string& force) {
  const std::size_t end = joint.rfind('}');
  EXPECT_NE(end, std::string::npos);
  return joint.insert(end, ", \"identification\": {\"covered_to_N\": " + force + "}");
}

// 1 mm at the exciter is 0.88 mm at the joint: 150 N.
TEST(model, PredictsBeyondTheLevelsWithAWarning) {
  const RigSandbox box;
  expect_done(box, kCall);
  const std::vector<Arguments> calls{
      {"frf", "model.toml", "--response", "1mm", "--frequency", "53:54", "--out", "frf.csv"},
      {"backbone", "model.toml", "--response", "0.1mm:1mm:2", "--out", "backbone.csv"},
      {"march", "model.toml", "--force-file", "force.csv", "--out", "march.csv"}};
  box.put("force.csv", "time [s],force [N]\n0,0\n0.005,1500\n0.01,0\n");
  const std::string joint = box.get("test/joint.json");
  for (const Arguments& call : calls) {
    box.put("test/joint.json", covered_to(joint, "50"));
    const Outcome beyond = expect_done(box, call);
    EXPECT_NE(beyond.out.find("'contact': the joint moves by"), std::string::npos) << beyond.out;
    if (call[0] != "march") {
      Arguments quiet = call;
      quiet.emplace_back("--quiet");
      expect_done(box, quiet);
      EXPECT_NE(box.get(call.back())
                    .find("\n# warning: beyond_identification: 'contact': the joint moves by"),
                std::string::npos);
    }
    box.put("test/joint.json", covered_to(joint, "5e4"));
    const Outcome within = expect_done(box, call);
    EXPECT_EQ(within.out.find("the joint moves by"), std::string::npos) << within.out;
  }
}

TEST(model, RefusesWhatItCannotName) {
  const RigSandbox box;
  expect_refused(box, {"model", "test/rig.toml", "-", "--out", "model.toml"},
                 {"standard input", "must be a file"});
  expect_refused(box, {"model", "test/rig.toml", "none.json", "--out", "model.toml"},
                 {"none.json"});
  expect_refused(box, {"model", "test/joint.json", "test/rig.toml", "--out", "model.toml"},
                 {"test/joint.json"});
  expect_refused(box, {"model", "test/rig.toml", "test/joint.json", "--out", "test/rig.toml"},
                 {"test/rig.toml"});
  EXPECT_FALSE(fs::exists(box.file("model.toml")));
}

}  // namespace
}  // namespace microslip::cli_test::model_test
