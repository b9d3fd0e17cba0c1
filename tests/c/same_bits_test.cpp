// SPDX-License-Identifier: MIT
// The results of the C interface are those of the library, to the last bit: it passes values on.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "c/handle.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"

namespace microslip::test::same_bits {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A density with one part of each kind that may be combined with others.
const std::vector<double> kKnots{0.0, 5.0, 12.0};
const std::vector<double> kDensity{0.01, 0.03, 0.0};
const std::vector<double> kAtoms{9.0, 3.0};
const std::vector<double> kWeights{0.1, 0.2};
constexpr double kStiffness = 1.7e5;

std::vector<microslip_part> c_parts() {
  std::vector<microslip_part> parts(4, defaults(microslip_part_defaults));
  parts[0].kind = MICROSLIP_PART_UNIFORM;
  parts[0].from = 1.0;
  parts[0].to = 4.0;
  parts[0].weight = 0.1;
  parts[1].kind = MICROSLIP_PART_POWER_LAW;
  parts[1].coefficient = 0.02;
  parts[1].exponent = -0.5;
  parts[1].to = 10.0;
  parts[2].kind = MICROSLIP_PART_PIECEWISE_LINEAR;
  parts[2].count = kKnots.size();
  parts[2].slip_force = kKnots.data();
  parts[2].value = kDensity.data();
  parts[3].kind = MICROSLIP_PART_ATOMS;
  parts[3].count = kAtoms.size();
  parts[3].slip_force = kAtoms.data();
  parts[3].value = kWeights.data();
  return parts;
}

Joint cpp_joint() {
  return Joint(kStiffness,
               SlipDensity({UniformPart{1.0, 4.0, 0.1}, PowerLawPart{0.02, -0.5, 0.0, 10.0},
                            PiecewiseLinearPart{kKnots, kDensity}, AtomsPart{kAtoms, kWeights}}));
}

void make(CJoint& joint) {
  const auto parts = c_parts();
  ASSERT_OK(microslip_joint_create(kStiffness, parts.data(), parts.size(), joint.out()));
}

/// A path with loops in loops, in and beyond micro-slip.
std::vector<double> path() {
  std::vector<double> x;
  for (int i = 0; i < 500; ++i) {
    x.push_back(1e-4 * std::sin(0.11 * i) * std::sin(0.013 * i) + 2e-5 * std::sin(1.7 * i));
  }
  return x;
}

TEST(CJoint, HasTheCurvesOfTheLibrary) {
  CJoint joint;
  make(joint);
  const Joint expected = cpp_joint();
  const std::vector<double> x = path();
  std::vector<double> c(x.size());
  ASSERT_OK(microslip_virgin_force(joint, x.size(), x.data(), c.data()));
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(c[i], expected.virgin_force(x[i]));
  ASSERT_OK(microslip_tangent_stiffness(joint, x.size(), x.data(), c.data()));
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(c[i], expected.tangent_stiffness(x[i]));

  std::vector<double> a;
  for (const double value : x) a.push_back(std::abs(value));
  ASSERT_OK(microslip_dissipation(joint, a.size(), a.data(), c.data()));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(c[i], dissipation(expected, a[i]));
  ASSERT_OK(microslip_secant_stiffness(joint, a.size(), a.data(), c.data()));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(c[i], secant_stiffness(expected, a[i]));
  std::vector<double> s;
  for (const double value : a) s.push_back(kStiffness * value);
  ASSERT_OK(microslip_density(joint, s.size(), s.data(), s.data()));  // into itself
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(s[i], expected.density().density(kStiffness * a[i]));
  }
}

