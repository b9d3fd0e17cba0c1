// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_modal_leave_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/gather.hpp"
#include "microslip/workflow/compare/modal_levels_comparison.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

namespace microslip {
namespace {

constexpr double kNotCompared = std::numeric_limits<double>::quiet_NaN();
/// Over the largest amplitude of the others: two calibrations agree no better on amplitudes.
constexpr double kNearlyBeyond = 1.01;

/// Parts that are left out at once, in the order of the levels.
struct ModalPart {
  std::string name;
  std::vector<std::size_t> levels;  ///< their numbers
};

std::vector<ModalPart> modal_parts(const CampaignFile& plan, const CampaignLevels& levels) {
  std::map<std::size_t, ModalPart> parts;
  const std::vector<std::string> names = names_of_levels(plan, levels);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string& test = plan.tests[levels.test[i]].name;
    switch (plan.leave_out) {
      case LeaveOut::kTests:
        parts[levels.test[i]].name = test;
        parts[levels.test[i]].levels.push_back(i);
        break;
      case LeaveOut::kModes:
        parts[levels.mode[i]].name = fmt::format("mode {}", levels.mode[i]);
        parts[levels.mode[i]].levels.push_back(i);
        break;
      case LeaveOut::kLevels:
        parts[i] = {names[i], {i}};
        break;
      case LeaveOut::kNothing:
        break;
    }
  }
  std::vector<ModalPart> all;
  for (auto& [key, part] : parts) all.push_back(std::move(part));
  return all;
}

/// Why nothing is judged by joints of these warnings. A joint that all levels together do not see,
/// either, does nothing to what they predict.
std::string why_not_judged(const std::vector<Warning>& others, const std::vector<Warning>& all) {
  const auto together = std::ranges::find(others, "known_only_together", &Warning::code);
  if (together != others.end()) return together->text;
  const auto unseen = std::ranges::find(others, "joint_not_seen", &Warning::code);
  const auto count = [](const std::vector<Warning>& warnings) {
    return std::ranges::count(warnings, "joint_not_seen", &Warning::code);
  };
  return count(others) > count(all) ? unseen->text : "";
}

/// Standard deviations that were given may be too small, and are never too large.
double counted_scatter(const CalibrationResult& found) {
  return found.loss_std_given ? std::max(1.0, found.loss_scatter) : found.loss_scatter;
}

/// Degrees of freedom of that; 0 where it is as given.
std::size_t freedom_of_scatter(const CalibrationResult& found) {
  if (found.loss_std_given && found.loss_scatter <= 1.0) return 0;
  const auto losses = std::ranges::count_if(
      found.levels, [](const CalibratedLevel& level) { return std::isfinite(level.residual); });
  return static_cast<std::size_t>(std::max(1.0, static_cast<double>(losses) - found.edf));
}

/// One part after the other.
class ModalPartsLeftOut {
 public:
  explicit ModalPartsLeftOut(const ModalLeaveOut& what) : what_(what) {}

  [[nodiscard]] std::vector<LeftOut> found() const {
    const std::vector<ModalPart> parts = modal_parts(what_.plan, what_.levels);
    std::vector<LeftOut> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      try {
        add_part(parts[i], progress_of(i, parts.size()), all);
      } catch (const InputError& error) {
        all.push_back(without_others(parts[i], error.what()));
      }
    }
    return all;
  }

 private:
  /// Joints from the other parts.
  struct Others {
    CalibratedModel done;
    ModelFile model;
    StructureDraws draws;
  };

  /// Of one calibration of some, as a share of all.
  [[nodiscard]] Progress progress_of(std::size_t i, std::size_t parts) const {
    if (!what_.progress) return {};
    return [this, i, parts](std::size_t done, std::size_t total) {
      return what_.progress(i * total + done, parts * total);
    };
  }

