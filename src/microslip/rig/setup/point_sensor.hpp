// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// An accelerometer, in the direction in which its point moves.
struct PointSensor {
  std::string channel;  ///< of the records
  std::string point;    ///< of the structure
};

}  // namespace microslip