TEST(CJoint, TellsItsParts) {
  CJoint joint;
  make(joint);
  std::size_t count = 0;
  double stiffness = 0.0;
  ASSERT_OK(microslip_joint_part_count(joint, &count));
  ASSERT_OK(microslip_joint_stiffness(joint, &stiffness));
  EXPECT_EQ(stiffness, kStiffness);
  const auto given = c_parts();
  ASSERT_EQ(count, given.size());
  for (std::size_t i = 0; i < count; ++i) {
    microslip_part part = defaults(microslip_part_defaults);
    ASSERT_OK(microslip_joint_part(joint, i, &part));
    EXPECT_EQ(part.kind, given[i].kind);
    EXPECT_EQ(part.from, given[i].from);
    EXPECT_EQ(part.to, given[i].to);
    EXPECT_EQ(part.weight, given[i].weight);
    EXPECT_EQ(part.coefficient, given[i].coefficient);
    EXPECT_EQ(part.exponent, given[i].exponent);
    ASSERT_EQ(part.count, given[i].count);
    for (std::size_t j = 0; j < part.count; ++j) {
      EXPECT_EQ(part.slip_force[j], given[i].slip_force[j]);
      EXPECT_EQ(part.value[j], given[i].value[j]);
    }
  }
}

TEST(CJoint, OfFourParametersIsThatOfTheLibrary) {
  microslip_part part = defaults(microslip_part_defaults);
  part.kind = MICROSLIP_PART_FOUR_PARAMETER;
  part.macroslip_force = 0.2;
  part.chi = -0.5;
  part.beta = 0.3;
  CJoint joint;
  ASSERT_OK(microslip_joint_create(0.25, &part, 1, joint.out()));
  const Joint expected = Joint::four_parameter(0.2, 0.25, -0.5, 0.3);
  for (const double x : {0.0, 0.1, -0.4, 1.0, 7.0}) {
    double force = 0.0;
    ASSERT_OK(microslip_virgin_force(joint, 1, &x, &force));
    EXPECT_EQ(force, expected.virgin_force(x));
  }
  microslip_part found = defaults(microslip_part_defaults);
  ASSERT_OK(microslip_joint_part(joint, 0, &found));
  EXPECT_EQ(found.macroslip_force, 0.2);
  EXPECT_EQ(found.chi, -0.5);
  EXPECT_EQ(found.beta, 0.3);
}

TEST(CJoint, WritesTheFileOfTheLibrary) {
  CJoint joint;
  make(joint);
  const std::string path = ::testing::TempDir() + "/c_joint.json";
  ASSERT_OK(microslip_joint_write(joint, path.c_str()));
  JointFile written{cpp_joint(), Provenance{}, {}};
  written.provenance->version = microslip_version();
  written.provenance->command = "microslip_joint_write";  // a file without would not be replaced
  EXPECT_EQ(content_of(path), format_joint(written));
  CJoint again;
  ASSERT_OK(microslip_joint_read(path.c_str(), again.out()));
  const char* text = nullptr;
  ASSERT_OK(microslip_joint_text(again, &text));
  EXPECT_EQ(text, content_of(path));
  CJoint parsed;
  ASSERT_OK(microslip_joint_parse(text, parsed.out()));
  std::filesystem::remove(path);
}

TEST(CMemory, IsThatOfTheLibraryOnAnyPath) {
  CJoint joint;
  make(joint);
  CMemory memory;
  ASSERT_OK(microslip_memory_create(joint, memory.out()));
  const Joint of = cpp_joint();
  Memory expected(of);
  for (const double x : path()) {
    double force = 0.0;
    double tangent = 0.0;
    double lost = 0.0;
    double stored = 0.0;
    ASSERT_OK(microslip_memory_trial(memory, x, &force, &tangent));
    const Memory::Response trial = expected.trial(x);
    EXPECT_EQ(force, trial.force);
    EXPECT_EQ(tangent, trial.tangent);
    ASSERT_OK(microslip_memory_dissipation(memory, x, &lost));
    EXPECT_EQ(lost, expected.dissipation(x));
    ASSERT_OK(microslip_memory_advance(memory, x, &force));
    EXPECT_EQ(force, expected.advance(x));
    ASSERT_OK(microslip_memory_stored_energy(memory, &stored));
    EXPECT_EQ(stored, expected.stored_energy());
  }
  double x = 0.0;
  double force = 0.0;
  ASSERT_OK(microslip_memory_state(memory, &x, &force));
  EXPECT_EQ(x, expected.displacement());
  EXPECT_EQ(force, expected.force());
}

