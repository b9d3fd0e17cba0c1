// SPDX-License-Identifier: MIT
#include <cstdio>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/joint.hpp"

int main() {
  const auto joint = microslip::Joint::four_parameter(400.0, 1.7e5, -0.5, 1.0);
  std::printf("dissipation = %.6e J\n", microslip::dissipation(joint, 1e-4));
}