  [[nodiscard]] Others found_without(const ModalPart& part, const Progress& progress) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < what_.levels.size(); ++i) {
      if (std::ranges::find(part.levels, i) == part.levels.end()) others.push_back(i);
    }
    CalibratedModel done{.model = what_.done.model, .inputs = what_.done.inputs};
    const ModalLevels left = some_levels(what_.modal, others);
    CalibrationOptions options = what_.calibration.options;
    options.progress = progress;
    options.level_names = names_of_levels(what_.plan, what_.levels, others);
    done.found =
        calibrate(done.model.structure, done.model.to_find, done.model.response, left, options);
    ModelFile model = model_with_found(what_.calibration, done);
    if (what_.plan.leave_out != LeaveOut::kTests) model.spread = {};
    StructureDraws draws =
        draws_of(model.structure, model.spread, samples_of_joints(what_.calibration, done),
                 model.damping_said, draw_options(), "model.toml");
    return {std::move(done), std::move(model), std::move(draws)};
  }

  [[nodiscard]] DrawOptions draw_options() const {
    return {.count = what_.plan.draws, .seed = what_.plan.seed};
  }

  /// Whether a joint moves more at a level than in any of the others.
  [[nodiscard]] bool beyond(const Others& others, std::size_t level) const {
    return std::ranges::any_of(others.done.found.joints, [&](const CalibratedJoint& joint) {
      const JointAtLevel& at = what_.done.found.levels[level].joints[joint.index];
      return at.amplitude > kNearlyBeyond * joint.largest_amplitude;
    });
  }

  /// As the others scatter: a wrong test makes the scatter of all that it is among.
  [[nodiscard]] double noise_of(const Others& others, std::size_t level) const {
    return what_.done.found.levels[level].loss_noise * counted_scatter(others.done.found) /
           counted_scatter(what_.done.found);
  }

  void add_part(const ModalPart& part, const Progress& progress, std::vector<LeftOut>& all) const {
    const Others others = found_without(part, progress);
    std::set<std::size_t> modes;
    for (const std::size_t i : part.levels) modes.insert(what_.levels.mode[i]);
    for (const std::size_t mode : modes) {
      const std::vector<Warning>& warnings = others.done.found.warnings;
      LeftOut left{.name = part.name,
                   .warnings = warnings,
                   .not_judged = why_not_judged(warnings, what_.done.found.warnings)};
      if (modes.size() > 1) left.name += fmt::format(": mode {}", mode);
      for (const std::size_t i : part.levels) {
        const bool known = std::isfinite(what_.levels.levels.dissipation[i]);
        if (what_.levels.mode[i] == mode && known) left.levels.push_back(i);
      }
      std::ranges::stable_sort(left.levels, {},
                               [&](std::size_t i) { return what_.modal.displacement[i]; });
      if (left.levels.empty()) continue;
      predict_mode(others, left);
      all.push_back(std::move(left));
    }
  }

  /// Nothing is compared where the others are too few to find the joints from.
  [[nodiscard]] LeftOut without_others(const ModalPart& part, const std::string& why) const {
    LeftOut left{.name = part.name, .levels = part.levels, .converged = false, .failure = why};
    left.taken.options = draw_options();
    for (const std::size_t i : part.levels) {
      left.measured.push_back(what_.levels.levels.dissipation[i]);
    }
    left.curve = uncompared(part.levels);
    return left;
  }

  void predict_mode(const Others& others, LeftOut& left) const {
    left.converged = others.done.found.summary.converged();
    left.taken.options = draw_options();
    std::vector<std::size_t> within;
    for (const std::size_t i : left.levels) {
      if (!beyond(others, i)) within.push_back(i);
    }
    ComparedCurve curve{.quantity = "dissipation", .dimension = kEnergy};
    if (!within.empty()) {
      ComparedTest test = compared(others, left.name, within);
      left.converged = left.converged && test.failure.empty();
      left.taken = *test.taken;
      curve = std::move(test.curves.front());
    }
    left.curve = uncompared(left.levels);
    left.curve.chance = curve.chance;
    for (std::size_t n = 0, at = 0; at < left.levels.size(); ++at) {
      left.measured.push_back(what_.levels.levels.dissipation[left.levels[at]]);
      left.curve.measured_std.push_back(noise_of(others, left.levels[at]));
      if (n == within.size() || within[n] != left.levels[at]) continue;
      left.curve.measured[at] = curve.measured[n];
      left.curve.predicted[at] = curve.predicted[n];
      left.curve.lower[at] = curve.lower[n];
      left.curve.upper[at] = curve.upper[n];
      ++n;
    }
  }

  /// D alone, by rising displacement.
  [[nodiscard]] ComparedTest compared(const Others& others, const std::string& name,
                                      const std::vector<std::size_t>& within) const {
    ModalLevels question = some_levels(what_.modal, within);
    question = {.mode = question.mode,
                .displacement = question.displacement,
                .displacement_std = question.displacement_std};
    for (const std::size_t i : within) {
      question.dissipation.push_back(what_.levels.levels.dissipation[i]);
      question.dissipation_std.push_back(noise_of(others, i));
    }
    const CalibrationOptions& options = what_.calibration.options;
    return std::move(
        compare_modal_levels(name, question, others.model, options.balance, others.draws,
                             TestDraws{draw_options(), options.execution, {}},
                             options.balance.forcing, freedom_of_scatter(others.done.found))
            .front());
  }

  /// D of levels at their displacements, nothing compared.
  [[nodiscard]] ComparedCurve uncompared(const std::vector<std::size_t>& levels) const {
    const std::vector<double> none(levels.size(), kNotCompared);
    return {.quantity = "dissipation",
            .dimension = kEnergy,
            .axis = "displacement",
            .axis_dimension = kLength,
            .at = gather(what_.modal.displacement, levels),
            .measured = none,
            .predicted = none,
            .lower = none,
            .upper = none};
  }

  const ModalLeaveOut& what_;
};

}  // namespace

std::vector<LeftOut> leave_one_mode_out(const ModalLeaveOut& what) {
  return ModalPartsLeftOut(what).found();
}

}  // namespace microslip
