// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/tests_verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/identified_joint.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/workflow/compare/comparison_options.hpp"
#include "microslip/workflow/compare/loops_comparison.hpp"
#include "microslip/workflow/compare/modal_levels_comparison.hpp"
#include "microslip/workflow/compare/sweep_comparison.hpp"
#include "microslip/workflow/predict/model_rules.hpp"
#include "microslip/workflow/reduce/recordings_provenance.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

std::vector<ComparedTest> compare_each(const std::vector<SteppedSine>& sweeps,
                                       std::optional<TestKind> kind, const ModelFile& model,
                                       const HarmonicBalanceOptions& balance,
                                       const std::optional<StructureDraws>& spread,
                                       const std::optional<TestDraws>& draws) {
  std::vector<ComparedTest> tests;
  for (const SteppedSine& sweep : sweeps) {
    tests.push_back(
        compare_sweep(sweep, kind ? *kind : kind_of(sweep), model, balance, spread, draws));
  }
  return tests;
}

LoopJoint loop_joint(const StructuralJoint& joint) { return {joint.joint, joint.linear_damping}; }

std::vector<ComparedTest> compare_records(const std::vector<NamedForceRecord>& records,
                                          const ModelFile& model, std::size_t j,
                                          const std::optional<StructureDraws>& spread,
                                          const std::optional<TestDraws>& draws) {
  LoopJoint joint = loop_joint(model.structure.joints()[j]);
  if (j < model.covered_to.size()) joint.covered_to = model.covered_to[j];
  std::function<LoopJoint(std::size_t)> draw;
  if (spread) {
    draw = [&, j](std::size_t i) { return loop_joint(spread->draw(i).structure.joints()[j]); };
  }
  std::vector<ComparedTest> tests;
  for (const NamedForceRecord& record : records) {
    tests.push_back(compare_loops(record, joint, draw, draws));
  }
  return tests;
}

std::size_t joint_of_records(const ModelFile& model, const std::string& name) {
  const auto joints = model.structure.joints();
  if (name.empty() && joints.size() == 1) return 0;
  const auto found = std::ranges::find(joints, name, &StructuralJoint::name);
  if (found != joints.end()) return static_cast<std::size_t>(found - joints.begin());
  std::vector<std::string> names;
  for (const StructuralJoint& joint : joints) names.push_back(joint.name);
  throw InputError(
      "`joint`", in_quotes(name),
      fmt::format("must be one of the joints of the model: {}", fmt::join(names, ", ")),
      "Records of force and displacement are of one joint.");
}

}  // namespace

std::vector<ComparedTest> compare_test(const ReadTest& test, const ModelFile& model,
                                       const HarmonicBalanceOptions& balance,
                                       const std::optional<StructureDraws>& spread,
                                       const std::optional<TestDraws>& draws,
                                       const std::string& joint, Forcing forcing) {
  if (const auto* sweeps = std::get_if<std::vector<SteppedSine>>(&test.content)) {
    return compare_each(*sweeps, test.kind, model, balance, spread, draws);
  }
  if (const auto* levels = std::get_if<ModalLevels>(&test.content)) {
    std::vector<ComparedTest> tests =
        compare_modal_levels(input_name(test.path), *levels, model, balance, spread, draws,
                             test.is_recording ? Forcing::kModal : forcing);
    if (test.is_recording || test.kind == TestKind::kRingDown) {
      for (ComparedTest& one : tests) one.kind = TestKind::kRingDown;
    }
    return tests;
  }
  return compare_records(std::get<std::vector<NamedForceRecord>>(test.content), model,
                         joint_of_records(model, joint), spread, draws);
}

void add_joint_warnings(const std::string& path, const JointFile& file,
                        std::vector<Warning>& warnings) {
  const IdentifiedJoint joint = identified_joint_of(file, path);
  std::vector<std::string> broken;
  const auto add_broken = [&](const std::vector<DepartureFound>& verdicts) {
    for (const DepartureFound& one : verdicts) {
      std::string departure = departure_with_code(one.departure);
      if (one.broken && std::ranges::count(broken, departure) == 0) {
        broken.push_back(std::move(departure));
      }
    }
  };
  add_broken(joint.verdicts);
  if (joint.by_records) {
    for (const RecordFound& record : joint.by_records->records) add_broken(record.verdicts);
  }
  if (!broken.empty()) {
    warnings.push_back(
        {"joint_not_of_this_kind",
         fmt::format("{} was identified as NOT A MASING JOINT: {}. It is the closest such joint.",
                     path, fmt::join(broken, "; "))});
  }
  if (joint.status != kStatusNotTold && joint.status != kConvergedStatus) {
    warnings.push_back({"joint_not_converged",
                        fmt::format("the identification of {} is {}.", path, joint.status)});
  }
}

namespace {

/// Predicts tests by a model.toml.
class ModelPrediction {
 public:
  ModelPrediction(const TestsVerification& options, const NamedInput& input)
      : options_(options), model_(parse_model(input.text, input_name(input.path))) {
    if (options.harmonics) balance_.harmonics = *options.harmonics;
    if (options.draws) draws_ = draws_of(model_, options.model, *options.draws);
    for (const std::string& path : model_.joint_files) {
      if (!path.empty()) add_joint_warnings(path, read_joint(path), warnings_);
    }
  }

