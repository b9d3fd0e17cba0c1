// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"
#include "microslip/workflow/campaign/campaign_plan.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/compare/tests_verification.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"
#include "microslip/workflow/predict/rig_model.hpp"
#include "microslip/workflow/reduce/level_table.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

constexpr const char* kLevelsName = "levels.csv";
constexpr const char* kJointName = "joint.json";
constexpr const char* kSamplesName = "joint_samples.h5";

LevelsIdentification identification_of(const CampaignRun& run, const CampaignFile& plan) {
  LevelsIdentification all;
  all.stiffness = plan.stiffness;
  all.use_inner_reversals = plan.use_inner_reversals;
  all.texts.smoothing = plan.smoothing;
  all.errors = {.dissipation_gain_std = plan.dissipation_gain_std,
                .amplitude_gain_std = plan.amplitude_gain_std};
  all.options.inversion.linear_damping = plan.linear_damping;
  all.options.inversion.edges = plan.edges;
  all.options.inversion.atom = plan.atom;
  set_smoothing(plan.smoothing, std::nullopt, all.options);
  if (plan.draws == 0) return all;
  all.texts.samples_out = kSamplesName;
  BandOptions bands;
  bands.samples = plan.draws;
  bands.seed = plan.seed;
  bands.execution = run.execution;
  all.options.bands = bands;
  return all;
}

/// One joint, from its levels.
class RigJoint : public CampaignJoints {
 public:
  RigJoint(const CampaignRun& run, const OpenedCampaign& opened, CampaignComment comment)
      : run_(run),
        opened_(opened),
        plan_(opened.plan),
        comment_(std::move(comment)),
        rig_(opened.structure),
        identification_(identification_of(run, opened.plan)),
        state_(of_rig(rig_, [&] { return stick_state(parse_rig(rig_), kModesOfCampaign); })) {}

  void identify(const Progress& progress, DoneCampaign& all) override {
    all.levels = campaign_levels(opened_, run_.out, run_.command, {});
    check_leave_out(plan_, all.levels);
    const SessionEffects first = effects_by_first_joint(all.levels);
    identified_ = identify_pooled(all.levels, first, progress);
    const Identification& found = identified_->found;
    all.sessions = effects_by(all.levels, found);
    joint_ = joint_of(found);
    if (!all.levels.levels.secant_stiffness.empty()) {
      for (const double a : all.levels.levels.amplitude) {
        all.found.secant_stiffness.push_back(secant_stiffness(found.joint, a));
      }
    }
    all.found.converged = found.summary.converged();
    // Its warnings are among those of all.
    all.found.summary = describe_identification(found, identified_->count, {});
    std::ranges::copy(all.levels.warnings, std::back_inserter(all.warnings));
    std::ranges::copy(found.warnings, std::back_inserter(all.warnings));
    add_joint_warnings(kJointName, joint_, all.warnings);
  }

  [[nodiscard]] std::vector<LeftOut> leave_out(const DoneCampaign& all,
                                               const Progress& progress) const override {
    return leave_one_out(plan_, all.levels,
                         {.stiffness = plan_.stiffness,
                          .identification = identification_.options,
                          .errors = identification_.errors,
                          .execution = run_.execution,
                          .progress = progress});
  }

  [[nodiscard]] ModelFile model(const DoneCampaign& /*all*/,
                                std::vector<Warning>& warnings) const override {
    RigModel model = model_of_rig(rig_, joint_, kJointName, kModesOfCampaign);
    std::ranges::copy(model.warnings, std::back_inserter(warnings));
    if (plan_.draws > 0) {
      model.file.joint_samples = {kSamplesName};
      model.file.damping_said = {false};
    }
    return std::move(model.file);
  }

  /// The offset of its first mode is taken for that of all.
  [[nodiscard]] SessionModes modes_in(const std::string& session, const ModelFile& model,
                                      const DoneCampaign& all,
                                      const std::vector<double>& scatter) const override {
    const auto [offset, deviation] = all.sessions.offset_of(session, 1);
    SessionModes modes{.offset = std::vector<double>(model.structure.linear().size(), offset),
                       .deviation = {}};
    for (const double own : scatter) modes.deviation.push_back(std::hypot(own, deviation));
    return modes;
  }

  [[nodiscard]] std::vector<std::optional<JointSamples>> samples() const override {
    return {joint_samples(identified_->found, *joint_.provenance)};
  }

  [[nodiscard]] std::vector<ResultFile> files(const DoneCampaign& all) override {
    // Warnings on the tests together belong to the joint, in addition to those on its levels.
    Identification found = identified_->found;
    found.warnings = all.warnings;
    std::vector<ResultFile> files = planned_files_of_rig(run_, plan_);
    files[0].content = identified_->input.text;
    files[1].content = format_joint(joint_of(found));
    if (plan_.draws == 0) return files;
    files[2].content = samples_bytes(identification_, identified_->found, identified_->input,
                                     run_.command, in_folder(run_, kSamplesName));
    return files;
  }

 private:
  [[nodiscard]] JointFile joint_of(const Identification& found) const {
    return identified_joint(identification_, found, {identified_->input}, run_.command);
  }

  [[nodiscard]] SessionEffects effects_by(const CampaignLevels& levels,
                                          const Identification& found) const {
    return session_effects(plan_, levels, state_, found.joint, found.linear_damping.value_or(0.0));
  }

  /// Frequencies are not data of the joint, but appear in its warnings: offsets are subtracted
  /// before.
  [[nodiscard]] SessionEffects effects_by_first_joint(const CampaignLevels& levels) const {
    LevelsIdentification first = identification_;
    first.options.bands.reset();
    first.errors = {};
    const std::vector<double> none(levels.size(), 0.0);
    return effects_by(levels, identify_table(pooled(levels, none), first).found);
  }

  [[nodiscard]] LevelTable pooled(const CampaignLevels& levels,
                                  const std::vector<double>& offsets) const {
    // Those with inner reversals are left out already where they are to be.
    return level_table_of(
        {in_folder(run_, kLevelsName),
         pooled_levels_text(levels, plan_, offsets, with_warnings(comment_.text, levels.warnings))},
        {.use_inner_reversals = true, .assemblies = AssemblyColumn::kIgnored});
  }

  [[nodiscard]] IdentifiedLevels identify_pooled(const CampaignLevels& levels,
                                                 const SessionEffects& effects,
                                                 const Progress& progress) const {
    LevelsIdentification options = identification_;
    if (options.options.bands) options.options.bands->progress = progress;
    return identify_table(pooled(levels, offsets_of_levels(effects, plan_, levels)), options);
  }

  const CampaignRun& run_;
  const OpenedCampaign& opened_;
  const CampaignFile& plan_;
  CampaignComment comment_;
  const NamedInput& rig_;
  LevelsIdentification identification_;
  StickState state_;
  std::optional<IdentifiedLevels> identified_;
  JointFile joint_{Joint(1.0, {}), {}, {}};
};

}  // namespace

std::vector<ResultFile> planned_files_of_rig(const CampaignRun& run, const CampaignFile& plan) {
  std::vector<ResultFile> files{{in_folder(run, kLevelsName), kLevelsKind},
                                {in_folder(run, kJointName), kJointKind}};
  if (plan.draws > 0) files.push_back({in_folder(run, kSamplesName), kSamplesKind});
  return files;
}

std::unique_ptr<CampaignJoints> joints_of_rig(const CampaignRun& run, const OpenedCampaign& opened,
                                              CampaignComment comment) {
  return std::make_unique<RigJoint>(run, opened, std::move(comment));
}

}  // namespace microslip
