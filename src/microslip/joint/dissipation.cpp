// SPDX-License-Identifier: MIT
#include "microslip/joint/dissipation.hpp"

#include "microslip/joint/amplitude.hpp"

namespace microslip {

double dissipation(const Joint& joint, double amplitude) {
  check_amplitude(amplitude);
  const double k = joint.stiffness();
  return 4.0 / k * joint.density().slip_energy(k * amplitude);
}

double dissipation_slope(const Joint& joint, double amplitude) {
  check_amplitude(amplitude);
  return 4.0 * joint.density().moments(joint.stiffness() * amplitude).first;
}

double dissipation_curvature(const Joint& joint, double amplitude) {
  check_amplitude(amplitude);
  const double k = joint.stiffness();
  return 4.0 * amplitude * k * k * joint.density().density(k * amplitude);
}

}  // namespace microslip
