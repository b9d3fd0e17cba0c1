// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/rig/setup/point_sensor.hpp"

namespace microslip {

/// A structure whose joints are to be observed, and its sensors.
struct StructureTest {
  /// With one excitation, whose harmonics do not matter: the force is measured. Of the joints only
  /// stiffness and place are used.
  JointedStructure structure;
  std::string response;  ///< the point of the displacement in the results
  /// The channel of the force; empty: the only one of a force in each record.
  std::string force_channel;
  std::vector<PointSensor> accelerometers;  ///< one at least
};

}  // namespace microslip
