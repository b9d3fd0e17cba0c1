// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip::test {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

using Signals = std::vector<std::vector<double>>;

std::vector<std::span<const double>> spans(const Signals& signals);

Axis even_axis(double rate, double start = 0.0);

/// The even times, each moved by up to `jitter` steps.
Axis jittered_axis(const Axis& even, std::size_t points, double jitter, std::uint64_t seed);

/// Harmonics a·share^(n−1) with phases that have no pattern.
FourierSeries series_of(double frequency, std::size_t order, double amplitude, double share,
                        double phase);

std::vector<double> sampled(const FourierSeries& series, const Axis& axis, std::size_t points,
                            double noise = 0.0, std::uint64_t seed = 1, std::uint64_t stream = 0);

/// Largest |c_n| difference over the largest |c_n| of the truth.
double coefficient_error(const FourierSeries& found, const FourierSeries& truth);

}  // namespace microslip::test
