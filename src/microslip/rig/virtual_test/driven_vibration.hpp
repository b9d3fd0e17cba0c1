// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "microslip/dynamics/harmonic/steady_vibration.hpp"

namespace microslip {

/// A steady vibration and what drives it. Harmonics are factors of e^{inωt}, entry n that of
/// harmonic n, entry 0 is 0; the phase of F_1 is 0.
struct DrivenVibration {
  SteadyVibration vibration;                  ///< of structure and joint
  std::vector<std::complex<double>> force;    ///< F_n at the exciter, N
  std::vector<std::complex<double>> voltage;  ///< V_n of the shaker, V; empty without one
};

/// The largest |F_n|/|F_1| of a force, n = 2 … harmonics, 1. [AR14 Fig. 7]
[[nodiscard]] double force_distortion(const DrivenVibration& driven, std::size_t harmonics);

}  // namespace microslip
