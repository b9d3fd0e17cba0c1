// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"

/// @file
/// Levels of a campaign that are far off the others. Internal to workflow.

namespace microslip {

/// Of more than three warnings `level_outlier` of one test the first becomes one that counts them,
/// with their numbers and by how much they are off, and the others go: a wrong test is one finding.
/// @param plan         whose tests the levels are of.
/// @param levels       that the joints were identified from, with D as measured.
/// @param dissipation  D of the joints at each, J.
/// @param outliers     the level of each of the warnings `level_outlier`, from 0.
/// @param warnings     of the identification.
[[nodiscard]] std::vector<Warning> with_outliers_by_test(const CampaignFile& plan,
                                                         const CampaignLevels& levels,
                                                         const std::vector<double>& dissipation,
                                                         const std::vector<std::size_t>& outliers,
                                                         std::vector<Warning> warnings);

}  // namespace microslip
