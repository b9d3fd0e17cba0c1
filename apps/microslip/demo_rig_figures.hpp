// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "demo_rig.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip::app {

/// The pictures of the chain, from the test to the prediction, beside the truth.
/// @param name    of the folder in that of the demonstration.
/// @param levels  that the joint was identified by.
void draw_rig(DemoFolder& folder, const std::string& name, const RigDemonstration& done,
              const Levels& levels);

}  // namespace microslip::app
