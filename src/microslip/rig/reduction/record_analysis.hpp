// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/rig/reduction/cycle_reduction.hpp"
#include "microslip/rig/reduction/fitted_record.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Analysis of a record of a rig, before its level and flags. Internal to rig.

namespace microslip {

/// The signals are the force, the accelerometers and, where the layout has it, the vibrometer.
struct RecordAnalysis : FittedRecord {
  SignalLayout layout;
  CycleResult whole;              ///< of the fit
  std::vector<CycleResult> each;  ///< of each cycle
};

/// @throws InputError  naming the source, as Reducer::reduce().
[[nodiscard]] RecordAnalysis analyse_record(const Recording& recording, const Rig& rig,
                                            const StickState& state,
                                            const FourierFitOptions& options, bool use_vibrometer);

}  // namespace microslip
