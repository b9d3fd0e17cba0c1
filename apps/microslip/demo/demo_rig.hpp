// SPDX-License-Identifier: MIT
#pragma once

#include "demo/demo_folder.hpp"
#include "microslip/workflow/measure/rig_demonstration.hpp"

namespace microslip::app {

/// Virtual test of the reference rig, its records reduced, the joint identified from the levels,
/// the records predicted by it; results and pictures go into the folder.
/// @throws Cancelled     as the progress bars say.
/// @throws NothingFound  where the virtual test does not converge.
RigDemonstration demonstrate_rig(DemoFolder& folder);

}  // namespace microslip::app
