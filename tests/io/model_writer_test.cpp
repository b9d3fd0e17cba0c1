// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"

namespace microslip::model_writer_test {
namespace {

const std::string kJointFile = MICROSLIP_EXAMPLES "/reference_joint/joint.json";

void expect_equal(std::span<const double> found, std::span<const double> expected) {
  EXPECT_TRUE(std::ranges::equal(found, expected));
}

/// Two modes, a joint with all that one may have, two forces with harmonics.
ModelFile two_modes(DampingLaw damping) {
  const Joint joint = read_joint(kJointFile).joint;
  ModalModel linear({{314.15926535, 0.01}, {1234.5, 0.002}},
                    {{"tip", {1.0 / 3.0, -0.1}}, {"a \\ back'slash", {0.5, 1e-300}}});
  StructuralJoint contact{.name = "contact",
                          .joint = joint,
                          .shape = {0.2, 0.7},
                          .spring_in_modes = 100.5,
                          .series_compliance = 1.4e-8,
                          .shortening = {20.5, 6.4, 6.4, 77.0},
                          .linear_damping = 123.4};
  return {JointedStructure(std::move(linear), {std::move(contact)},
                           {{"tip", {1.0}}, {"a \\ back'slash", {{0.5, -0.25}, {0.0, 0.125}}}},
                           damping),
          "a \\ back'slash",
          {kJointFile}};
}

// Only ω passes through a division by 2π: an error of 2 ulp is what that and the way back leave.
TEST(ModelWriter, IsReadBackAsTheSameModel) {
  for (const DampingLaw damping : {DampingLaw::kViscous, DampingLaw::kHysteretic}) {
    const ModelFile model = two_modes(damping);
    const ModelFile again = parse_model(format_model(model), "model.toml");
    EXPECT_EQ(again.response, model.response);
    EXPECT_EQ(again.joint_files, model.joint_files);
    const ModalModel& linear = model.structure.linear();
    const ModalModel& read = again.structure.linear();
    EXPECT_EQ(again.structure.damping(), damping);
    ASSERT_EQ(read.size(), linear.size());
    for (std::size_t i = 0; i < linear.size(); ++i) {
      const double omega = linear.modes()[i].angular_frequency;
      EXPECT_NEAR(read.modes()[i].angular_frequency, omega, 5e-16 * omega);
      EXPECT_EQ(read.modes()[i].loss_factor, linear.modes()[i].loss_factor);
    }
    ASSERT_EQ(read.points().size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read.points()[i].name, linear.points()[i].name);
      expect_equal(read.points()[i].shape, linear.points()[i].shape);
    }
    const StructuralJoint& joint = again.structure.joints()[0];
    const StructuralJoint& contact = model.structure.joints()[0];
    EXPECT_EQ(joint.name, contact.name);
    expect_equal(joint.shape, contact.shape);
    expect_equal(joint.shortening, contact.shortening);
    EXPECT_EQ(joint.spring_in_modes, contact.spring_in_modes);
    EXPECT_EQ(joint.series_compliance, contact.series_compliance);
    EXPECT_EQ(joint.linear_damping, contact.linear_damping);
    EXPECT_EQ(joint.joint.stiffness(), contact.joint.stiffness());
  }
}

// A reader takes that of the joint file where the model does not say.
TEST(ModelWriter, SaysThatAJointHasNoLinearDampingWhereItsFileHasSome) {
  const test::TemporaryFolder folder;
  ModelFile model = two_modes(DampingLaw::kViscous);
  std::vector<StructuralJoint> joints(model.structure.joints().begin(),
                                      model.structure.joints().end());
  joints.front().linear_damping = 0.0;
  const std::vector<Excitation> excitations(model.structure.excitations().begin(),
                                            model.structure.excitations().end());
  model.structure = JointedStructure(model.structure.linear(), joints, excitations);
  const JointFile joint{.joint = joints.front().joint,
                        .provenance = {},
                        .identification = {{"linear_damping_J_per_m2", 4672.0}}};
  model.joint_files = {folder.file("joint.json")};
  test::put(folder.file("joint.json"), format_joint(joint));
  for (const bool known : {false, true}) {
    if (known) model.identified_damping = {identified_damping(joint)};
    const ModelFile again = parse_model(format_model(model), "model.toml");
    EXPECT_EQ(again.structure.joints()[0].linear_damping, 0.0) << known;
    EXPECT_EQ(again.identified_damping, std::vector<std::optional<double>>{4672.0});
  }
  model.identified_damping = {std::nullopt};
  EXPECT_EQ(format_model(model).find("linear_damping"), std::string::npos) << "nothing to say";
}

// With the key all draws would have that damping, and not each its own.
TEST(ModelWriter, LeavesTheLinearDampingToTheDrawsThatBringTheirs) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  const auto says = [&] { return format_model(model).find("linear_damping") != std::string::npos; };
  model.identified_damping = {model.structure.joints()[0].linear_damping};
  model.damping_said = {false};
  EXPECT_TRUE(says()) << "no draws";
  model.joint_samples = {"joint_samples.h5"};
  EXPECT_FALSE(says());
  model.damping_said = {true};
  EXPECT_TRUE(says()) << "said by the model";
  model.damping_said = {false};
  model.identified_damping = {1.0};
  EXPECT_TRUE(says()) << "another than that of the joint file";
}

