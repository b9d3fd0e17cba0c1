// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/modal_offsets.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/campaign_joints.hpp"
#include "microslip/workflow/campaign_modal_leave_out.hpp"
#include "microslip/workflow/campaign_modal_levels.hpp"

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
    calibrate_levels(options, tests.modal, kModalLevelsName, done_);
    const CalibrationResult& found = done_.found;
    tests.levels.levels.dissipation = measured_losses(found);
    all.levels = std::move(tests.levels);
    modal_ = std::move(tests.modal);
    all.sessions = session_effects(
        plan_, all.levels,
        {.frequency = of_levels(found, [](const CalibratedLevel& at) { return at.frequency; }),
         .dissipation =
             of_levels(found, [](const CalibratedLevel& at) { return at.dissipation; })});
    if (!modal_.damping_ratio.empty()) {
      all.found.measured_damping_ratio = modal_.damping_ratio;
      all.found.damping_ratio =
          of_levels(found, [](const CalibratedLevel& at) { return at.damping_ratio; });
    }
    if (!found.loss_std_given) all.found.loss_scatter = found.loss_scatter;
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
    for (std::size_t i = 0; i < scatter.size(); ++i) {
      double variance = found.left[i] * (others_std * others_std + scatter[i] * scatter[i]);
      for (std::size_t m = 0; m < told.size(); ++m) {
        const double own = all.sessions.told_offset(session, told[m].mode + 1)->second;
        variance += std::pow(found.by_told[i][m] * std::hypot(own, scatter[told[m].mode]), 2);
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
  /// Offsets of vibrations that the levels of a session tell, by the joints at these.
  [[nodiscard]] std::vector<StructureOffset> told_offsets(const std::string& session,
                                                          const ModelFile& model,
                                                          const DoneCampaign& all) const {
    constexpr double kLeastShare = 0.1;
    std::vector<StructureOffset> offsets;
    for (std::size_t mode = 0; mode < model.structure.linear().vibrations(); ++mode) {
      const auto told = all.sessions.told_offset(session, mode + 1);
      if (!told) continue;
      StructureOffset one{.mode = mode,
                          .offset = told->first,
                          .joint_stiffness = mean_stiffness(session, mode + 1, model, all)};
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

  /// Of each joint, N/m: the mean of its secant stiffness over the levels of a mode in a session.
  [[nodiscard]] std::vector<double> mean_stiffness(const std::string& session, std::size_t mode,
                                                   const ModelFile& model,
                                                   const DoneCampaign& all) const {
    std::vector<double> means;
    for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t i = 0; i < all.levels.size(); ++i) {
        const CalibratedLevel& level = done_.found.levels[i];
        const bool own = plan_.tests[all.levels.test[i]].session == session;
        if (!own || all.levels.mode[i] != mode || !level.found) continue;
        if (!std::isfinite(level.measured_frequency)) continue;
        sum += secant_stiffness(model.structure.joints()[j].joint, level.joints[j].amplitude);
        count += 1.0;
      }
      means.push_back(sum / count);
    }
    return means;
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
