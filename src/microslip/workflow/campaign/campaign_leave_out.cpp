// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_leave_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/gather.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"

namespace microslip {
namespace {

/// Of the gains of what was left out, apart from the noise of compare().
constexpr std::uint64_t kGainStreams = std::uint64_t{0x200} << 48U;

/// Tests, or levels, by name and the numbers of their levels.
std::vector<LeftOut> parts_of(const CampaignFile& campaign, const CampaignLevels& levels) {
  std::vector<LeftOut> parts;
  std::size_t first = 0;  // level of the test
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string& test = campaign.tests[levels.test[i]].name;
    const bool same = i > 0 && levels.test[i] == levels.test[i - 1];
    first = same ? first : i;
    if (campaign.leave_out == LeaveOut::kLevels) {
      parts.push_back({.name = fmt::format("{}: level {}", test, i - first + 1)});
    } else if (!same) {
      parts.push_back({.name = test});
    }
    parts.back().levels.push_back(i);
  }
  return parts;
}

std::vector<std::size_t> others_than(const LeftOut& part, std::size_t count) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::ranges::find(part.levels, i) == part.levels.end()) others.push_back(i);
  }
  return others;
}

Identification identified_without(const LeftOut& part, const Levels& others,
                                  const LeaveOutOptions& options) {
  try {
    return identify(LevelEvidence(others, options.errors), options.stiffness,
                    options.identification);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("leave_one_out without '{}': {}", part.name, error.name()));
  }
}

std::vector<double> losses(const Joint& joint, double linear_damping,
                           const std::vector<double>& amplitude, double amplitude_gain,
                           double loss_gain) {
  std::vector<double> all;
  for (const double reading : amplitude) {
    const double a = reading / amplitude_gain;
    all.push_back(loss_gain * (dissipation(joint, a) + linear_damping * a * a));
  }
  return all;
}

/// σ of D of each level that was left out, as a reading of what the others predict. Standard
/// deviations that were given say nothing of a test that is wrong: where the others scatter by
/// more, it is they that count.
std::vector<double> noise_of(const LeftOut& part, const CampaignLevels& all,
                             const Identification& found) {
  const LevelEvidence levels(all.levels);
  const double damping = found.linear_damping.value_or(0.0);
  const InversionResult& inversion = *found.inversion();
  const double scatter = inversion.scatter_is_relative
                             ? inversion.dissipation_scatter
                             : std::max(1.0, inversion.dissipation_scatter);
  const LevelRows noise = levels.measured_deviations(
      {levels.predict(found.joint, damping), levels.amplitude_change(found.joint, damping)},
      {.dissipation = scatter});
  return gather(noise.dissipation, part.levels);
}

/// The levels that were left out as a test.
ComparedTest question_of(const LeftOut& part, const CampaignLevels& all, double highest,
                         std::vector<double> noise) {
  const Levels left = some_levels(all.levels, part.levels);
  ComparedCurve curve{.quantity = "dissipation",
                      .dimension = kEnergy,
                      .axis = "amplitude",
                      .axis_dimension = kLength,
                      .at = left.amplitude,
                      .measured_std = std::move(noise)};
  for (std::size_t i = 0; i < left.size(); ++i) {
    const bool beyond = left.amplitude[i] > highest;
    curve.measured.push_back(beyond ? std::numeric_limits<double>::quiet_NaN()
                                    : left.dissipation[i]);
  }
  return {.source = part.name, .kind = TestKind::kRingDown, .curves = {std::move(curve)}};
}

