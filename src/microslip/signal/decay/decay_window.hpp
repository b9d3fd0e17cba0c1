// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/signal/decay/decay_leakage.hpp"
#include "microslip/signal/decay/mode_peak.hpp"

/// @file
/// One decaying oscillation in one tapered window of a signal. Internal to signal.
///
/// With τ the time from the window's centre, the samples are fitted by
///
///     y(τ)   = e^{u(τ)} cos φ(τ)
///     u(τ)   = u − ln(1 + pδτ)/p            decay rate −u̇ = δ e^{p(u(τ) − u)}
///     φ(τ)   = φ + ωτ + ατ²/2 + βτ³/6
///
/// in least squares weighted by cos⁴(πτ/T). The envelope of a decay that loses D ∝ A^{p+2} per
/// cycle is exactly this curve, p = 0 the exponential of a viscous mode; so a window may be long
/// against 1/δ and the fitted δ still be that of its centre. Frequency is known so much better than
/// decay that two free terms of phase cost nothing. The taper is the filter: signals 6/T away in
/// frequency (other modes, harmonics, an offset) move δ by less than half a per cent, which falls
/// by 30 dB per octave, and signals outside of the window have no effect.

namespace microslip {

/// Variance of δ for white noise of standard deviation σ, n samples in the window: 2Vσ²/(nA²T²), by
/// the taper: V = ∫t²cos⁸πt dt / (∫t²cos⁴πt dt)² over |t| < ½.
inline constexpr double kDecayVariance = 54.463;

/// The fitted values at the centre of the window.
struct DecayWindow {
  double centre = 0.0;     ///< s, from the first sample
  double length = 0.0;     ///< T, s
  double amplitude = 0.0;  ///< e^u, in the unit of the signal
  double decay = 0.0;      ///< δ, 1/s
  double exponent = 0.0;   ///< p, 1
  double omega = 0.0;      ///< ω, rad/s
  double chirp = 0.0;      ///< α, rad/s²
  /// Covariance of (u, δ, ω, α), over the variance of a sample's noise.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  /// Variance of a sample's noise, if all were as dense as beside the mode.
  double noise_variance = 0.0;
  /// The other modes, as strong as they are in this window; one too near to be measured in it as
  /// strong as the spectrum has it.
  std::vector<BesideMode> beside;
};

/// Shift of δ by the other modes, over δ.
[[nodiscard]] double relative_leakage(const DecayWindow& window);

/// @param signal    evenly sampled.
/// @param rate      sampling rate, Hz.
/// @param centre    s; with T/2 on both sides inside the signal.
/// @param length    T, s; 3 periods at least.
/// @param from, to  Hz: where the mode's frequency is sought.
/// @param others    of other modes, where no noise is measured.
/// @return  the fitted window; none where no such oscillation is found.
[[nodiscard]] std::optional<DecayWindow> fit_decay_window(std::span<const double> signal,
                                                          double rate, double centre, double length,
                                                          double from, double to,
                                                          std::span<const SpectralPeak> others);

/// As fit_decay_window(), without covariance, noise and other modes: the fitted values alone.
[[nodiscard]] std::optional<DecayWindow> fit_decay_values(std::span<const double> signal,
                                                          double rate, double centre, double length,
                                                          double from, double to);

}  // namespace microslip
