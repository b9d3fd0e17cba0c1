// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "demo_folder.hpp"
#include "microslip/identify/identification.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/rig/reduction_batch.hpp"
#include "microslip/rig/verification.hpp"
#include "microslip/rig/verification_batch.hpp"
#include "microslip/rig/virtual_measurement.hpp"

namespace microslip::app {

/// The whole chain on a rig whose joint is known.
struct RigDemonstration {
  Rig rig;
  Joint truth;
  VirtualMeasurement test;
  Reducer reducer;
  ReductionBatch reduction;
  Identification found;
  Verifier verifier;  ///< with the joint found
  VerificationBatch verification;

  [[nodiscard]] bool converged() const;
};

/// Virtual test of the reference rig, its records reduced, the joint identified from the levels,
/// the records predicted by it; results and pictures go into the folder.
/// @throws Cancelled     as the progress bars say.
/// @throws NothingFound  where the virtual test does not converge.
RigDemonstration demonstrate_rig(DemoFolder& folder);

}  // namespace microslip::app
