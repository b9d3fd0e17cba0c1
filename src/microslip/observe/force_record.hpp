// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// The displacement path imposed on a joint and its force response: one entry per sample, evenly
/// spaced in time.
struct ForceRecord {
  std::vector<double> displacement = {};  ///< u across the joint, m
  std::vector<double> force = {};         ///< F, N; positive work for positive u̇F
  double time_step = 0.0;                 ///< Δt, s; 0 where no time was recorded

  /// The number of samples.
  [[nodiscard]] std::size_t size() const { return displacement.size(); }
};

/// The fewest samples of a record.
inline constexpr std::size_t kFewestRecordSamples = 16;

/// Checks that the lengths agree, that there are kFewestRecordSamples at least, all finite, that Δt
/// ≥ 0, and that displacement and force are not constant.
/// @throws InputError  naming the sample (1-based) and the value.
void check_force_record(const ForceRecord& record);

}  // namespace microslip
