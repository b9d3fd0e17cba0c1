// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/inversion/inversion_result.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// Extremes of the joints that levels leave possible. D hardly determines the density between and
/// below few levels. With −2 ln p of the coefficients x given the scatter, possible is
///
///     −2 ln p(x) ≤ min + z²,   x ≥ 0,   ∫φ df* ≤ 1,
///
/// z deviations of a normal distribution without these limits. Of the smoothness next to nothing is
/// assumed: λ is a thousandth of the smallest of the path, of few levels 1e−8, or the one that was
/// given.

namespace microslip {

/// The joint that softens most from one amplitude to another, max k_eq(A₁)/k_eq(A₂); z = 3.
/// @param result     of invert().
/// @param stiffness  k of the inversion, N/m; > 0.
/// @param from       A₁, m; > 0.
/// @param to         A₂, m; above A₁.
/// @throws InputError  where the result is not one of invert(), or A₁ is not below A₂.
[[nodiscard]] Joint softest_joint(const InversionResult& result, double stiffness, double from,
                                  double to);

/// The least area Φ0 of a density and its atom, 1; z = 1.96.
/// @param result  of invert().
/// @throws InputError  where it is not.
[[nodiscard]] double least_area(const InversionResult& result);

}  // namespace microslip
