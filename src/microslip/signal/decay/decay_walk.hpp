// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/signal/decay/decay_window.hpp"
#include "microslip/signal/decay/shape_course.hpp"

/// @file
/// Windows one behind the other along a decay, each as long as it has to be. Internal to signal.

namespace microslip {

/// What a sensor measures of the mode.
struct MeasuredMotion {
  int derivatives = 0;     ///< of displacement
  ShapeCourse shape = {};  ///< of the mode there
};

/// The task of the walk. A window is as long as the noise, the leakage of other modes and the least
/// fall require: over a smaller fall any small disturbance looks like damping.
struct DecayTask {
  std::span<const double> signal;
  double rate = 0.0;  ///< Hz
  MeasuredMotion measured = {};
  double from = 0.0;  ///< s from the first sample: the range of the decay
  double to = 0.0;
  double lowest = 0.0;  ///< Hz, where the mode's frequency is sought
  double highest = 0.0;
  std::vector<SpectralPeak> others = {};  ///< other modes
  double shortest = 0.0;                  ///< s, of a window
  double first_length = 0.0;              ///< s, where the walk tries first
  double least_fall = 0.0;                ///< ln of the ratio of amplitudes over a window
  double largest_fall = 0.0;
  double wanted_std = 0.0;
  double largest_std = 0.0;
};

/// Displacement and loss at the centre of a window.
struct DecayPoint {
  double amplitude = 0.0;  ///< m
  double amplitude_std = 0.0;
  double omega = 0.0;  ///< rad/s
  double omega_std = 0.0;
  double damping = 0.0;  ///< ζ
  double damping_std = 0.0;
  double loss = 0.0;  ///< 2πζω²A²
  double loss_std = 0.0;
};

/// With n = 0, 1, 2 derivatives of displacement measured, A = e^u/ω^n and −Ȧ/A = δ + nω̇/ω, up to
/// terms of the order ζ² that are kept for a constant ω. Where the shape of the mode moves with its
/// frequency the modal amplitude q = A/φ(ω) decays, and −q̇/q = −Ȧ/A + (d ln φ/d ln ω) ω̇/ω.
[[nodiscard]] DecayPoint decay_point(const DecayWindow& window, const MeasuredMotion& measured,
                                     double noise_variance);

enum class WalkEnd { kRecord, kNoise, kRise, kLost };

struct DecayWalk {
  std::vector<DecayWindow> windows;
  double noise_variance = 0.0;  ///< of a sample
  WalkEnd end = WalkEnd::kRecord;
  double end_time = 0.0;  ///< s, centre of the window that was not taken
};

/// A first walk finds the noise, a second takes windows that are as long as the noise needs.
[[nodiscard]] DecayWalk walk_along(const DecayTask& task);

}  // namespace microslip