void predict(const CampaignLevels& all, const LeaveOutOptions& options, LeftOut& part) {
  const Levels others = some_levels(all.levels, others_than(part, all.size()));
  const Identification found = identified_without(part, others, options);
  part.converged = found.summary.converged();
  const BandOptions& bands = *options.identification.bands;
  Provenance provenance;
  provenance.seed = bands.seed;
  const JointSamples samples = joint_samples(found, provenance);
  const std::vector<double> amplitude = some_levels(all.levels, part.levels).amplitude;
  TestPredictor predictor;
  predictor.nominal.values =
      losses(found.joint, found.linear_damping.value_or(0.0), amplitude, 1.0, 1.0);
  predictor.draw = [&](std::size_t i) {
    RandomStream random(bands.seed, kGainStreams + i);
    const double loss_gain = std::exp(options.errors.dissipation_gain_std * random.normal());
    const double amplitude_gain = std::exp(options.errors.amplitude_gain_std * random.normal());
    return TestPrediction{losses(samples.joint(i),
                                 samples.linear_damping.empty() ? 0.0 : samples.linear_damping[i],
                                 amplitude, amplitude_gain, loss_gain)};
  };
  ComparedTest test =
      question_of(part, all, std::ranges::max(others.amplitude), noise_of(part, all, found));
  compare(predictor,
          TestDraws{.options = {.count = samples.size(), .seed = bands.seed},
                    .execution = options.execution},
          test);
  part.measured = some_levels(all.levels, part.levels).dissipation;
  part.curve = std::move(test.curves.front());
  part.taken = *test.taken;
}

}  // namespace

double LeftOut::mean_deviation() const {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!curve.compares(i) || !(curve.predicted[i] > 0.0)) continue;
    const double sigma = i < curve.measured_std.size() ? curve.measured_std[i] : 0.0;
    const double weight = sigma > 0.0 ? std::pow(curve.predicted[i] / sigma, 2) : 1.0;
    sum += weight * curve.measured[i] / curve.predicted[i];
    weights += weight;
  }
  return std::log(sum / weights);  // NaN of none
}

bool LeftOut::contradicts() const {
  // Two draws are what an edge lies between.
  const double taken_draws = static_cast<double>(taken.options.count - taken.failed());
  return not_judged.empty() && curve.compared() > 0 && curve.inside() < curve.compared() &&
         curve.chance <= 1.0 - taken.options.confidence + 2.0 / taken_draws;
}

double LeftOut::deviation(std::size_t i) const {
  if (!curve.compares(i)) return std::numeric_limits<double>::quiet_NaN();
  const double difference = curve.measured[i] - curve.predicted[i];
  const double edge = difference > 0.0 ? curve.upper[i] : curve.lower[i];
  return difference / std::abs(edge - curve.predicted[i]);
}

void check_leave_out(const CampaignFile& campaign, const CampaignLevels& levels) {
  if (campaign.leave_out == LeaveOut::kNothing) return;
  if (LevelEvidence(levels.levels).size() < kFewestLevels) return;  // which identify() says
  for (const LeftOut& part : parts_of(campaign, levels)) {
    const LevelEvidence others(some_levels(levels.levels, others_than(part, levels.size())));
    if (others.size() >= kFewestLevels) continue;
    throw InputError("identification.leave_one_out",
                     campaign.leave_out == LeaveOut::kTests ? "'tests'" : "'levels'",
                     fmt::format("leaves too few: without '{}' there are {} different amplitudes, "
                                 "and a density needs {} or more",
                                 part.name, others.size(), kFewestLevels),
                     campaign.leave_out == LeaveOut::kTests
                         ? "Leave out levels, \"levels\", or nothing, or measure more of them."
                         : "Leave it out, or measure more levels.");
  }
}

std::vector<LeftOut> leave_one_out(const CampaignFile& campaign, const CampaignLevels& levels,
                                   const LeaveOutOptions& options) {
  std::vector<LeftOut> parts = parts_of(campaign, levels);
  LeaveOutOptions one = options;
  if (campaign.leave_out == LeaveOut::kLevels) one.errors = {};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (options.progress && !options.progress(i, parts.size())) throw Cancelled();
    predict(levels, one, parts[i]);
  }
  return parts;
}

}  // namespace microslip
