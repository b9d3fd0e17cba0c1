// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/planned_peak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/predict/model_rules.hpp"
#include "microslip/workflow/predict/response_draws.hpp"

namespace microslip {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

std::string joints_in(const ModelFile& model) {
  std::string list;
  for (const StructuralJoint& joint : model.structure.joints()) {
    list += fmt::format("{}'{}'", list.empty() ? "" : ", ", joint.name);
  }
  return list;
}

/// The number of the joint that is measured.
std::size_t joint_of_model(const ModelFile& model, const PlannedPeak& peak) {
  const auto& joints = model.structure.joints();
  const std::string file = input_name(peak.model);
  if (joints.empty()) {
    throw InputError(file + ": joints", "none", "must be one or more",
                     "Levels of a joint do not determine a structure without joints.");
  }
  if (peak.joint.empty() && joints.size() == 1) return 0;
  const auto named = std::ranges::find(joints, peak.joint, &StructuralJoint::name);
  if (named != joints.end()) return static_cast<std::size_t>(named - joints.begin());
  throw InputError("joint", peak.joint.empty() ? "none" : in_quotes(peak.joint),
                   fmt::format("must be one of {}, the joints of {}", joints_in(model), file));
}

void check_planned_joint(const ModelFile& model, std::size_t number, const LevelPlanning& options) {
  constexpr double kApart = 0.1;
  const std::string file = input_name(options.peak.model);
  const double stiffness = model.structure.joints()[number].joint.stiffness();
  if (std::abs(stiffness / options.stiffness - 1.0) > kApart) {
    throw InputError(
        fmt::format("{}: stiffness of '{}'", file, model.structure.joints()[number].name),
        stiffness,
        fmt::format("must be that of the joint of the levels, {:.6g} N/m, within 10 %",
                    options.stiffness),
        "Name the joint that the levels are of, by `joint`.");
  }
  for (const std::size_t other : model.to_find) {
    if (other == number) continue;
    throw InputError(fmt::format("{}: file of '{}'", file, model.structure.joints()[other].name),
                     "missing", "must be given: only the joint of the levels may lack it");
  }
}

std::vector<JointDraws> draws_at(const ModelFile& model, std::size_t number, JointDraws draws) {
  std::vector<JointDraws> all(model.structure.joints().size());
  all[number] = std::move(draws);
  return all;
}

StructureDraws structures(const ModelFile& model, std::size_t number, JointDraws draws) {
  return {model.structure,
          {},
          draws_at(model, number, std::move(draws)),
          JointPairing::kIndependent,
          1};
}

/// Which joint each draw of the structure has: they are taken in an order of their own.
std::vector<std::size_t> order_of(const ModelFile& model, std::size_t number,
                                  std::span<const Joint> joints) {
  std::size_t taken = 0;
  const StructureDraws draws = structures(model, number, {joints.size(), [&](std::size_t i) {
                                                            taken = i;
                                                            return DrawnJoint{joints[i]};
                                                          }});
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    (void)draws.draw(i);
    order.push_back(taken);
  }
  return order;
}

ResponseCurve reference_curve(const HarmonicBalance& balance, const ResponseRange& range,
                              const PlannedPeak& peak) {
  ResponseCurve curve =
      balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to);
  if (!curve.summary.converged()) {
    throw InputError(fmt::format("{}: response", input_name(peak.model)), "not converged",
                     fmt::format("must converge to plan by its peak: {}", curve.summary.reason),
                     "Use another force or frequency range.");
  }
  if (curve.peaks.empty()) {
    throw InputError(fmt::format("{}: peak of the response", input_name(peak.model)), "none",
                     fmt::format("must lie within {:g} to {:g} Hz", peak.from, peak.to),
                     "Widen the range, `frequency`.");
  }
  return curve;
}

}  // namespace

PeakDraws peak_draws(const LevelPlanning& options, const Joint& found,
                     std::span<const Joint> joints) {
  const PlannedPeak& peak = options.peak;
  const ModelFile model = read_model(peak.model, JointsToFind::kAllowed);
  require_driven_by_forces(model, peak.model, "plan");
  const std::size_t number = joint_of_model(model, peak);
  check_planned_joint(model, number, options);
  const StructureDraws nominal =
      structures(model, number, {1, [&](std::size_t) { return DrawnJoint{found}; }});
  const HarmonicBalance balance(nominal.draw(0).structure, {model.response}, {});
  const ResponseRange range{
      {Quantity::kForceAmplitude, peak.force}, kTwoPi * peak.from, kTwoPi * peak.to};
  const ResponseCurve curve = reference_curve(balance, range, peak);
  const StructureDraws draws = structures(
      model, number, {joints.size(), [&](std::size_t i) { return DrawnJoint{joints[i]}; }});
  // The band is not used: any confidence that so few draws allow.
  const ResponseSpread spread =
      response_spread(balance, curve, range, draws, {.count = joints.size(), .confidence = 0.5},
                      Execution::threads(), options.progress);
  const auto highest = static_cast<std::size_t>(
      std::ranges::max_element(spread.peaks, {}, &PeakSpread::height) - spread.peaks.begin());
  PeakDraws result{.frequency = spread.peaks[highest].frequency,
                   .height = spread.peaks[highest].height,
                   .joints = {},
                   .heights = {},
                   .warnings = spread.warnings};
  const std::vector<std::size_t> order = order_of(model, number, joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (std::isnan(spread.peak_height[highest][i])) continue;
    result.joints.push_back(joints[order[i]]);
    result.heights.push_back(spread.peak_height[highest][i]);
  }
  return result;
}

}  // namespace microslip
