// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip::test {

inline constexpr double kBeta = 50.0;  // J/m²

/// φ = 1/40 1/N up to 40 N.
inline Joint uniform_joint() {
  return {1e5, SlipDensity({UniformPart{.from = 0.0, .to = 40.0, .weight = 1.0}})};
}

/// Four levels without errors up to kA = 30 N, with a linear damping in D that was identified; a
/// quarter of the input energy is lost in the structure.
inline ExperimentResults results_with_damping() {
  const Joint joint = uniform_joint();
  ExperimentResults results;
  results.joint = IdentifiedJoint{
      .joint = joint, .covered_from = 4.0, .covered_to = 30.0, .linear_damping = kBeta};
  MeasuredLevels& measured = results.levels.emplace();
  for (const double a : {4e-5, 1e-4, 2e-4, 3e-4}) {
    measured.levels.amplitude.push_back(a);
    measured.levels.dissipation.push_back(dissipation(joint, a) + kBeta * a * a);
    measured.levels.secant_stiffness.push_back(secant_stiffness(joint, a));
    measured.input_energy.push_back(4.0 * dissipation(joint, a));
    measured.linear_dissipation.push_back(dissipation(joint, a));
  }
  return results;
}

}  // namespace microslip::test