  [[nodiscard]] const ModelFile& model() const { return model_; }
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }
  [[nodiscard]] std::string uncertain() const { return draws_ ? uncertain_text(model_) : ""; }

  [[nodiscard]] std::vector<ComparedTest> compare(const ReadTest& test,
                                                  const std::optional<TestDraws>& draws) const {
    if (std::holds_alternative<std::vector<SteppedSine>>(test.content)) {
      require_driven_by_forces(model_, options_.model, "verify");
    }
    return compare_test(test, model_, balance_, draws_, draws, options_.joint);
  }

 private:
  const TestsVerification& options_;
  HarmonicBalanceOptions balance_;
  ModelFile model_;
  std::optional<StructureDraws> draws_;
  std::vector<Warning> warnings_;
};

/// Predicts records of a joint by its joint.json.
class JointPrediction {
 public:
  JointPrediction(const TestsVerification& options, const NamedInput& input)
      : file_(parse_joint(input.text, input_name(input.path))),
        joint_{file_.joint, 0.0, identified_viscous(file_), covered_to(file_)} {
    if (joint_.viscous == 0.0) joint_.linear_damping = identified_damping(file_).value_or(0.0);
    if (options.draws) draws_ = draws_of(file_, options.uncertain, *options.draws);
    add_joint_warnings(input_name(input.path), file_, warnings_);
    if (!draws_ || joint_.viscous == 0.0) return;
    warnings_.push_back(
        {"viscous_not_drawn", fmt::format("all draws have the viscous part of {}, {:.4g} N s/m: "
                                          "the bands do not include its uncertainty.",
                                          input_name(input.path), joint_.viscous)});
  }

  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }
  [[nodiscard]] std::string uncertain() const { return draws_ ? draws_->uncertain : ""; }

  [[nodiscard]] std::vector<ComparedTest> compare(const ReadTest& test,
                                                  const std::optional<TestDraws>& draws) const {
    std::function<LoopJoint(std::size_t)> draw;
    if (draws_) {
      draw = [&](std::size_t i) {
        DrawnJoint drawn = draws_->joint.draw({&file_.joint, 1}, i).front();
        return LoopJoint{std::move(drawn.joint),
                         drawn.linear_damping.value_or(joint_.linear_damping), joint_.viscous};
      };
    }
    std::vector<ComparedTest> tests;
    for (const NamedForceRecord& record : std::get<std::vector<NamedForceRecord>>(test.content)) {
      tests.push_back(compare_loops(record, joint_, draw, draws));
    }
    return tests;
  }

 private:
  JointFile file_;
  LoopJoint joint_;
  std::optional<LoneJointDraws> draws_;
  std::vector<Warning> warnings_;
};

/// Draws of test t, counted in those of all.
std::optional<TestDraws> draws_of_test(const TestsVerification& options, std::size_t t,
                                       std::size_t count) {
  if (!options.draws) return std::nullopt;
  TestDraws draws{.options = *options.draws, .execution = options.execution};
  if (options.progress) {
    draws.progress = [&options, t, count](std::size_t done, std::size_t all) {
      return options.progress(t * all + done, count * all);
    };
  }
  return draws;
}

/// Copies of one file, which distinct names do not show.
std::vector<Warning> copies_in(const std::vector<ReadTest>& read) {
  std::vector<InputHash> files;
  for (const ReadTest& test : read) files.push_back({test.path, test.digest});
  return same_content_warnings(files, "the test");
}

template <typename Prediction>
void compare_all(const Prediction& prediction, const std::vector<ReadTest>& read,
                 const TestsVerification& options, VerifiedTests& verified) {
  for (std::size_t t = 0; t < read.size(); ++t) {
    std::vector<ComparedTest> tests =
        prediction.compare(read[t], draws_of_test(options, t, read.size()));
    std::ranges::move(tests, std::back_inserter(verified.tests));
    std::ranges::copy(read[t].warnings, std::back_inserter(verified.warnings));
    verified.followed = verified.followed && read[t].converged;
  }
  std::ranges::copy(prediction.warnings(), std::back_inserter(verified.warnings));
  verified.uncertain = prediction.uncertain();
}

}  // namespace

bool VerifiedTests::converged() const {
  return followed &&
         std::ranges::all_of(tests, [](const ComparedTest& test) { return test.converged(); });
}

VerifiedTests verify_tests(const TestsVerification& options, const std::string& command) {
  check_distinct_files(options.tests);
  const NamedInput input{options.model, read_text(options.model)};
  std::vector<ReadTest> read;
  VerifiedTests verified;
  const auto read_all = [&](const ModelFile* model) {
    for (const std::string& path : options.tests) {
      read.push_back(read_test(path, model, options.model, options.reading));
    }
    check_test_options(options, read);
    std::ranges::move(copies_in(read), std::back_inserter(verified.warnings));
  };
  const bool alone = file_kind(input.text) == kJointKind;
  check_predictor_options(options, alone);
  if (alone) {
    const JointPrediction prediction(options, input);
    read_all(nullptr);
    compare_all(prediction, read, options, verified);
  } else {
    const ModelPrediction prediction(options, input);
    read_all(&prediction.model());
    compare_all(prediction, read, options, verified);
  }
  std::vector<std::string> digests;
  for (const ReadTest& test : read) digests.push_back(test.digest);
  verified.heading = recordings_provenance(command, input, options.tests, digests);
  return verified;
}

}  // namespace microslip
