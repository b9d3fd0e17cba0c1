// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/workflow/campaign/campaign_result.hpp"

/// @file
/// The tables of a campaign. Internal to workflow.

namespace microslip {

// Keys of comments, see comment_entry.hpp.
inline constexpr std::string_view kRepeatabilityKey = "repeatability";    ///< of sessions.csv
inline constexpr std::string_view kTrendKey = "trend";                    ///< of a condition
inline constexpr std::string_view kNoCommonModesKey = "no_common_modes";  ///< of a condition

/// campaign.csv: one row per level from which the joint was identified (`part` level), with
/// frequency and dissipation by the joint; and of predicted tests a row a sweep (peak), a value of
/// a mode or cycle of loops (curve), or a record of loops (record), with force_nrmse. Of each
/// quantity QUANTITY, QUANTITY_predicted, _lower, _upper and _verdict, empty where there is none.
/// @param comment  above it.
[[nodiscard]] std::string campaign_table(const DoneCampaign& done, const std::string& comment);

/// sessions.csv, one row per session with levels; the comment `repeatability = …` is the standard
/// deviation of the means of the dissipation against that of the joints.
[[nodiscard]] std::string sessions_table(const DoneCampaign& done, const std::string& comment);

/// conditions.csv, one row per value of a condition; comments `trend[NAME] = …` give trends, and
/// `no_common_modes[NAME] = …` conditions whose values have no mode in common.
[[nodiscard]] std::string conditions_table(const DoneCampaign& done, const std::string& comment);

/// leave_one_out.csv, one row per level that was left out.
[[nodiscard]] std::string left_out_table(const DoneCampaign& done, const std::string& comment);

/// "repeats to 2.1 % within a session, 3 % between sessions"; empty if neither is known.
[[nodiscard]] std::string repeatability_text(const SessionEffects& effects);

}  // namespace microslip
