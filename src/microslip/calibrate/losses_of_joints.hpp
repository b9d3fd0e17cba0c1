// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/calibrate/calibration_result.hpp"

/// @file
/// What draws of the losses of several joints show of each and of their sums. Internal to
/// calibrate.

namespace microslip {

/// Finds pairs of joints, and joints among three or more, whose individual losses are not
/// determined, and the loss of each joint over its standard deviation.
/// @param losses  [level][joint][draw], J.
/// @param result  whose joints and levels are known; gets `pairs`, `known_in_sum` and
///                `loss_significance` of its joints.
void read_losses(const std::vector<std::vector<std::vector<double>>>& losses,
                 CalibrationResult& result);

}  // namespace microslip
