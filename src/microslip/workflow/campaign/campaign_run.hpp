// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"

namespace microslip {

/// What is asked for.
struct CampaignRun {
  std::string campaign;                        ///< path of campaign.toml
  std::string out;                             ///< folder of the results
  std::string command;                         ///< that the files are made by
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< told of all draws; may cancel
};

}  // namespace microslip
