// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/workflow/campaign/campaign_run.hpp"
#include "microslip/workflow/identify/calibration.hpp"

/// @file
/// Plan of a campaign.toml: the tests and the structure that it names, and the files that
/// come of it. Internal to workflow.

namespace microslip {

/// The sessions, but for the first with levels, whose predicted tests have a model of their own.
[[nodiscard]] std::vector<std::string> sessions_with_model(const CampaignFile& plan);

/// The name of that.
[[nodiscard]] std::string model_name(const std::string& session);

/// The path of a file in the folder of the results.
[[nodiscard]] std::string in_folder(const CampaignRun& run, const std::string& name);

/// The paths and kinds of all files of the results.
[[nodiscard]] std::vector<ResultFile> files_of(const CampaignRun& run,
                                               const OpenedCampaign& opened);

}  // namespace microslip
