// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/chain_structure.hpp"

/// @file
/// Modal levels of chains with several joints whose truth is known.

namespace microslip::testing {

inline constexpr double kLossNoise = 0.005;

/// Levels as a test of a structure would give them, and the truth beside them.
struct SimulatedTest {
  JointedStructure truth;
  JointedStructure given;
  std::vector<std::size_t> sought;
  ModalLevels levels;
  std::vector<std::vector<double>> amplitude;  // [joint][level]
  std::vector<std::vector<double>> loss;

  [[nodiscard]] CalibrationResult calibrated(const CalibrationOptions& options = {}) const;
};

/// `modes` of a structure at `count` displacements each, 0.5 % noise on the sum of the losses.
SimulatedTest simulated(const JointedStructure& truth, std::size_t modes, double from, double to,
                        int count, std::uint64_t seed);

double worst_error(const CalibrationResult& found, const SimulatedTest& test, std::size_t joint,
                   bool loss, double share = 0.1);

Joint tent(double k, double top, double share);

void give_deviations(double displacement, SimulatedTest& test);

/// Share of the levels at which the band of a joint's loss contains it.
double loss_coverage(const CalibrationResult& found, const SimulatedTest& test, std::size_t joint);

/// Other noise on the same levels.
void scatter_losses(const std::vector<double>& clean, std::uint64_t seed, SimulatedTest& test);

std::vector<double> clean_losses(const SimulatedTest& test);

JointedStructure lap_and_other(const Joint& lap, const Joint& other);

}  // namespace microslip::testing
