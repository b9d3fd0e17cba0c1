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
/// Effects of the conditions of tests, a torque or an order of amplitudes.

namespace microslip {

/// Effect of each condition of tests with levels, those that do not specify it left out.
///
/// σ of a mean is the larger of √(s²/n + g²/t), s² = Σ(r − r̄)²/(N − G) over the N levels of all G
/// groups, n of them in the group, and √(s_t²/t), s_t² as s² for the means of the tests, t of
/// them in the group, where a group has two tests: tests repeat worse than levels within them. Of D
/// g² is σ_e² + (pσ_c)² by the uncertainties of the gains of D and A in the campaign, p the
/// mean of d ln D̂/d ln A over the group; of y it is 0. Frequencies are not used where offsets of
/// sessions are fitted and no session has two values: the effect of the condition is then part of
/// these.
///
/// Of a model whose frequencies count by their change, the nominal frequency of a mode is not used:
/// y of each is less the mean over the groups of their means of y in that mode, and modes that not
/// all groups have levels of are left out. Where there is none that all have, the effect of a
/// condition and the error of a mode cannot be distinguished (common_modes).
[[nodiscard]] std::vector<ConditionEffect> condition_effects(const CampaignFile& campaign,
                                                             const CampaignLevels& levels,
                                                             const SessionEffects& effects);

/// Comparison of the groups of a condition.
struct ConditionVerdict {
  /// "D at 25 differs by +3.1 ± 0.4 % from that at 20, more than three standard deviations; …": the
  /// groups that differ most in D and in the frequency; empty for a single group.
  std::string text = {};
  bool differ = false;  ///< by more than three standard deviations
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

/// "D +0.62 ± 0.03 %, frequency -0.01 ± 0.002 % per Nm of torque"; empty without a trend.
[[nodiscard]] std::string trend_text(const ConditionEffect& effect);

}  // namespace microslip
