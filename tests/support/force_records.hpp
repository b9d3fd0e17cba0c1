// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/observe/force_record.hpp"
#include "support/reference_csv.hpp"

/// @file Forces of known joints on paths, by another program and by Memory.

namespace microslip::testing {

/// One of tests/data/force_records.
ForceRecord reference_record(const std::string& name);

/// The joint of those that are of a joint.
Joint record_joint();

/// Forces of a joint that is virgin at x = 0.
std::vector<double> forces_on(const Joint& joint, const std::vector<double>& path);

/// A random motion that grows from rest over a fifth of its time and goes to ±largest: sines of up
/// to 1.5 % of a cycle a sample.
/// @param finer  samples in place of one.
std::vector<double> random_motion(std::size_t count, double largest, std::uint64_t seed,
                                  std::size_t finer = 1);

/// Errors that a record of it adds.
struct RecordNoise {
  double displacement = 2e-4;  ///< standard deviation, over the largest displacement
  double force = 4e-3;         ///< over the largest force
  double offset = 0.02;        ///< of the force, over the largest
};

/// The record of a path, with noise.
ForceRecord simulated_record(const Joint& joint, const std::vector<double>& path,
                             std::uint64_t seed, const RecordNoise& noise = {},
                             double time_step = 1e-3);

/// ‖φ − φ_true‖/‖φ_true‖ over 5 to 90 % of a range of slip forces.
double error_of_density(const Joint& found, const Joint& truth, double reach);

}  // namespace microslip::testing
