// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file Structures with several joints, and records of their vibrations by sensors.

namespace microslip::testing {

/// Piecewise-linear, from f = 0 to 2 · `middle` N, of area 0.9.
Joint humped_joint(double stiffness, double middle, double at_zero);

/// A chain of masses p1, p2, … of about 1 kg between two walls, its springs some 1e6 N/m, with
/// joints between places that are drawn (or to the wall), driven at p1; modes with stuck joints.
JointedStructure random_chain(std::uint64_t seed, std::size_t joints, DampingLaw damping);

/// How a record of a structure is taken.
struct JointedSampling {
  double rate = 8192.0;  // Hz
  std::size_t points = 4096;
  double force_noise = 0.002;         // N, standard deviation of a sample
  double acceleration_noise = 0.005;  // m/s²
};

/// The force and the accelerations at points, channels "force" and those of the points; the phase
/// at which it begins and the noise are drawn.
Recording record_of(const JointedStructure& structure, const SteadyVibration& vibration,
                    const std::vector<std::string>& points, std::uint64_t seed,
                    const JointedSampling& sampling = {});

}  // namespace microslip::testing
