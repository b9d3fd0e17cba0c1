// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/rig/cycle_reduction.hpp"
#include "microslip/rig/rig.hpp"
#include "microslip/rig/stick_state.hpp"
#include "microslip/signal/cycle_scatter.hpp"
#include "microslip/signal/fourier_fit.hpp"
#include "microslip/signal/recording.hpp"

/// @file
/// What a record holds, before it becomes a level and its flags. Internal to rig.

namespace microslip {

/// The channels of a record in the order force, accelerometers, vibrometer.
struct RecordSignals {
  std::vector<std::string> names;
  std::vector<std::span<const double>> values;
};

struct RecordAnalysis {
  const Recording& recording;  ///< outlives this
  SignalLayout layout;
  RecordSignals signals;
  FourierFit fit;                 ///< of the signals
  CycleSeries cycles;             ///< of the signals
  CycleResult whole;              ///< of the fit
  std::vector<CycleResult> each;  ///< of each cycle
};

/// @throws InputError  naming the source, as Reducer::reduce().
[[nodiscard]] RecordAnalysis analyse_record(const Recording& recording, const Rig& rig,
                                            const StickState& state,
                                            const FourierFitOptions& options, bool use_vibrometer);

}  // namespace microslip
