// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic/curve_change.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"

namespace microslip {

/// Truncation error of a curve with harmonics up to H, by the same vibrations with 2H + 1. The
/// error itself is a little larger.
struct Truncation : CurveChange {
  std::size_t harmonics = 0;  ///< 2H + 1
};

/// The truncation error below which no warning is given, 1.
inline constexpr double kTruncationAllowed = 2e-3;

/// solve_again() with harmonics up to 2H + 1, which costs some 6 evaluations per point of equations
/// twice as many as those of the curve.
/// @param balance  of the curve.
/// @param curve    the curve.
/// @param kept     its constant quantity: the force, the response, or, of a backbone, phase
///                 resonance.
/// @return nothing where the structure has no joint, or the curve no point.
[[nodiscard]] std::optional<Truncation> judge_truncation(const HarmonicBalance& balance,
                                                         const ResponseCurve& curve, Quantity kept);

/// The warning `truncated`, with figures and remedy, where more than kTruncationAllowed changes or
/// where that could not be seen.
[[nodiscard]] std::optional<Warning> truncation_warning(const Truncation& truncation);

}  // namespace microslip
