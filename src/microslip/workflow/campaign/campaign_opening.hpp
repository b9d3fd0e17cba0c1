// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/workflow/campaign/campaign_run.hpp"

namespace microslip {

/// Reads campaign.toml and the structure, opens the tests, and checks that they go together.
/// @throws FileError, FormatError, InputError  as parse_campaign(); for standard input; where a
///     test or the structure is no file of its kind.
[[nodiscard]] OpenedCampaign open_campaign(const CampaignRun& run);

}  // namespace microslip