TEST(CMemory, MarchesAsTheLibrary) {
  CJoint joint;
  make(joint);
  CMemory memory;
  ASSERT_OK(microslip_memory_create(joint, memory.out()));
  const std::vector<double> x = path();
  std::vector<double> force(x.size());
  ASSERT_OK(microslip_memory_march(memory, x.size(), x.data(), force.data()));
  std::vector<double> expected(x.size());
  const Joint of = cpp_joint();
  Memory(of).march(x, expected);
  EXPECT_EQ(force, expected);
}

TEST(CMemory, ReturnsToASnapshotAndToTheBeginning) {
  CJoint joint;
  make(joint);
  CMemory memory;
  CMemory snapshot;
  ASSERT_OK(microslip_memory_create(joint, memory.out()));
  joint.destroy();  // the memory holds what it needs
  ASSERT_OK(microslip_memory_advance(memory, 5e-5, nullptr));
  ASSERT_OK(microslip_memory_advance(memory, 1e-5, nullptr));
  ASSERT_OK(microslip_memory_copy(memory, snapshot.out()));
  double before = 0.0;
  ASSERT_OK(microslip_memory_trial(memory, 3e-5, &before, nullptr));
  ASSERT_OK(microslip_memory_advance(memory, -8e-5, nullptr));
  ASSERT_OK(microslip_memory_assign(memory, snapshot));
  snapshot.destroy();
  double after = 0.0;
  ASSERT_OK(microslip_memory_trial(memory, 3e-5, &after, nullptr));
  EXPECT_EQ(after, before);
  ASSERT_OK(microslip_memory_reset(memory));
  ASSERT_OK(microslip_memory_trial(memory, 3e-5, &after, nullptr));
  EXPECT_EQ(after, cpp_joint().virgin_force(3e-5));
}

TEST(CThreads, ShareWhatDoesNotChange) {
  CJoint joint;
  make(joint);
  const std::vector<double> x = path();
  std::vector<double> expected(x.size());
  const Joint of = cpp_joint();
  Memory(of).march(x, expected);
  std::vector<std::vector<double>> force(8, std::vector<double>(x.size()));
  std::vector<const char*> text(force.size(), nullptr);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < force.size(); ++i) {
    threads.emplace_back([&, i] {
      CMemory memory;
      EXPECT_OK(microslip_memory_create(joint, memory.out()));
      EXPECT_OK(microslip_memory_march(memory, x.size(), x.data(), force[i].data()));
      EXPECT_OK(microslip_joint_text(joint, &text[i]));  // made by the first that asks
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_EQ(force[i], expected);
    EXPECT_EQ(text[i], text[0]);
  }
}

Levels measured() {
  Levels levels;
  const Joint truth(2e5, SlipDensity({UniformPart{0.0, 20.0, 0.8}}));
  for (int i = 1; i <= 30; ++i) {
    const double a = 4e-6 * i;
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(truth, a) * (1.0 + 0.02 * std::sin(7.0 * i)));
    levels.dissipation_std.push_back(0.02 * dissipation(truth, a));
  }
  return levels;
}

void make(const Levels& from, CLevels& levels) {
  ASSERT_OK(microslip_levels_create(from.size(), from.amplitude.data(), from.dissipation.data(),
                                    levels.out()));
  ASSERT_OK(microslip_levels_set(levels, MICROSLIP_LEVEL_DISSIPATION_STD, from.size(),
                                 from.dissipation_std.data()));
}

void expect_values(const microslip_identification* found, microslip_identified_values what,
                   const std::vector<double>& expected) {
  const double* values = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_identification_values(found, what, &values, &count));
  expect_same(values, count, expected);
}

double number_of(const microslip_identification* found, microslip_identified_number what) {
  double value = 0.0;
  EXPECT_OK(microslip_identification_number(found, what, &value));
  return value;
}

