// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "demo/demo_folder.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip::app {

/// The pictures of the demonstrated rig, of what its folder holds.
std::vector<DemoPicture> rig_pictures(const ExperimentResults& results);

}  // namespace microslip::app
