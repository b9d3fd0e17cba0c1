// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/modal_offsets.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/campaign_joints.hpp"
#include "microslip/workflow/campaign_modal_leave_out.hpp"
#include "microslip/workflow/campaign_modal_levels.hpp"
#include "microslip/workflow/campaign_plan.hpp"

namespace microslip {
namespace {

constexpr const char* kModalLevelsName = "modal_levels.csv";

FrequencyUse use_of(FrequencyOfLevels frequency) {
  switch (frequency) {
    case FrequencyOfLevels::kChange:
      return FrequencyUse::kChange;
    case FrequencyOfLevels::kAbsolute:
      return FrequencyUse::kAbsolute;
    case FrequencyOfLevels::kIgnore:
      break;
  }
  return FrequencyUse::kIgnore;
}

ModelCalibration calibration_of(const CampaignRun& run, const CampaignFile& plan) {
  ModelCalibration calibration{.model = plan.structure,
                               .levels = {},
                               .out = run.out,
                               .keep_draws = plan.draws > 0,
                               .command = run.command};
  for (const CampaignTest& test : plan.tests) {
    if (test.identifies()) calibration.levels.push_back(test.file);
  }
  CalibrationOptions& options = calibration.options;
  options.frequency = use_of(plan.frequency);
  options.fit_stiffness = plan.fit_stiffness;
  options.edges = plan.edges;
  options.balance.forcing = plan.modal_forcing ? Forcing::kModal : Forcing::kExcitation;
  options.balance.harmonics = plan.harmonics;
  if (plan.draws > 0) options.draws = plan.draws;
  options.seed = plan.seed;
  options.execution = run.execution;
  return calibration;
}

/// What was found at each level.
template <typename Read>
std::vector<double> of_levels(const CalibrationResult& found, const Read& read) {
  std::vector<double> values;
  for (const CalibratedLevel& level : found.levels) {
    values.push_back(level.found ? read(level) : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

/// Any number of joints, from levels of modes.
class ModelJoints : public CampaignJoints {
 public:
  ModelJoints(const CampaignRun& run, const CampaignFile& plan, CampaignComment comment)
      : run_(run),
        plan_(plan),
        comment_(std::move(comment)),
        calibration_(calibration_of(run, plan)),
        done_{.model = read_model_to_calibrate(plan.structure), .inputs = comment_.inputs} {}

  void identify(const Progress& progress, DoneCampaign& all) override {
    CampaignModalLevels tests =
        campaign_modal_levels(plan_, done_.model, run_.out, run_.command, {});
    ModelCalibration options = calibration_;
    options.options.progress = progress;
    options.options.level_names = names_of_levels(plan_, tests.levels);
    require_modes_to_leave_out(tests.levels);
    calibrate_levels(options, tests.modal, kModalLevelsName, done_);
    const CalibrationResult& found = done_.found;
    tests.levels.levels.dissipation = measured_losses(found);
    all.levels = std::move(tests.levels);
    modal_ = std::move(tests.modal);
    all.sessions = session_effects(
        plan_, all.levels,
        {.frequency = of_levels(found, [](const CalibratedLevel& at) { return at.frequency; }),
         .dissipation = of_levels(found, [](const CalibratedLevel& at) { return at.dissipation; }),
         .damping_over_found = damping_over_found()});
    if (!modal_.damping_ratio.empty()) {
      all.found.measured_damping_ratio = modal_.damping_ratio;
      all.found.damping_ratio =
          of_levels(found, [](const CalibratedLevel& at) { return at.damping_ratio; });
    }
    (found.loss_std_given ? all.found.deviation_scatter : all.found.loss_scatter) =
        found.loss_scatter;
    all.found.converged = found.summary.converged();
    CalibratedModel told = done_;  // whose warnings are among those of all
    told.found.warnings.clear();
    all.found.summary = describe_calibration(calibration_, told);
    std::ranges::copy(all.levels.warnings, std::back_inserter(all.warnings));
    std::ranges::copy(found.warnings, std::back_inserter(all.warnings));
  }

  [[nodiscard]] std::vector<LeftOut> leave_out(const DoneCampaign& all,
                                               const Progress& progress) const override {
    return leave_one_mode_out({.plan = plan_,
                               .calibration = calibration_,
                               .done = done_,
                               .levels = all.levels,
                               .modal = modal_,
                               .progress = progress});
  }

  [[nodiscard]] ModelFile model(std::vector<Warning>& warnings) const override {
    (void)warnings;  // those of the model are among those of the levels
    return model_with_found(calibration_, done_);
  }

  [[nodiscard]] SessionModes modes_in(const std::string& session, const ModelFile& model,
                                      const DoneCampaign& all,
                                      const std::vector<double>& scatter) const override {
    SessionModes modes{.offset = std::vector<double>(scatter.size(), 0.0), .deviation = scatter};
    if (!plan_.session_offsets) return modes;
    const auto [others, others_std] = all.sessions.offset_of_others(session);
    const std::vector<StructureOffset> told = told_offsets(session, model, all);
    const ModalOffsets found = modal_offsets(model.structure, told, others);
    modes.offset = found.offset;
    const JointedStructure moved = with_modal_offsets(model.structure, found.offset);
    std::vector<double> deviation;  // of each that is told
    for (const StructureOffset& one : told) {
      const double own = all.sessions.told_offset(session, one.mode + 1)->second;
      deviation.push_back(std::hypot(
          own, scatter[one.mode], change_over_levels(session, one, model.structure, moved, all)));
    }
    for (std::size_t i = 0; i < scatter.size(); ++i) {
      double variance = found.left[i] * (others_std * others_std + scatter[i] * scatter[i]);
      for (std::size_t m = 0; m < told.size(); ++m) {
        variance += std::pow(found.by_told[i][m] * deviation[m], 2);
      }
      modes.deviation[i] = std::sqrt(variance);
    }
    return modes;
  }

  [[nodiscard]] std::vector<std::optional<JointSamples>> samples() const override {
    return samples_of_joints(calibration_, done_);
  }

  [[nodiscard]] std::vector<ResultFile> files(const DoneCampaign& all) override {
    done_.found.warnings = all.warnings;
    compose_calibration(calibration_, modal_, done_);
    std::vector<ResultFile> files = done_.files;
    std::erase_if(files, [](const ResultFile& file) { return file.kind == kModelKind; });
    files.push_back({in_folder(run_, kModalLevelsName), kModalLevelsKind,
                     pooled_modal_levels_text({modal_, all.levels}, plan_,
                                              offsets_of_levels(all.sessions, plan_, all.levels),
                                              with_warnings(comment_.text, all.warnings))});
    return files;
  }

 private:
  /// ζ/ζ̂ of levels whose losses are told by it, and by nothing else.
  [[nodiscard]] std::vector<double> damping_over_found() const {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < modal_.damping_ratio.size(); ++i) {
      const CalibratedLevel& level = done_.found.levels[i];
      const bool other = std::isfinite(ModalLevels::value(modal_.dissipation, i));
      const double ratio = modal_.damping_ratio[i] / level.damping_ratio;
      ratios.push_back(other || !level.found || !(ratio > 0.0)
                           ? std::numeric_limits<double>::quiet_NaN()
                           : ratio);
    }
    return ratios;
  }

  void require_modes_to_leave_out(const CampaignLevels& levels) const {
    const std::set<std::size_t> modes(levels.mode.begin(), levels.mode.end());
    if (plan_.leave_out != LeaveOut::kModes || modes.size() > 1) return;
    throw InputError("identification.leave_one_out", "\"modes\"",
                     "leaves nothing: all levels to identify from are of one mode",
                     "\"tests\" and \"levels\" leave out less.");
  }

  /// Offsets of vibrations that the levels of a session tell, by the joints at these.
  [[nodiscard]] std::vector<StructureOffset> told_offsets(const std::string& session,
                                                          const ModelFile& model,
                                                          const DoneCampaign& all) const {
    constexpr double kLeastShare = 0.1;
    std::vector<StructureOffset> offsets;
    for (std::size_t mode = 0; mode < model.structure.linear().vibrations(); ++mode) {
      const auto told = all.sessions.told_offset(session, mode + 1);
      if (!told) continue;
      StructureOffset one{
          .mode = mode,
          .offset = told->first,
          .joint_stiffness = mean_stiffness(session, mode + 1, model.structure, all)};
      const double share = share_of_modes(model.structure, one);
      if (share >= kLeastShare) {
        offsets.push_back(std::move(one));
      } else if (told->first != 0.0) {
        throw InputError(
            fmt::format("session_offsets: session {}, mode {}", session, mode + 1),
            fmt::format("{:.2g} % of its stiffness without the joints", 100.0 * share),
            "must have 10 % or more: an offset is one of the structure, and not of its joints",
            "Leave session_offsets out, or predict no test of this session.");
      }
    }
    return offsets;
  }

  /// Secant stiffness of each joint, N/m, at each level of a mode in a session that tells a
  /// frequency.
  [[nodiscard]] std::vector<std::vector<double>> stiffness_at_levels(
      const std::string& session, std::size_t mode, const JointedStructure& structure,
      const DoneCampaign& all) const {
    std::vector<std::vector<double>> stiffness;
    for (std::size_t i = 0; i < all.levels.size(); ++i) {
      const CalibratedLevel& level = done_.found.levels[i];
      const bool own = plan_.tests[all.levels.test[i]].session == session;
      if (!own || all.levels.mode[i] != mode || !level.found) continue;
      if (!std::isfinite(level.measured_frequency)) continue;
      std::vector<double>& of_level = stiffness.emplace_back();
      for (std::size_t j = 0; j < structure.joints().size(); ++j) {
        of_level.push_back(
            secant_stiffness(structure.joints()[j].joint, level.joints[j].amplitude));
      }
    }
    return stiffness;
  }

  /// The mean of that, one a joint.
  [[nodiscard]] std::vector<double> mean_stiffness(const std::string& session, std::size_t mode,
                                                   const JointedStructure& structure,
                                                   const DoneCampaign& all) const {
    const auto at_levels = stiffness_at_levels(session, mode, structure, all);
    std::vector<double> means(structure.joints().size(), 0.0);
    for (const std::vector<double>& of_level : at_levels) {
      for (std::size_t j = 0; j < means.size(); ++j) {
        means[j] += of_level[j] / static_cast<double>(at_levels.size());
      }
    }
    return means;
  }

  /// An offset of the structure is less at levels where its joints are stiff, and one of all its
  /// stiffness is not: by this they differ, rms over the levels, 1. Which it is nobody knows.
  [[nodiscard]] double change_over_levels(const std::string& session, const StructureOffset& told,
                                          const JointedStructure& before,
                                          const JointedStructure& after,
                                          const DoneCampaign& all) const {
    const auto frequency = [&](const JointedStructure& structure,
                               const std::vector<double>& stiffness) {
      std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
      for (std::size_t j = 0; j < joints.size(); ++j) joints[j].joint = Joint(stiffness[j], {});
      return structure.with_joints(std::move(joints)).stuck_frequencies()[told.mode];
    };
    double squares = 0.0;
    const auto at_levels = stiffness_at_levels(session, told.mode + 1, before, all);
    for (const std::vector<double>& stiffness : at_levels) {
      const double there = std::log(frequency(after, stiffness) / frequency(before, stiffness));
      squares += std::pow(there - told.offset, 2);
    }
    return std::sqrt(squares / static_cast<double>(at_levels.size()));
  }

  const CampaignRun& run_;
  const CampaignFile& plan_;
  CampaignComment comment_;
  ModelCalibration calibration_;
  CalibratedModel done_;
  ModalLevels modal_;
};

}  // namespace

std::vector<ResultFile> planned_files_of_model(const CampaignRun& run, const CampaignFile& plan) {
  std::vector<ResultFile> files = planned_files(calibration_of(run, plan));
  std::erase_if(files, [](const ResultFile& file) { return file.kind == kModelKind; });
  files.push_back({in_folder(run, kModalLevelsName), kModalLevelsKind});
  return files;
}

std::unique_ptr<CampaignJoints> joints_of_model(const CampaignRun& run, const CampaignFile& plan,
                                                CampaignComment comment) {
  return std::make_unique<ModelJoints>(run, plan, std::move(comment));
}

}  // namespace microslip