TEST(CIdentify, IsTheIdentificationOfTheLibrary) {
  CLevels levels;
  make(measured(), levels);
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = 2e5;
  options.bands = 40;
  options.seed = 7;
  options.linear_damping = 1;
  CIdentification found;
  ASSERT_OK(microslip_identify(levels, &options, found.out()));
  levels.destroy();

  IdentificationOptions same;
  same.bands = BandOptions{.samples = 40, .seed = 7};
  same.inversion.linear_damping = true;
  const Identification expected = identify(LevelEvidence(measured()), 2e5, same);
  expect_values(found, MICROSLIP_IDENTIFIED_SLIP_FORCE, expected.slip_force);
  expect_values(found, MICROSLIP_IDENTIFIED_DENSITY, expected.density);
  expect_values(found, MICROSLIP_IDENTIFIED_LOWER, expected.lower);
  expect_values(found, MICROSLIP_IDENTIFIED_UPPER, expected.upper);
  EXPECT_EQ(expected.lower.size(), expected.density.size());
  EXPECT_EQ(number_of(found, MICROSLIP_IDENTIFIED_COVERED_FROM), expected.covered_from);
  EXPECT_EQ(number_of(found, MICROSLIP_IDENTIFIED_COVERED_TO), expected.covered_to);
  EXPECT_EQ(number_of(found, MICROSLIP_IDENTIFIED_LINEAR_DAMPING), expected.linear_damping.value());

  microslip_outcome outcome{};
  outcome.struct_size = sizeof outcome;
  ASSERT_OK(microslip_identification_outcome(found, &outcome));
  EXPECT_EQ(outcome.converged, 1);
  EXPECT_EQ(outcome.method, expected.summary.method);
  EXPECT_EQ(outcome.reason, expected.summary.reason);
  ASSERT_EQ(outcome.warning_count, expected.warnings.size());
  for (std::size_t i = 0; i < outcome.warning_count; ++i) {
    const char* code = nullptr;
    const char* text = nullptr;
    ASSERT_OK(microslip_identification_warning(found, i, &code, &text));
    EXPECT_EQ(code, expected.warnings[i].code);
    EXPECT_EQ(text, expected.warnings[i].text);
  }
  CJoint joint;
  ASSERT_OK(microslip_identification_joint(found, joint.out()));
  found.destroy();
  const double x = 5e-5;
  double force = 0.0;
  ASSERT_OK(microslip_virgin_force(joint, 1, &x, &force));
  EXPECT_EQ(force, expected.joint.virgin_force(x));
}

TEST(CIdentify, DrawsTheSameOnOneThread) {
  CLevels levels;
  make(measured(), levels);
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = 2e5;
  options.bands = 40;
  CIdentification on_all;
  ASSERT_OK(microslip_identify(levels, &options, on_all.out()));
  options.threads = 1;
  CIdentification on_one;
  ASSERT_OK(microslip_identify(levels, &options, on_one.out()));
  const double* upper = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_identification_values(on_one, MICROSLIP_IDENTIFIED_UPPER, &upper, &count));
  expect_values(on_all, MICROSLIP_IDENTIFIED_UPPER, {upper, upper + count});
}

// The caller gives the command; all else is as the program writes it.
TEST(CIdentify, WritesTheJointFileOfTheProgram) {
  const std::string csv = example("brake_reuss_beam/levels.csv");
  LevelsIdentification same;
  same.levels = csv;
  same.stiffness = 1e7;
  same.options.inversion.linear_damping = true;
  const IdentifiedLevels expected = identify_levels(same);

  CLevels levels;
  ASSERT_OK(microslip_levels_read(csv.c_str(), levels.out()));
  std::size_t count = 0;
  ASSERT_OK(microslip_levels_count(levels, &count));
  EXPECT_EQ(count, expected.count);
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = 1e7;
  options.linear_damping = 1;
  options.command = "microslip identify levels.csv";
  CIdentification found;
  ASSERT_OK(microslip_identify(levels, &options, found.out()));
  CJoint joint;
  const char* text = nullptr;
  ASSERT_OK(microslip_identification_joint(found, joint.out()));
  ASSERT_OK(microslip_joint_text(joint, &text));
  EXPECT_EQ(text,
            joint_text(same, expected.found, expected.input, "microslip identify levels.csv"));
}

