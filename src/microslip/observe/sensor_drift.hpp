// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/observe/force_record.hpp"

namespace microslip {

/// Slow drift of the zeros of the two sensors of a record, as polynomials
///
///     d(τ) = Σ_p c_p τ^p,   p = 1, 2, …,
///
/// of the time τ from 0 at the first sample to 1 at the last: nothing at the first sample, d(1) =
/// Σ c_p at the last. Such a drift is no motion and no force of the joint.
struct SensorDrift {
  std::vector<double> displacement = {};  ///< c_p, m; empty: none
  std::vector<double> force = {};         ///< c_p, N; empty: none
};

/// d(τ). @param coefficients  c_p from p = 1 on. @param time  τ in [0, 1].
[[nodiscard]] double drift_at(const std::vector<double>& coefficients, double time);

/// The record without the drift: u − d_u and F − d_F.
/// @param record  of two samples at least. @param drift  of its sensors.
[[nodiscard]] ForceRecord without_drift(ForceRecord record, const SensorDrift& drift);

}  // namespace microslip
