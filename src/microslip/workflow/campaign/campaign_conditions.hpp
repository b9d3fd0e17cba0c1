// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/workflow/campaign/campaign_effects.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"
#include "microslip/workflow/campaign/campaign_sessions.hpp"

/// @file
/// What the conditions of tests, a torque or an order of amplitudes, differ by.

namespace microslip {

/// Of each condition of tests with levels, those that do not say it left out.
///
/// σ of a mean is the larger of √(s²/n + g²/t), s² = Σ(r − r̄)²/(N − G) over the N levels of all G
/// groups, n of them in the group, and √(s_t²/t), s_t² likewise of the means of the tests, t of
/// them in the group, where a group has two tests: tests repeat worse than levels within them. Of D
/// g² is σ_e² + (pσ_c)² by the gains of D and A that the campaign says its tests may have, p the
/// mean of d ln D̂/d ln A over the group; of y it is 0. Frequencies say nothing where offsets of
/// sessions are fitted and no session has two values: what the condition does is then part of
/// these.
///
/// Of a model whose frequencies count by their change, the nominal frequency of a mode tells
/// nothing: y of each is less the mean over the groups of their means of y in that mode, and modes
/// that not all groups have levels of are left out. Where there is none that all have, what a
/// condition does and what is wrong with a mode cannot be told apart (common_modes).
[[nodiscard]] std::vector<ConditionEffect> condition_effects(const CampaignFile& campaign,
                                                             const CampaignLevels& levels,
                                                             const SessionEffects& effects);

/// What the groups of a condition say of each other.
struct ConditionVerdict {
  /// "D of 25 is +3.1 ± 0.4 % off that of 20, more than three standard deviations; …": the groups
  /// that differ most, of D and of the frequency; empty of a single group.
  std::string text = {};
  bool differ = false;  ///< by more than three standard deviations: they are not alike
};

/// Looks at the means of the groups and their σ, and at whether amplitudes overlap.
[[nodiscard]] ConditionVerdict condition_verdict(const ConditionEffect& effect);

/// Whether the amplitudes of any two groups overlap.
[[nodiscard]] bool amplitudes_overlap(const std::vector<ConditionGroup>& groups);

/// Warnings: `conditions_pooled` for tests of different values that are identified together, with
/// what they differ by; `condition_not_identified` for a predicted test of a value that none of the
/// tests to identify from has.
[[nodiscard]] std::vector<Warning> condition_warnings(const CampaignFile& campaign,
                                                      const std::vector<ConditionEffect>& effects);

/// What conditions.csv tells of a condition without common modes.
[[nodiscard]] std::string no_common_modes_text(const std::string& condition);

/// "D +0.62 ± 0.03 %, frequency -0.01 ± 0.002 % per unit of torque_Nm"; empty without a trend.
[[nodiscard]] std::string trend_text(const ConditionEffect& effect);

}  // namespace microslip
