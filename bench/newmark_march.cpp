// SPDX-License-Identifier: MIT
#include "newmark_march.hpp"

#include <cmath>

#include "microslip/joint/memory.hpp"

namespace microslip::bench {

std::vector<double> newmark_march(const JointedStructure& structure,
                                  const std::vector<double>& force, double step, double tolerance) {
  const StructuralJoint& joint = structure.joints()[0];
  const auto drive = structure.linear().shape(structure.excitations()[0].point);
  const auto modes = structure.linear().modes();
  const std::size_t n = modes.size();
  const double quarter = 0.25 * step * step;
  std::vector<double> q(n), v(n), a(n), free(n), gain(n), damping(n), stiffness(n);
  double coupling = 0.0;  // of the joint's load to its slide
  for (std::size_t i = 0; i < n; ++i) {
    stiffness[i] = modes[i].angular_frequency * modes[i].angular_frequency;
    damping[i] = modes[i].loss_factor * modes[i].angular_frequency;
    gain[i] = 1.0 / (1.0 + 0.5 * step * damping[i] + quarter * stiffness[i]);
    coupling += quarter * gain[i] * joint.shape[i] * joint.shape[i];
  }
  Memory memory(joint.joint);
  double r = 0.0;  // F − k_s s
  double largest = 0.0;
  std::vector<double> displacement{0.0};
  for (std::size_t k = 1; k < force.size(); ++k) {
    double slide = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double half_v = v[i] + 0.5 * step * a[i];
      const double free_q = q[i] + step * v[i] + quarter * a[i];
      free[i] = gain[i] * (drive[i] * force[k] - damping[i] * half_v - stiffness[i] * free_q);
      slide += joint.shape[i] * (free_q + quarter * free[i]);
    }
    for (int round = 0; round < 50; ++round) {
      const double s = slide - coupling * r;
      const auto [f, tangent] = memory.trial(s);
      const double beyond = tangent - joint.spring_in_modes;
      const double change = (f - joint.spring_in_modes * s - r) / (1.0 + beyond * coupling);
      r += change;
      largest = std::max(largest, std::abs(f));
      if (std::abs(change) <= tolerance * largest) break;
    }
    memory.advance(slide - coupling * r);
    double w = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double next = free[i] - gain[i] * joint.shape[i] * r;
      q[i] += step * v[i] + quarter * (a[i] + next);
      v[i] += 0.5 * step * (a[i] + next);
      a[i] = next;
      w += drive[i] * q[i];
    }
    displacement.push_back(w);
  }
  return displacement;
}

}  // namespace microslip::bench