/// Levels with W_lin.
const std::string kWithLoss = std::string(MICROSLIP_TEST_DATA) + "/reference_rig_levels.csv";

std::string joint_text_of(const microslip_levels* levels,
                          const microslip_identify_options& options) {
  CIdentification found;
  CJoint joint;
  const char* text = "";
  EXPECT_OK(microslip_identify(levels, &options, found.out()));
  EXPECT_OK(microslip_identification_joint(found, joint.out()));
  EXPECT_OK(microslip_joint_text(joint, &text));
  return text;
}

void expect_program_with_loss(double loss_factor_std) {
  LevelsIdentification same;
  same.levels = kWithLoss;
  same.stiffness = 1.7e5;
  same.errors.loss_factor_std = loss_factor_std;
  same.options.bands = BandOptions{.samples = 40};
  const IdentifiedLevels expected = identify_levels(same);

  CLevels levels;
  ASSERT_OK(microslip_levels_read(kWithLoss.c_str(), levels.out()));
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = same.stiffness;
  options.loss_factor_std = loss_factor_std;
  options.bands = 40;
  options.command = "microslip identify";
  EXPECT_EQ(joint_text_of(levels, options),
            joint_text(same, expected.found, expected.input, options.command));
}

TEST(CIdentify, KnowsTheLinearLossOfAFile) { expect_program_with_loss(0.05); }
TEST(CIdentify, IsTheSameWhereNobodyAsksForTheLinearLoss) { expect_program_with_loss(0.0); }

// They are not those of the file any more, whose SHA-256 would be misleading.
TEST(CIdentify, TellsNoFileOfLevelsThatWereChanged) {
  CLevels levels;
  ASSERT_OK(microslip_levels_read(kWithLoss.c_str(), levels.out()));
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = 1.7e5;
  EXPECT_NE(joint_text_of(levels, options).find("reference_rig_levels.csv"), std::string::npos);
  std::size_t count = 0;
  ASSERT_OK(microslip_levels_count(levels, &count));
  const std::vector<double> frequency(count, 50.0);
  const std::vector<double> bad(count, -1.0);
  EXPECT_EQ(microslip_levels_set(levels, MICROSLIP_LEVEL_FREQUENCY, count, bad.data()),
            MICROSLIP_INPUT);
  EXPECT_NE(joint_text_of(levels, options).find("sha256"), std::string::npos) << "not changed";
  ASSERT_OK(microslip_levels_set(levels, MICROSLIP_LEVEL_FREQUENCY, count, frequency.data()));
  const std::string text = joint_text_of(levels, options);
  EXPECT_EQ(text.find("reference_rig_levels.csv"), std::string::npos);
  EXPECT_EQ(text.find("sha256"), std::string::npos);
}

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// The model of examples/two_joints by the functions that make one.
void make(CStructure& structure) {
  CJoint joint;
  CModel model;
  ASSERT_OK(microslip_joint_read(example("two_joints/joint.json").c_str(), joint.out()));
  const std::vector<double> frequency{15.91549430918953, 27.56644477108960};
  const std::vector<double> eta{0.004, 0.004};
  ASSERT_OK(
      microslip_model_create(2, frequency.data(), eta.data(), MICROSLIP_HYSTERETIC, model.out()));
  const double h = 0.7071067811865476;
  const std::vector<double> first{h, h};
  const std::vector<double> second{h, -h};
  const std::vector<double> middle{0.0, 1.414213562373095};
  ASSERT_OK(microslip_model_add_point(model, "first", 2, first.data()));
  ASSERT_OK(microslip_model_add_point(model, "second", 2, second.data()));
  ASSERT_OK(microslip_model_add_joint(model, "wall", joint, 2, first.data(), nullptr));
  ASSERT_OK(microslip_model_add_joint(model, "middle", joint, 2, middle.data(), nullptr));
  ASSERT_OK(microslip_model_add_excitation(model, "first", 1, nullptr, nullptr));
  ASSERT_OK(microslip_structure_create(model, structure.out()));
}

