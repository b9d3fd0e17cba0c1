// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/signal/decay/decay_walk.hpp"

/// @file
/// Dependence of the results of a decay on the window. Internal to signal.
///
/// Each window is fitted again with 0.8, 1.25 and 1.6 times its length about the same centre. Other
/// modes leak through the shorter one four times as strongly and through the longer ones a quarter
/// and a seventeenth, and errors of the model of the envelope grow with a high power of the length:
/// so the differences show both, about as large as the error itself or larger. Noise makes the
/// lengths differ by some quarter of its variance, which is subtracted. The leakage by
/// decay_leakage() is a lower bound for damping. A mode too near for any of the lengths makes the
/// decay beat: the scatter of damping, frequency and amplitude about smooth courses beyond their
/// noise is added, and to the loss the error of 0.15 % of first harmonics.

namespace microslip {

/// A length that a window is fitted with again, and what noise alone makes the two differ by: mean
/// squares over the variance of the one. For estimators b_T of the fit, under cos⁴ and few radians
/// of decay, Σ(b_T − b_T′)²/Σb_T²; the lengths share samples, and it is less than the variances
/// differ by.
struct OtherLength {
  double factor;
  double level;      ///< of u, with the curvature of the envelope free
  double frequency;  ///< of ω, with β free
  double decay;      ///< of δ
};
inline constexpr OtherLength kOtherLengths[] = {
    {0.8, 0.062, 0.340, 0.284}, {1.25, 0.050, 0.174, 0.145}, {1.6, 0.179, 0.492, 0.430}};

/// Mean squares of relative differences, 1.
struct DecaySpread {
  double amplitude = 0.0;
  double omega = 0.0;
  double damping = 0.0;
  double loss = 0.0;
};

/// The spread of a fitted window: means over the lengths, less the average difference due to noise.
/// That of one window may therefore be below 0.
[[nodiscard]] DecaySpread spread_of(const DecayTask& task, const DecayWindow& window,
                                    double noise_variance);

/// The points of windows with standard deviations by noise and by spread, that averaged over the
/// windows whose centres are within half a window, and by the scatter about smooth courses.
[[nodiscard]] std::vector<DecayPoint> points_of(const DecayTask& task,
                                                std::span<const DecayWindow> windows,
                                                double noise_variance);

}  // namespace microslip
