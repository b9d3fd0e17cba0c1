// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/io/output/provenance.hpp"

namespace microslip {

/// Inputs and options of run_campaign().
struct CampaignRun {
  std::string campaign;                        ///< path of campaign.toml
  std::string out;                             ///< folder of the results
  std::string command;                         ///< that the files are made by
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports all draws; may cancel
};

/// A campaign with its files, each of which was opened, recognised and hashed once.
struct OpenedCampaign {
  CampaignFile plan;                    ///< as read
  NamedInput campaign;                  ///< the text of that
  NamedInput structure;                 ///< of rig.toml or model.toml
  std::vector<TestFile> tests = {};     ///< one per test of the plan
  std::optional<ModelFile> model = {};  ///< where the campaign is of one
};

}  // namespace microslip