TEST(CStructure, IsTheOneOfTheFile) {
  CStructure made;
  make(made);
  CStructure read;
  ASSERT_OK(microslip_structure_read(example("two_joints/model.toml").c_str(), read.out()));
  const double* of_made = nullptr;
  const double* of_read = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_structure_stuck_frequencies(made, &of_made, &count));
  ASSERT_OK(microslip_structure_stuck_frequencies(read, &of_read, &count));
  // The program also computes ω by 2π and back; the matrices are the same to the bit.
  expect_same(of_made, 2, {of_read, of_read + count});
  std::size_t points = 0;
  std::size_t joints = 0;
  ASSERT_OK(microslip_structure_counts(read, &points, &joints));
  EXPECT_EQ(points, 2U);
  EXPECT_EQ(joints, 2U);
  const char* name = nullptr;
  ASSERT_OK(microslip_structure_point(read, 1, &name));
  EXPECT_STREQ(name, "second");
  ASSERT_OK(microslip_structure_joint(read, 0, &name));
  EXPECT_STREQ(name, "wall");
}

void expect_column(const microslip_curve* curve, microslip_curve_values_of what,
                   const ResponseCurve& expected, double (*value)(const SteadyVibration&)) {
  const double* values = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_curve_values(curve, what, &values, &count));
  ASSERT_EQ(count, expected.points.size());
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(values[i], value(expected.points[i])) << i;
}

TEST(CFrf, IsTheCurveOfTheLibrary) {
  CStructure structure;
  make(structure);
  CCurve curve;
  auto options = defaults(microslip_frf_options_defaults);
  options.harmonics = 3;
  ASSERT_OK(microslip_frf(structure, "second", MICROSLIP_KEEP_FORCE, 2.0, 14.0, 20.0, &options,
                          curve.out()));
  structure.destroy();

  const ModelFile model = read_model(example("two_joints/model.toml"));
  HarmonicBalanceOptions same;
  same.harmonics = 3;
  const HarmonicBalance balance(model.structure, {"second"}, same);
  const ResponseCurve expected = balance.frequency_response(2.0, kTwoPi * 14.0, kTwoPi * 20.0);
  expect_column(curve, MICROSLIP_CURVE_FREQUENCY, expected,
                [](const SteadyVibration& at) { return at.frequency(); });
  expect_column(curve, MICROSLIP_CURVE_FORCE, expected,
                [](const SteadyVibration& at) { return at.force_amplitude; });
  expect_column(curve, MICROSLIP_CURVE_PHASE, expected,
                [](const SteadyVibration& at) { return at.phase_lag; });
  expect_column(curve, MICROSLIP_CURVE_DAMPING_RATIO, expected,
                [](const SteadyVibration& at) { return at.damping_ratio(); });
  expect_column(curve, MICROSLIP_CURVE_DISSIPATION, expected, [](const SteadyVibration& at) {
    return at.joints[0].dissipation + at.joints[1].dissipation;
  });
  const double* amplitude = nullptr;
  const double* displacement = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_curve_values(curve, MICROSLIP_CURVE_DISPLACEMENT, &displacement, &count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto w = expected.points[i].displacement(model.structure.linear(), "second");
    EXPECT_EQ(displacement[i], std::abs(w[1]));
  }
  ASSERT_OK(microslip_curve_joint(curve, 1, MICROSLIP_CURVE_JOINT_AMPLITUDE, &amplitude, &count));
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(amplitude[i], expected.points[i].joints[1].amplitude);
  }
  std::vector<double> re(count);
  std::vector<double> im(count);
  ASSERT_OK(microslip_curve_harmonic(curve, "first", 3, count, re.data(), im.data()));
  for (std::size_t i = 0; i < count; ++i) {
    const auto w = expected.points[i].displacement(model.structure.linear(), "first");
    EXPECT_EQ(std::complex<double>(re[i], im[i]), w[3]);
  }
  const std::size_t* peaks = nullptr;
  ASSERT_OK(microslip_curve_peaks(curve, &peaks, &count));
  EXPECT_EQ((std::vector<std::size_t>{peaks, peaks + count}), expected.peak_points);
  EXPECT_GE(count, 1U);
}

