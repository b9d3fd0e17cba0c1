// SPDX-License-Identifier: MIT
#include "microslip/calibrate/vibration_change.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

double relative_change(double before, double after) {
  if (before == after) return 0.0;
  return before > 0.0 ? std::abs(after / before - 1.0) : 1.0;
}

/// Σ_j |dD_j/da_j Δa_j| of a joint, or of all that are sought.
double loss_change(const LevelRow& row, const LevelVibration& before, const LevelVibration& after,
                   const LevelStates& states, const std::vector<std::size_t>& sought) {
  double change = 0.0;
  for (std::size_t j = 0; j < sought.size(); ++j) {
    if (row.joint != LevelRow::kAllJoints && row.joint != sought[j]) continue;
    const Joint& joint = states.structure().joints()[sought[j]].joint;
    change += std::abs(dissipation_slope(joint, after.amplitude[j]) *
                       (after.amplitude[j] - before.amplitude[j]));
  }
  return change;
}

double amplitude_change(const LevelRow& row, const LevelVibration& before,
                        const LevelVibration& after, const std::vector<std::size_t>& sought) {
  const auto joint =
      static_cast<std::size_t>(std::ranges::find(sought, row.joint) - sought.begin());
  return joint < sought.size() ? std::abs(after.amplitude[joint] - before.amplitude[joint]) : 0.0;
}

}  // namespace

std::vector<LevelVibration> vibrations_of(const LevelStates& states, std::size_t levels,
                                          const std::vector<std::size_t>& sought) {
  std::vector<LevelVibration> all(levels);
  for (std::size_t level = 0; level < levels; ++level) {
    const bool found = states.at(level).has_value();
    if (found) all[level].angular_frequency = states.at(level)->angular_frequency;
    for (const std::size_t joint : sought) {
      all[level].amplitude.push_back(found ? states.amplitude(level, joint) : 0.0);
    }
  }
  return all;
}

double largest_change(const std::vector<LevelVibration>& before,
                      const std::vector<LevelVibration>& after) {
  double change = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    change =
        std::max(change, relative_change(before[i].angular_frequency, after[i].angular_frequency));
    for (std::size_t j = 0; j < before[i].amplitude.size(); ++j) {
      change = std::max(change, relative_change(before[i].amplitude[j], after[i].amplitude[j]));
    }
  }
  return change;
}

double change_over_deviations(const std::vector<LevelVibration>& before,
                              const std::vector<LevelVibration>& after,
                              const LinearisedLevels& linear, const EvidenceWeights& weights,
                              const LevelStates& states, const std::vector<std::size_t>& sought) {
  double most = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool lost = (before[i].angular_frequency > 0.0) != (after[i].angular_frequency > 0.0);
    if (lost) most = std::max(most, 1.0);
  }
  const auto count = [&](const std::vector<LevelRow>& rows, RowKind kind, const auto& change_of) {
    for (const LevelRow& row : rows) {
      const double change = change_of(row, before[row.level], after[row.level]);
      most = std::max(most, change / (row.deviation * weights.of(kind)));
    }
  };
  using Vibration = LevelVibration;
  count(linear.losses, RowKind::kLoss,
        [&](const LevelRow& row, const Vibration& from, const Vibration& to) {
          return loss_change(row, from, to, states, sought);
        });
  count(linear.frequencies, RowKind::kFrequency,
        [](const LevelRow&, const Vibration& from, const Vibration& to) {
          return relative_change(from.angular_frequency, to.angular_frequency);
        });
  count(linear.sensors, RowKind::kAmplitude,
        [&](const LevelRow& row, const Vibration& from, const Vibration& to) {
          return amplitude_change(row, from, to, sought);
        });
  return most;
}

}  // namespace microslip
