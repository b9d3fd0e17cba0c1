// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/results/comparison_results.hpp"

/// @file
/// The tables of verify and of campaign as results. Internal to workflow.

namespace microslip {

/// comparison.csv with its comments. @throws FormatError  where a column is missing, or a cell
/// wrong.
[[nodiscard]] ComparisonFound comparison_of(const NamedInput& input);

/// campaign.csv: rows, and title and warnings of its comments. @throws FormatError  as above.
void add_campaign_table(const NamedInput& input, CampaignFound& found);

/// sessions.csv. @throws FormatError  as above.
void add_sessions(const NamedInput& input, CampaignFound& found);

/// conditions.csv with the trends of its comments. @throws FormatError  as above.
void add_conditions(const NamedInput& input, CampaignFound& found);

/// leave_one_out.csv. @throws FormatError  as above.
void add_left_out(const NamedInput& input, CampaignFound& found);

}  // namespace microslip
