// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/rig_responses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr std::size_t kResponses = 5;
constexpr std::size_t kBackbonePoints = 24;
constexpr std::size_t kModes = 7;
constexpr double kMargin = 0.7;        // beyond the resonances, over their range
constexpr double kLeastMargin = 0.01;  // relative to the frequency
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Those of the levels that are next to equal ratios, each once.
std::vector<double> some_responses(std::vector<double> responses) {
  std::ranges::sort(responses);
  std::vector<double> some;
  for (const double wanted : equal_ratios(responses.front(), responses.back(), kResponses)) {
    const auto next = std::ranges::min_element(
        responses, {}, [&](double response) { return std::abs(std::log(response / wanted)); });
    if (some.empty() || some.back() != *next) some.push_back(*next);
  }
  return some;
}

HarmonicBalance balance_of(const Rig& rig, const StickState& state, const Joint& joint,
                           double linear_damping) {
  return {rig_structure(rig, state, joint, {1.0}, linear_damping),
          {rig.excitation.channel, ResponseKind::kAcceleration},
          {.harmonics = 5, .largest_change = 0.06, .least_points = 60, .accuracy = 0.0}};
}

std::optional<JointBackbone> backbone_of(const HarmonicBalance& balance,
                                         const std::vector<double>& responses) {
  const ResponseCurve curve = balance.backbone(responses);
  if (!curve.summary.converged()) return std::nullopt;
  JointBackbone backbone;
  for (const SteadyVibration& point : curve.points) {
    backbone.amplitude.push_back(point.joints.front().amplitude);
    backbone.frequency.push_back(point.frequency());
    const double ratio = point.damping_ratio();
    backbone.damping_ratio.push_back(ratio);
    backbone.vibration_energy.push_back(point.input_energy / (2.0 * kTurn * ratio));
  }
  return backbone;
}

/// From and to, Hz: the resonances of a backbone and what shows their width.
std::pair<double, double> range_around(const JointBackbone& backbone) {
  const auto [lowest, highest] = std::ranges::minmax(backbone.frequency);
  const double margin = std::max(kMargin * (highest - lowest), kLeastMargin * highest);
  return {lowest - margin, highest + margin};
}

/// The force, N, over the frequency, Hz.
std::optional<Curve> curve_of(const HarmonicBalance& balance, double response,
                              std::pair<double, double> range) {
  const ResponseCurve found =
      balance.constant_response(response, kTurn * range.first, kTurn * range.second);
  if (!found.summary.converged()) return std::nullopt;
  Curve curve;
  for (const SteadyVibration& point : found.points) {
    curve.x.push_back(point.frequency());
    curve.y.push_back(point.force_amplitude);
  }
  return curve;
}

}  // namespace

void add_predictions(ExperimentResults& results) {
  if (!results.rig || !results.joint || !results.levels) return;
  const Rig& rig = *results.rig;
  const std::vector<double>& measured = results.levels->response_amplitude;
  if (measured.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax(measured);
  if (!(lowest > 0.0 && highest > lowest)) return;
  const std::vector<double> responses = equal_ratios(lowest, highest, kBackbonePoints);
  const StickState state = stick_state(rig, kModes);
  const HarmonicBalance found =
      balance_of(rig, state, results.joint->joint, results.joint->linear_damping.value_or(0.0));
  std::optional<HarmonicBalance> truth;
  if (results.truth) truth = balance_of(rig, state, *results.truth, results.true_linear_damping);

  results.backbone = backbone_of(found, responses);
  if (!results.backbone) return;
  if (truth) results.true_backbone = backbone_of(*truth, responses);
  const std::pair<double, double> range = range_around(*results.backbone);
  for (const double response : some_responses(measured)) {
    std::optional<Curve> curve = curve_of(found, response, range);
    if (!curve) continue;
    ConstantResponse one{response, std::move(curve->x), std::move(curve->y)};
    if (std::optional<Curve> expected = truth ? curve_of(*truth, response, range) : std::nullopt) {
      one.true_frequency = std::move(expected->x);
      one.true_force = std::move(expected->y);
    }
    results.responses.push_back(std::move(one));
  }
}

}  // namespace microslip
