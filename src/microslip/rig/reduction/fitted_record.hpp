// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/signal/harmonic/cycle_scatter.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// The Fourier series of the channels of a steady record. Internal to rig.

namespace microslip {

/// Channels of a record, in the order of the request.
struct RecordSignals {
  std::vector<std::string> names;
  std::vector<std::span<const double>> values;

  /// @throws InputError  as Recording::signal().
  void add(const Recording& recording, const std::string& name, const Dimension& dimension);
};

struct FittedRecord {
  const Recording& recording;  ///< outlives this
  RecordSignals signals;
  FourierFit fit;      ///< of the signals
  CycleSeries cycles;  ///< of the signals
};

/// @param signals  of this recording, which check_recording() has passed.
/// @throws InputError  naming the source, where no steady vibration is in it and why, or a channel
///                     does not vibrate.
[[nodiscard]] FittedRecord fit_record(const Recording& recording, RecordSignals signals,
                                      const FourierFitOptions& options);

}  // namespace microslip
