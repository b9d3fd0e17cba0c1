// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/workflow/campaign/campaign_result.hpp"

/// @file
/// The tables of a campaign. Internal to workflow.

namespace microslip {

/// campaign.csv: a row a level that the joint was identified from (`part` level), with frequency
/// and dissipation by the joint; and of predicted tests a row a sweep (peak), a value of a mode or
/// cycle of loops (curve), or a record of loops (record), with force_nrmse. Of each quantity
/// QUANTITY, QUANTITY_predicted, _lower, _upper and _verdict, empty where there is none.
/// @param comment  above it.
[[nodiscard]] std::string campaign_table(const DoneCampaign& done, const std::string& comment);

/// sessions.csv, a row a session with levels; comments tell of repeatability.
[[nodiscard]] std::string sessions_table(const DoneCampaign& done, const std::string& comment);

/// conditions.csv, a row a value of a condition; comments tell of trends.
[[nodiscard]] std::string conditions_table(const DoneCampaign& done, const std::string& comment);

/// leave_one_out.csv, a row a level that was left out.
[[nodiscard]] std::string left_out_table(const DoneCampaign& done, const std::string& comment);

/// "repeats to 2.1 % within a session, 3 % between sessions"; empty where nothing tells.
[[nodiscard]] std::string repeatability_text(const SessionEffects& effects);

}  // namespace microslip
