// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

/// @file
/// Loads over time that tests and specifications know: bursts of a sine, sweeps, pulses, stationary
/// noise. Each gives the values at times that are given or made, to be joined by straight lines.

namespace microslip {

/// Times 0, h, 2h, … up to a duration, the last at or just before it.
/// @param duration       s; > 0.
/// @param sampling_rate  1/h, Hz; > 0.
/// @throws InputError  for those out of their range, or more times than check_memory() lets keep.
[[nodiscard]] std::vector<double> even_times(double duration, double sampling_rate);

/// Re Σ_n s_n e^{inωt} until `end`, 0 from there on.
/// @param time       s.
/// @param harmonics  s_1, s_2, …
/// @param frequency  ω/(2π), Hz.
/// @param end        where the burst ends, s; +∞ for none.
[[nodiscard]] std::vector<double> sine_burst(std::span<const double> time,
                                             std::span<const std::complex<double>> harmonics,
                                             double frequency, double end);

/// sin(2π ∫ f dt), f from one value at the first time to another at the last.
/// @param time         s.
/// @param from, to     f at the first and the last time, Hz; > 0.
/// @param logarithmic  in equal ratios in equal times, else in equal steps.
/// @throws InputError  for frequencies that are not positive or the same.
[[nodiscard]] std::vector<double> sine_sweep(std::span<const double> time, double from, double to,
                                             bool logarithmic);

/// sin(π(t − begin)/duration) within the pulse, else 0. [MIL-STD-810H, method 516.8]
/// @param time      s.
/// @param begin     s.
/// @param duration  s; > 0. @throws InputError
[[nodiscard]] std::vector<double> half_sine(std::span<const double> time, double begin,
                                            double duration);

/// The one-sided power spectral density of a stationary signal over the frequency, straight between
/// its points in logarithms of both, 0 outside.
struct PowerDensity {
  std::vector<double> frequency;  ///< Hz; > 0, rising; 2 at least
  std::vector<double> density;    ///< x²/Hz; > 0

  /// @throws InputError  naming the value that breaks a rule.
  void check() const;
  /// S(f).
  [[nodiscard]] double at(double f) const;
  /// √∫ S df, in closed form.
  [[nodiscard]] double rms() const;
};

/// Stationary Gaussian noise of a density: Σ_k √(S_k Δf) (a_k cos + b_k sin)(2πkΔf t), a_k and b_k
/// standard normal, by FFT. Its variance over many seeds is ∫ S df. [Shinozuka & Deodatis, Appl.
/// Mech. Rev. 44 (1991) 191]
/// @param count          of values.
/// @param sampling_rate  Hz; above twice the highest frequency.
/// @param density        of the noise.
/// @param seed           the same, the same noise.
/// @param stream         one per signal: they are independent.
/// @throws InputError  as PowerDensity::check(); for a rate too low.
[[nodiscard]] std::vector<double> stationary_noise(std::size_t count, double sampling_rate,
                                                   const PowerDensity& density, std::uint64_t seed,
                                                   std::uint64_t stream);

}  // namespace microslip