TEST(CFrf, KeepsAResponse) {
  CStructure structure;
  ASSERT_OK(microslip_structure_read(example("one_mass/model.toml").c_str(), structure.out()));
  auto options = defaults(microslip_frf_options_defaults);
  options.response = MICROSLIP_ACCELERATION;
  const double at = 0.15;
  options.at = &at;
  options.at_count = 1;
  CCurve curve;
  ASSERT_OK(microslip_frf(structure, nullptr, MICROSLIP_KEEP_RESPONSE, 0.5, 0.17, 0.14, &options,
                          curve.out()));
  const ModelFile model = read_model(example("one_mass/model.toml"));
  HarmonicBalanceOptions same;
  same.frequencies = {kTwoPi * at};
  const HarmonicBalance balance(model.structure, {"mass", ResponseKind::kAcceleration}, same);
  const ResponseCurve expected = balance.constant_response(0.5, kTwoPi * 0.17, kTwoPi * 0.14);
  expect_column(curve, MICROSLIP_CURVE_FORCE, expected,
                [](const SteadyVibration& at_point) { return at_point.force_amplitude; });
}

TEST(CFrf, HasTheBackboneOfTheLibrary) {
  CStructure structure;
  ASSERT_OK(microslip_structure_read(example("one_mass/model.toml").c_str(), structure.out()));
  const std::vector<double> response{0.1, 0.5, 2.0};
  CCurve curve;
  ASSERT_OK(microslip_backbone(structure, "mass", 0, response.size(), response.data(), nullptr,
                               curve.out()));
  const ModelFile model = read_model(example("one_mass/model.toml"));
  const ResponseCurve expected = HarmonicBalance(model.structure, {"mass"}).resonances(response);
  expect_column(curve, MICROSLIP_CURVE_FREQUENCY, expected,
                [](const SteadyVibration& at) { return at.frequency(); });
  expect_column(curve, MICROSLIP_CURVE_DAMPING_RATIO, expected,
                [](const SteadyVibration& at) { return at.damping_ratio(); });
}

TEST(CFrf, ThatDoesNotConvergeIsThereAllTheSame) {
  CStructure structure;
  ASSERT_OK(microslip_structure_read(example("one_mass/model.toml").c_str(), structure.out()));
  auto options = defaults(microslip_frf_options_defaults);
  options.max_points = 5;
  CCurve curve;
  EXPECT_EQ(
      microslip_frf(structure, nullptr, MICROSLIP_KEEP_FORCE, 0.1, 0.1, 0.2, &options, curve.out()),
      MICROSLIP_NOT_CONVERGED);
  ASSERT_NE(curve, nullptr);
  EXPECT_NE(std::string(microslip_last_error()).find("not converged"), std::string::npos);
  microslip_outcome outcome{};
  outcome.struct_size = sizeof outcome;
  ASSERT_OK(microslip_curve_outcome(curve, &outcome));
  EXPECT_EQ(outcome.converged, 0);
  const double* frequency = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_curve_values(curve, MICROSLIP_CURVE_FREQUENCY, &frequency, &count));
  EXPECT_GE(count, 1U);
}

