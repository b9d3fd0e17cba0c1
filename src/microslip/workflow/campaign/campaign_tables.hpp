// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/workflow/campaign/campaign_result.hpp"

/// @file
/// The tables of a campaign. Internal to workflow.

namespace microslip {

// Keys of comments, see comment_entry.hpp.
inline constexpr std::string_view kTitleKey = "title";  ///< of the campaign
inline constexpr std::string_view kWithinSessionsKey = "repeatability_within_sessions";    ///< 1
inline constexpr std::string_view kBetweenSessionsKey = "repeatability_between_sessions";  ///< 1
inline constexpr std::string_view kCommonModesKey = "common_modes";  ///< of a condition: "no"

/// Keys of a trend over a condition and of its standard deviation, 1 per unit of the condition.
struct TrendKeys {
  std::string_view mean;
  std::string_view sigma;
};
inline constexpr TrendKeys kDissipationTrend{"trend_dissipation", "trend_dissipation_std"};
inline constexpr TrendKeys kFrequencyTrend{"trend_frequency", "trend_frequency_std"};

/// campaign.csv: one row per level from which the joint was identified (`part` level), with
/// frequency and dissipation by the joint; and of predicted tests a row a sweep (peak), a value of
/// a mode or cycle of loops (curve), or a record of loops (record), with force_nrmse. Of each
/// quantity QUANTITY, QUANTITY_predicted, _lower, _upper and _verdict, empty where there is none.
/// @param comment  above it.
[[nodiscard]] std::string campaign_table(const DoneCampaign& done, const std::string& comment);

/// sessions.csv, one row per session with levels; the comments repeatability_within_sessions and
/// repeatability_between_sessions are standard deviations of means of ln(D/D̂), 1.
[[nodiscard]] std::string sessions_table(const DoneCampaign& done, const std::string& comment);

/// conditions.csv, one row per value of a condition; comments `trend_dissipation[NAME] = …` and so
/// on give trends, and `common_modes[NAME] = no` conditions whose values have no mode in common.
[[nodiscard]] std::string conditions_table(const DoneCampaign& done, const std::string& comment);

/// leave_one_out.csv, one row per level that was left out.
[[nodiscard]] std::string left_out_table(const DoneCampaign& done, const std::string& comment);

/// "2.1 % from test to test of a session, 3 % from session to session"; empty if neither is known.
[[nodiscard]] std::string repeatability_text(const SessionEffects& effects);

}  // namespace microslip
