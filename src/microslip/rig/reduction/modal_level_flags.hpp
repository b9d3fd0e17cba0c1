// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/rig/reduction/fitted_record.hpp"
#include "microslip/rig/reduction/modal_level.hpp"
#include "microslip/rig/reduction/modal_reduction_options.hpp"
#include "microslip/rig/setup/joints_observer.hpp"
#include "microslip/rig/setup/structure_test.hpp"

/// @file
/// Flags of a modal level. Internal to rig.

namespace microslip {

/// A reduced record, as the flags need it.
struct ModalRecord {
  const FittedRecord& record;
  const JointsObserver& observer;
  const std::vector<double>& misfit;  ///< one per accelerometer
  bool resonance_found;
  const StructureTest& test;
  const ModalReductionOptions& options;
  double stuck_frequency;  ///< of the mode of the level with stuck joints, Hz
};

/// Adds the flags that ModalReducer documents to a level whose values are set.
void add_flags(ModalLevel& level, const ModalRecord& record);

}  // namespace microslip