TEST(CMarch, IsTheMarchOfTheLibrary) {
  CStructure structure;
  ASSERT_OK(microslip_structure_read(example("two_joints/model.toml").c_str(), structure.out()));
  LoadHistory loads;
  std::vector<double> one;
  std::vector<double> other;
  for (int i = 0; i <= 400; ++i) {
    loads.time.push_back(1e-3 * i);
    one.push_back(30.0 * std::sin(100.0 * loads.time.back()));
    other.push_back(5.0 * std::sin(170.0 * loads.time.back()));
  }
  loads.forces = {{"first", one}, {"second", other}};
  auto options = defaults(microslip_march_options_defaults);
  options.every = 3;
  const std::vector<double> velocity{0.01, 0.0};
  options.start_modes = 2;
  options.start_velocity = velocity.data();
  const char* const places[] = {"first", "second"};
  const double* const forces[] = {one.data(), other.data()};
  CMarched marched;
  ASSERT_OK(microslip_march(structure, loads.time.size(), loads.time.data(), 2, places, forces,
                            &options, marched.out()));
  structure.destroy();

  const ModelFile model = read_model(example("two_joints/model.toml"));
  MarchOptions same;
  same.every = 3;
  same.points = {"first", "second"};
  same.start.velocity = velocity;
  const MarchResult expected = march(model.structure, loads, same);
  const double* values = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_marched_time(marched, &values, &count));
  expect_same(values, count, expected.time);
  for (std::size_t p = 0; p < 2; ++p) {
    ASSERT_OK(microslip_marched_point(marched, p, MICROSLIP_DISPLACEMENT, &values, &count));
    expect_same(values, count, expected.points[p].displacement);
    ASSERT_OK(microslip_marched_point(marched, p, MICROSLIP_VELOCITY, &values, &count));
    expect_same(values, count, expected.points[p].velocity);
    ASSERT_OK(microslip_marched_point(marched, p, MICROSLIP_ACCELERATION, &values, &count));
    expect_same(values, count, expected.points[p].acceleration);
    ASSERT_OK(
        microslip_marched_joint(marched, p, MICROSLIP_MARCHED_JOINT_DISPLACEMENT, &values, &count));
    expect_same(values, count, expected.joints[p].displacement);
    ASSERT_OK(microslip_marched_joint(marched, p, MICROSLIP_MARCHED_JOINT_FORCE, &values, &count));
    expect_same(values, count, expected.joints[p].force);
  }
  const auto number = [&](microslip_marched_number what) {
    double value = 0.0;
    EXPECT_OK(microslip_marched_value(marched, what, &value));
    return value;
  };
  EXPECT_EQ(number(MICROSLIP_MARCHED_REACHED), expected.reached);
  EXPECT_EQ(number(MICROSLIP_MARCHED_INITIAL), expected.energy.initial);
  EXPECT_EQ(number(MICROSLIP_MARCHED_INPUT), expected.energy.input);
  EXPECT_EQ(number(MICROSLIP_MARCHED_KINETIC), expected.energy.kinetic);
  EXPECT_EQ(number(MICROSLIP_MARCHED_ELASTIC), expected.energy.elastic);
  EXPECT_EQ(number(MICROSLIP_MARCHED_LINEAR), expected.energy.linear_dissipation);
  EXPECT_EQ(number(MICROSLIP_MARCHED_JOINT_STORED), expected.energy.joint_stored());
  EXPECT_EQ(number(MICROSLIP_MARCHED_JOINT_DISSIPATION), expected.energy.joint_dissipation());
  EXPECT_EQ(number(MICROSLIP_MARCHED_JOINT_LINEAR), expected.energy.joint_linear_dissipation());
  EXPECT_EQ(number(MICROSLIP_MARCHED_IMBALANCE), expected.energy.imbalance());
  EXPECT_EQ(number(MICROSLIP_MARCHED_ERROR), expected.error_estimate.value());
}

TEST(CMarch, ActsAtTheFirstExcitationWithoutAName) {
  CStructure structure;
  ASSERT_OK(microslip_structure_read(example("one_mass/model.toml").c_str(), structure.out()));
  std::vector<double> time;
  std::vector<double> force;
  for (int i = 0; i <= 40; ++i) {
    time.push_back(0.5 * i);
    force.push_back(0.1 * std::sin(0.9 * time.back()));
  }
  const double* const loads[] = {force.data()};
  CMarched marched;
  ASSERT_OK(microslip_march(structure, time.size(), time.data(), 1, nullptr, loads, nullptr,
                            marched.out()));
  const ModelFile model = read_model(example("one_mass/model.toml"));
  MarchOptions same;
  same.points = {"mass"};
  const MarchResult expected = march(model.structure, {time, {{"mass", force}}}, same);
  const double* values = nullptr;
  std::size_t count = 0;
  ASSERT_OK(microslip_marched_point(marched, 0, MICROSLIP_DISPLACEMENT, &values, &count));
  expect_same(values, count, expected.points[0].displacement);
}

}  // namespace
}  // namespace microslip::test::same_bits
