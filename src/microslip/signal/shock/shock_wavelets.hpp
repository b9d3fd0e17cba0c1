// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// The wavelets of a synthesised shock. Internal to signal.

namespace microslip {

/// sin(πi/m) sin(πNi/m), i = 0 … m, N odd: Σ w = 0 and Σ iw = 0, so that chords through it leave
/// velocity and displacement unchanged.
struct ShockWavelet {
  std::size_t begin = 0;       ///< its first step
  std::vector<double> values;  ///< w, m + 1 of them
};

class ShockWavelets {
 public:
  /// One wavelet at each frequency.
  /// @param frequency      Hz. @param steps  of the shock: its length times the sampling rate.
  /// @param sampling_rate  Hz.
  /// @param seed, draw     of the begins.
  ShockWavelets(const std::vector<double>& frequency, std::size_t steps, double sampling_rate,
                std::uint64_t seed, std::uint64_t draw);

  /// Σ A_k w_k at the times 0, h, 2h, …
  [[nodiscard]] std::vector<double> sum(const Eigen::VectorXd& amplitude) const;

  /// Sign of the initial amplitude of each wavelet, ±1; drawn.
  [[nodiscard]] const Eigen::VectorXd& sign() const { return sign_; }

  /// The signed peak of the absolute acceleration of a mass under Σ A_k w_k, and its derivatives by
  /// the A_k at a fixed time of the peak, by a rectangle rule.
  struct Peak {
    double value = 0.0;
    Eigen::VectorXd derivative;
  };
  [[nodiscard]] Peak peak(const std::vector<double>& acceleration, double frequency,
                          double damping_ratio) const;

 private:
  double step_;
  std::size_t times_;
  std::vector<ShockWavelet> wavelets_;
  Eigen::VectorXd sign_;
};

}  // namespace microslip
