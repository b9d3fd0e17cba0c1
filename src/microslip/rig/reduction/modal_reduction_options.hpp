// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/signal/harmonic/fourier_fit_options.hpp"

namespace microslip {

/// How ModalReducer reduces, and what it flags.
struct ModalReductionOptions {
  /// As in ReductionOptions.
  FourierFitOptions fit = {.seek_longer_period = false};
  /// From 1; none: the mode with the stuck frequency nearest to that of the record.
  std::optional<std::size_t> mode = {};
  double most_distortion = 0.01;  ///< of the force without the flag force_distortion, 1; above 0
  double most_misfit = 0.05;      ///< without the flag model_misfit, 1; above 0
  double most_phase = 0.05;       ///< as in ReductionOptions
};

}  // namespace microslip
