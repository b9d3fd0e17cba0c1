// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"

/// @file
/// Synthesis of a shock with a required shock response spectrum.

namespace microslip {

/// The required maximax acceleration over the natural frequency, linear between its points in
/// logarithms of both.
struct RequiredSpectrum {
  std::vector<double> frequency;  ///< Hz; > 0, rising; 2 at least
  std::vector<double> maximax;    ///< R, m/s²; > 0

  /// @throws InputError  naming the value that breaks a rule.
  void check() const;
  /// R(f).
  [[nodiscard]] double at(double f) const;
};

/// How a shock is to be, and be judged.
struct ShockOptions {
  double damping_ratio = 0.05;  ///< ζ of the masses, 1; from 0, below 1. Q = 10 is 0.05
  double per_octave = 12.0;     ///< natural frequencies at which it is judged; 6 to 48
  double tolerance = 1.0;       ///< most |20 lg(S/R)| of these, dB; 0.1 to 12
  double length = 0.0;          ///< of the shock, s; shortest_shock() at least
  double sampling_rate = 0.0;   ///< 1/h, Hz; 10 times the highest frequency at least
  std::uint64_t seed = 1;       ///< the same, the same shock
};

/// Result of synthesize_shock().
struct SynthesizedShock {
  std::vector<double> acceleration;  ///< at 0, h, 2h, …, to be joined by straight lines, m/s²
  std::vector<double> frequency;     ///< f of the analysis, Hz; the ends of the required one too
  std::vector<double> required;      ///< R(f), m/s²
  std::vector<double> reached;       ///< S(f), the maximax of response_spectrum(), m/s²
  double worst = 0.0;                ///< the 20 lg(S/R) of the largest size, dB
  double worst_frequency = 0.0;      ///< where, Hz
  double worst_between = 0.0;        ///< the same at four times as many f, dB
  double peak_velocity = 0.0;        ///< of the shaken base, from rest, m/s
  double peak_displacement = 0.0;    ///< of the shaken base, from rest, m
  Summary summary;                   ///< its residual is |worst| over the tolerance
};

/// The shortest shock that has the lowest frequency f₁ of a spectrum: three half-cycles, 3/(2f₁),
/// s.
[[nodiscard]] double shortest_shock(const RequiredSpectrum& required);

/// A sum of wavelets, one at each frequency f of the analysis [Yang & Saffell]:
///
///     a(t) = Σ_k A_k sin(2πf_k τ/N_k) sin(2πf_k τ),  τ = t − t_k,  0 ≤ τ ≤ N_k/(2f_k),  N_k odd
///
/// Each leaves velocity and displacement as they were: begins and lengths are whole numbers of
/// steps h, by which f_k changes a little, so that this holds for the chords between the times as
/// well. N_k is as many half-cycles as the length allows, 15 at most; t_k and the sign of A_k are
/// drawn, most wavelets early. The |A_k| are scaled by R/S, then improved by Levenberg–Marquardt
/// steps on Σ (lg S/R)⁴ with the times of the peaks held; where the tolerance is not met, new
/// wavelets are drawn, three times at most. The best is the result.
/// @param required  R(f).
/// @param options   length and sampling rate must be given.
/// @param progress  of the evaluations; it may end before their largest number.
/// @throws InputError  for what is out of its range.
[[nodiscard]] SynthesizedShock synthesize_shock(const RequiredSpectrum& required,
                                                const ShockOptions& options,
                                                const Progress& progress = {});

}  // namespace microslip