// An amplitude and a phase of each are written: rounding of either is 2 ulp.
TEST(ModelWriter, KeepsTheHarmonicsOfTheForces) {
  const ModelFile model = two_modes(DampingLaw::kViscous);
  const ModelFile again = parse_model(format_model(model), "model.toml");
  ASSERT_EQ(again.structure.excitations().size(), 2U);
  for (std::size_t d = 0; d < 2; ++d) {
    const Excitation& read = again.structure.excitations()[d];
    const Excitation& written = model.structure.excitations()[d];
    EXPECT_EQ(read.point, written.point);
    ASSERT_EQ(read.harmonics.size(), written.harmonics.size());
    for (std::size_t n = 0; n < read.harmonics.size(); ++n) {
      EXPECT_LE(std::abs(read.harmonics[n] - written.harmonics[n]), 1e-15);
    }
  }
}

TEST(ModelWriter, KeepsTheChannelsOfRecordings) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  model.force_channels = {"force", ""};
  model.accelerometers = {{"acc1", "tip"}, {"acc2", "a \\ back'slash"}};
  const ModelFile again = parse_model(format_model(model), "model.toml");
  EXPECT_EQ(again.force_channels, model.force_channels);
  ASSERT_EQ(again.accelerometers.size(), 2U);
  EXPECT_EQ(again.accelerometers[1].channel, "acc2");
  EXPECT_EQ(again.accelerometers[1].point, "a \\ back'slash");
}

TEST(ModelWriter, BeginsWithTheComment) {
  const std::string text = format_model(two_modes(DampingLaw::kViscous), "one\ntwo \x1b three");
  EXPECT_EQ(text.substr(0, text.find("schema")), "# one\n# two   three\n");
  EXPECT_NO_THROW((void)parse_model(text, "model.toml"));
}

TEST(ModelWriter, WantsAFileForEachJoint) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  model.joint_files.clear();
  EXPECT_THROW((void)format_model(model), InputError);
}

// What is uncertain of a model is in it again.
TEST(ModelWriter, KeepsWhatIsUncertain) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  model.joint_samples = {"draws.h5"};
  model.spread = {.frequency = {0.01, 0.0},
                  .loss_factor = {0.1, 0.2},
                  .normal_load = {0.05},
                  .force_gain = {0.0, 0.02},
                  .response_gain = 0.03};
  const ModelFile again = parse_model(format_model(model), "model.toml");
  EXPECT_EQ(again.joint_samples, model.joint_samples);
  EXPECT_EQ(again.spread.frequency, model.spread.frequency);
  EXPECT_EQ(again.spread.loss_factor, model.spread.loss_factor);
  EXPECT_EQ(again.spread.normal_load, model.spread.normal_load);
  EXPECT_EQ(again.spread.force_gain, model.spread.force_gain);
  EXPECT_EQ(again.spread.response_gain, model.spread.response_gain);
}

// Modes of a residual are written as such, so that what was read gives the same model again.
TEST(ModelWriter, KeepsHowManyModesAreAttachments) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  EXPECT_EQ(parse_model(format_model(model), "model.toml").static_attachments, std::nullopt);
  for (const std::size_t count : {0U, 1U}) {
    model.static_attachments = count;
    EXPECT_EQ(parse_model(format_model(model), "model.toml").static_attachments,
              std::optional<std::size_t>(count));
  }
}

// Bases, what is driven by them, and loads that always act.
TEST(ModelWriter, KeepsBasesAndStaticLoads) {
  ModelFile model = two_modes(DampingLaw::kViscous);
  const JointedStructure& given = model.structure;
  const std::vector<ModalPoint> points(given.linear().points().begin(),
                                       given.linear().points().end());
  model.structure = JointedStructure(
      ModalModel({given.linear().modes().begin(), given.linear().modes().end()}, points,
                 {{"table", {1.5, -0.25}, {1.0, 0.5}}}),
      {given.joints().begin(), given.joints().end()}, {{"table", {1.0, {0.0, 0.5}}}},
      DampingLaw::kViscous, {{"tip", 120.0}, {"table", -9.81}});
  const ModelFile again = parse_model(format_model(model), "model.toml");
  ASSERT_EQ(again.structure.linear().bases().size(), 1U);
  const ModalBase& base = again.structure.linear().bases()[0];
  EXPECT_EQ(base.name, "table");
  EXPECT_EQ(base.participation, (std::vector<double>{1.5, -0.25}));
  EXPECT_EQ(base.point_motion, (std::vector<double>{1.0, 0.5}));
  EXPECT_TRUE(again.structure.base_driven());
  ASSERT_EQ(again.structure.static_loads().size(), 2U);
  EXPECT_EQ(again.structure.static_loads()[0].place, "tip");
  EXPECT_EQ(again.structure.static_loads()[0].value, 120.0);
  EXPECT_EQ(again.structure.static_loads()[1].place, "table");
  EXPECT_EQ(again.structure.static_loads()[1].value, -9.81);
}

}  // namespace
}  // namespace microslip::model_writer_test
