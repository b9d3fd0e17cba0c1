// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/fitted_record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// The fit's own complaints know no file.
FourierFit fit_named(const Recording& recording, const RecordSignals& signals,
                     const FourierFitOptions& options) {
  try {
    return fit_fourier(recording.axis, signals.values, options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", recording.source, error.name()));
  }
}

FourierFit fit_of(const Recording& recording, const RecordSignals& signals,
                  const FourierFitOptions& options) {
  FourierFit fit = fit_named(recording, signals, options);
  if (!fit.summary.converged()) {
    throw InputError(recording.source, "no steady vibration",
                     fmt::format("must contain periodic signals: {}", fit.summary.reason),
                     options.frequency_guess
                         ? "Check the frequency, or leave it out to have it found."
                         : "Cut the record to its steady part, or state the frequency.");
  }
  for (std::size_t j = 0; j < signals.names.size(); ++j) {
    if (std::abs(fit.series[j].c(1)) > 0.0) continue;
    throw InputError(fmt::format("{}: channel '{}'", recording.source, signals.names[j]),
                     "constant", "must vibrate", "Is the sensor connected?");
  }
  return fit;
}

}  // namespace

void RecordSignals::add(const Recording& recording, const std::string& name,
                        const Dimension& dimension) {
  values.push_back(recording.signal(name, dimension));
  names.push_back(name);
}

FittedRecord fit_record(const Recording& recording, RecordSignals signals,
                        const FourierFitOptions& options) {
  FourierFit fit = fit_of(recording, signals, options);
  CycleSeries cycles =
      cycle_series(recording.axis, signals.values, fit, {.order = static_cast<int>(fit.order())});
  return {recording, std::move(signals), std::move(fit), std::move(cycles)};
}

}  // namespace microslip
