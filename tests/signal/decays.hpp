// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/memory.hpp"

/// @file
/// Free decays whose truth is known.

namespace microslip::testing {

/// Displacement A e^{−δt} cos(ω_d t + phase) of a viscous mode, or its first or second derivative.
struct ViscousMode {
  double frequency = 50.0;      ///< ω/2π of the undamped mode, Hz
  double damping_ratio = 0.01;  ///< ζ
  double amplitude = 1e-4;      ///< m, at time 0
  double phase = 0.3;
  double start = 0.0;  ///< s; nothing before it

  [[nodiscard]] double omega() const { return 2.0 * std::numbers::pi * frequency; }
  [[nodiscard]] double decay() const { return damping_ratio * omega(); }
  [[nodiscard]] double damped_omega() const {
    return omega() * std::sqrt(1.0 - damping_ratio * damping_ratio);
  }

  /// A derivative of Re e^{pt} is Re(pⁿ e^{pt}), p = −δ + iω_d = ω e^{i(π − acos ζ)}.
  [[nodiscard]] double at(double t, int derivatives) const {
    if (t < start) return 0.0;
    const double turn = derivatives * (std::numbers::pi - std::acos(damping_ratio));
    return std::pow(omega(), derivatives) * amplitude * std::exp(-decay() * (t - start)) *
           std::cos(damped_omega() * (t - start) + phase + turn);
  }
};

inline std::vector<double> sampled(const std::vector<ViscousMode>& modes, int derivatives,
                                   double rate, double duration) {
  std::vector<double> signal(static_cast<std::size_t>(rate * duration), 0.0);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    for (const ViscousMode& mode : modes) {
      signal[i] += mode.at(static_cast<double>(i) / rate, derivatives);
    }
  }
  return signal;
}

/// White noise of a standard deviation that is a share of the largest value of the signal.
inline std::vector<double> with_noise(std::vector<double> signal, double share,
                                      std::uint64_t seed) {
  double largest = 0.0;
  for (const double y : signal) largest = std::max(largest, std::abs(y));
  RandomStream random(seed, 0);
  for (double& y : signal) y += share * largest * random.normal();
  return signal;
}

/// m ẍ + c ẋ + k x + F_joint = 0, released at rest after first loading to x0.
struct JointedMode {
  Joint joint;
  double mass = 1.0;
  double viscosity = 0.0;  ///< c, N s/m
  double stiffness = 0.0;  ///< k, N/m
  double release = 1e-4;   ///< x0, m

  /// By the velocity Verlet scheme, `steps` to a sample: its error in frequency is (ωh)²/24
  /// relative, in dissipation that of peaks met to half a step, (ωh)²/8: with 2000 steps per cycle
  /// about 1e−6.
  [[nodiscard]] std::vector<double> sampled(int derivatives, double rate, double duration,
                                            int steps) const {
    const double h = 1.0 / (rate * steps);
    Memory memory(joint);
    double x = release;
    double v = 0.0;
    double a = -(stiffness * x + memory.advance(x)) / mass;
    std::vector<double> signal;
    const auto samples = static_cast<std::size_t>(rate * duration);
    while (signal.size() < samples) {
      signal.push_back(derivatives == 0 ? x : derivatives == 1 ? v : a);
      for (int i = 0; i < steps; ++i) {
        const double half = v + 0.5 * h * a;
        x += h * half;
        a = -(stiffness * x + memory.advance(x) + viscosity * half) / mass;
        v = half + 0.5 * h * a;
      }
    }
    return signal;
  }
};

}  // namespace microslip::testing
