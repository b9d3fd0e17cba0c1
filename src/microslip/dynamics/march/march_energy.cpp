// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_energy.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

double MarchEnergy::joint_dissipation() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.dissipation;
  return sum;
}

double MarchEnergy::joint_stored() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.stored;
  return sum;
}

double MarchEnergy::joint_linear_dissipation() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.linear_dissipation;
  return sum;
}

double MarchEnergy::imbalance() const {
  const double left = initial + input;
  const double right = kinetic + elastic + linear_dissipation + joint_dissipation() +
                       joint_linear_dissipation() + joint_stored();
  const double size = std::max(
      {std::abs(left - at_rest), std::abs(right - at_rest), kLeastOfRest * std::abs(at_rest)});
  return left == right ? 0.0 : std::abs(left - right) / size;
}

}  // namespace microslip
