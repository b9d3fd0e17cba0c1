// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/stepped_sine_sweep.hpp"

/// @file
/// The phase resonance of a stepped-sine sweep, between two of its steps.

namespace microslip {

/// The phase resonance of a sweep, where its phase passes a quarter turn in either direction.
struct SweepResonance {
  double frequency = 0.0;      ///< Hz
  double force = 0.0;          ///< |F_1| there, N
  double acceleration = 0.0;   ///< |A_1| there, m/s²
  std::size_t passages = 1;    ///< of a quarter turn in the sweep
  double phase_step = 0.0;     ///< from the step before it to the one behind, rad, in (0, π)
  double damping_std = 0.0;    ///< of |F_1|/|A_1| at this |A_1|, relative, 1
  double frequency_std = 0.0;  ///< at this |A_1|, Hz
  /// Standard deviations of the readings of a step, by the scatter of those about the resonance; 0
  /// where that is not known.
  double amplitude_std = 0.0;       ///< of |F_1|/|A_1|, relative, 1
  double phase_std = 0.0;           ///< rad
  std::size_t scatter_freedom = 0;  ///< degrees of freedom that these two are known by
};

/// Of force F e^{iθ} and displacement X = |A_1|/ω² each step gives the dynamic stiffness
///
///     Z = (F/X) e^{iθ} = K + iC,     K = k(X) − mω²,     C = D(X)/(πX²)
///
/// of one mode with the stiffness k(X) and the loss D(X) per cycle; D = πFX sin θ is its balance of
/// power, in resonance or not. The resonance is where K, straight over ω² between the two steps
/// beside it, is 0, at a share s of their distance in ω²; ln C and ln X are straight over s too,
/// and F = CX. So frequency and force are those at which the structure is in phase resonance with
/// X, whatever was held constant. Exact where X was constant, or D grows with a power of X and k
/// with ln X. Else, with Λ = ln(X_2/X_1), of slip whose D grows with X^{2+p}, p ≤ √2, beside linear
/// damping:
///
///     |δC|/C ≤ s(1 − s) Λ²/4,     |δω| ≤ 1.9 s(1 − s) Λ² C/(2mω).
///
/// The first by the curvature p²w(1 − w) ≤ 1/2 of ln C over ln X, w the share of slip; the second
/// by that of k, p²βX^p ≤ π p(p + 2)/4 C, of a slip of virgin curve kX − βX^{p+1} [Masing: D =
/// 4βX^{p+2} p/(p + 2)].
///
/// Where a population of sliders ends between coarse steps, ln C over ln X has a bend that no power
/// has. Where it is larger, the evidence of other steps counts: s(1 − s) δ, δ how far ln C of one
/// step is off the straight line through the other and the one beside that, or how far ln C is off
/// that between the steps whose X are nearest, on whichever side of the resonance. Where k changes
/// by more than slip makes it, as past a fold, s(1 − s) Λ |Δk|/(2mω) counts, of a k that changes by
/// X^q, q ≤ 2, as of a cubic spring. m is by the farthest steps with lags of 15° to 165° about the
/// resonance: between the two beside it k may change by more than mω².
///
/// Standard deviations include these and the scatter of the steps: ln C and K/C of those about it
/// with 30° ≤ θ ≤ 150° about a least-squares fit by 1, ω² and ln X. Errors of a reading of Z are of
/// the size ε|Z| = εC/sin θ, so that steps have the weight sin θ, and ε is in the mean of two with
/// the shares s and 1 − s by √((1 − s)²/sin²θ_1 + s²/sin²θ_2). From 4 such steps on; of 3 and fewer
/// no scatter is known. An error of the phase that all steps share is not in them.
///
/// The residual of ln C and K is δZ, and δZ/Z = δln|Z| + iδθ the errors of the readings. These also
/// follow from the deviations of ln|Z| and θ of each step from a cubic over ω² through two at
/// either side, whose freedom is 1/2.63 of so many; the smaller of the two counts from a freedom of
/// 3 on.
///
/// Of several passages that of the largest acceleration.
/// @return nothing where the phase does not pass a quarter turn.
/// @throws InputError  as check_stepped_sine(); where the phase beside the resonance is 0 or half a
///                     turn, so that the damping is not determined.
[[nodiscard]] std::optional<SweepResonance> resonance_of(const SteppedSine& sweep);

/// `several_resonances`: more than one passage. `coarse_steps`: the phase changes by Δ > 30°
/// between the two steps. Up to there the rule errs by less than 0.1 % of C (tests); above, errors
/// of 1° in the phases of these two make more than 0.3 % of it, tan(Δ/2)·1°/√2.
[[nodiscard]] std::vector<Warning> warnings_of(const SweepResonance& resonance);

}  // namespace microslip
