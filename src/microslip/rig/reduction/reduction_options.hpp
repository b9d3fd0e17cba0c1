// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/signal/harmonic/fourier_fit_options.hpp"

namespace microslip {

/// How Reducer reduces, and what it flags.
struct ReductionOptions {
  /// Order 10 as a rule. In a test at resonance the strongest line is the fundamental.
  FourierFitOptions fit = {.seek_longer_period = false};
  std::size_t modes = 0;          ///< see stick_state()
  bool use_vibrometer = true;     ///< false: always the joint displacement by the kinematics
  double most_distortion = 0.01;  ///< of the force without the flag force_distortion, 1; above 0
  double most_misfit = 0.05;      ///< without the flag model_misfit, 1; above 0
  double most_mismatch = 0.2;  ///< of vibrometer and kinematics without a flag, relative; above 0
  double most_phase = 0.05;    ///< rad; of a cycle against the whole record without a flag; above 0
};

}  // namespace microslip
