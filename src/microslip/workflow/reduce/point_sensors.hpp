// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/rig/setup/point_sensor.hpp"

/// @file
/// Where the channels of recordings are on a structure. Internal to workflow.

namespace microslip {

/// @param texts  CHANNEL=POINT each; where there are none, the sensors of the model.
/// @param path   of the model, for messages.
/// @throws InputError  for another form, a point that the model lacks, and where neither tells any.
[[nodiscard]] std::vector<PointSensor> point_sensors(const std::vector<std::string>& texts,
                                                     const ModelFile& model,
                                                     const std::string& path);

}  // namespace microslip
