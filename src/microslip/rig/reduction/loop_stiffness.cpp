// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/loop_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/signal/harmonic/turning_points.hpp"

namespace microslip {

double loop_stiffness(const FourierSeries& force, const FourierSeries& displacement) {
  constexpr int kPoints = 256;
  constexpr double kTurning = 1e-4;  // sin θ below which u̇/sin θ would lose its digits
  const PeakToPeak range = peak_to_peak(displacement);
  const double amplitude = range.amplitude();
  const FourierSeries velocity = derivative(displacement);
  const FourierSeries acceleration = derivative(velocity);
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double t = displacement.period() * i / kPoints;
    const double cosine =
        std::clamp((displacement.periodic_value(t) - range.middle()) / amplitude, -1.0, 1.0);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double turning = sine > kTurning
                               ? std::abs(velocity.periodic_value(t)) / (amplitude * sine)
                               : std::sqrt(std::abs(acceleration.periodic_value(t)) / amplitude);
    sum += force.periodic_value(t) * cosine * turning;
  }
  return sum * displacement.period() / (kPoints * std::numbers::pi * amplitude);
}

}  // namespace microslip
