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
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"
#include "microslip/workflow/campaign/campaign_modal_leave_out.hpp"
#include "microslip/workflow/campaign/campaign_modal_levels.hpp"
#include "microslip/workflow/campaign/campaign_plan.hpp"
#include "microslip/workflow/campaign/campaign_session_modes.hpp"

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
  options.correct_modes =
      false;  // offsets are those of sessions, and predictions of the model given
  options.balance.forcing = plan.modal_forcing ? Forcing::kModal : Forcing::kExcitation;
  options.balance.harmonics = plan.harmonics;
  if (plan.draws > 0) options.draws = plan.draws;
  options.seed = plan.seed;
  options.execution = run.execution;
  return calibration;
}

/// Results at each level.
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
  ModelJoints(const CampaignRun& run, const OpenedCampaign& opened, CampaignComment comment)
      : run_(run),
        opened_(opened),
        plan_(opened.plan),
        comment_(std::move(comment)),
        calibration_(calibration_of(run, opened.plan)),
        done_{.model = *opened.model, .inputs = comment_.inputs} {}

  void identify(const Progress& progress, DoneCampaign& all) override {
    CampaignModalLevels tests = campaign_modal_levels(opened_, run_.out, run_.command, {});
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
    CalibratedModel described = done_;  // whose warnings are among those of all
    described.found.warnings.clear();
    all.found.summary = describe_calibration(calibration_, described);
    std::ranges::copy(all.levels.warnings, std::back_inserter(all.warnings));
    std::ranges::copy(found.warnings, std::back_inserter(all.warnings));
    all.outliers = found.outliers;
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

  [[nodiscard]] ModelFile model(const DoneCampaign& all,
                                std::vector<Warning>& warnings) const override {
    ModelFile found = model_with_found(calibration_, done_);
    if (plan_.session_offsets) {
      std::ranges::copy(
          StructureSessions(plan_, found.structure, done_.found, all).warnings_of_change(),
          std::back_inserter(warnings));
    }
    return found;
  }

  [[nodiscard]] SessionModes modes_in(const std::string& session, const ModelFile& model,
                                      const DoneCampaign& all,
                                      const std::vector<double>& scatter) const override {
    if (!plan_.session_offsets) {
      return {.offset = std::vector<double>(scatter.size(), 0.0), .deviation = scatter};
    }
    return StructureSessions(plan_, model.structure, done_.found, all).modes_in(session, scatter);
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
  /// ζ/ζ̂ of levels whose losses are given only by it.
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

  const CampaignRun& run_;
  const OpenedCampaign& opened_;
  const CampaignFile& plan_;
  CampaignComment comment_;
  ModelCalibration calibration_;
  CalibratedModel done_;
  ModalLevels modal_;
};

}  // namespace

std::vector<ResultFile> planned_files_of_model(const CampaignRun& run,
                                               const OpenedCampaign& opened) {
  std::vector<ResultFile> files = planned_files(calibration_of(run, opened.plan), *opened.model);
  std::erase_if(files, [](const ResultFile& file) { return file.kind == kModelKind; });
  files.push_back({in_folder(run, kModalLevelsName), kModalLevelsKind});
  return files;
}

std::unique_ptr<CampaignJoints> joints_of_model(const CampaignRun& run,
                                                const OpenedCampaign& opened,
                                                CampaignComment comment) {
  return std::make_unique<ModelJoints>(run, opened, std::move(comment));
}

}  // namespace microslip
