// SPDX-License-Identifier: MIT
#include "microslip/modes/tested_modes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double kLeastCollinearity = 0.95;
constexpr double kLargestPhase = 10.0;  // degrees

}  // namespace

double phase_collinearity(const Eigen::VectorXcd& shape) {
  const double xx = shape.real().squaredNorm();
  const double yy = shape.imag().squaredNorm();
  const double xy = shape.real().dot(shape.imag());
  if (shape.size() < 2 || !(xx + yy > 0.0)) return 1.0;
  const double difference = xx - yy;
  return (difference * difference + 4.0 * xy * xy) / ((xx + yy) * (xx + yy));
}

void warn_of_complexity(const std::string& mode, double collinearity, double phase,
                        std::vector<Warning>& warnings) {
  if (collinearity < kLeastCollinearity) {
    warnings.push_back(
        {"mode_complex",
         fmt::format("the shape of {} is complex: its modal phase collinearity is {:.3g} of 1. The "
                     "model takes the real mode nearest to it. Damping at few places, a close mode "
                     "or noise cause that.",
                     mode, collinearity)});
  }
  const double degrees = phase * 180.0 / std::numbers::pi;
  if (std::abs(degrees) > kLargestPhase) {
    warnings.push_back(
        {"mode_phase", fmt::format("{} moves {:.3g} degrees out of phase with its force, damping "
                                   "apart: its scale is in doubt. A delay between the "
                                   "channels, or a close mode?",
                                   mode, degrees)});
  }
}

std::string freedom_name(const DegreeOfFreedom& freedom) {
  return fmt::format("node {} {}", freedom.node,
                     kNodalDirectionNames[static_cast<std::size_t>(freedom.direction)]);
}

std::string mode_name(std::size_t number, double hertz) {
  return fmt::format("mode {} ({:.6g} Hz)", number + 1, hertz);
}

}  // namespace microslip
