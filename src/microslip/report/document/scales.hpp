// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

/// @file
/// The units that figures and tables of tests are shown in, in SI units. Internal to report.

namespace microslip {

inline constexpr double kMicrometre = 1e-6;         // m
inline constexpr double kMillijoule = 1e-3;         // J
inline constexpr double kMillisecond = 1e-3;        // s
inline constexpr double kKilonewtonPerMetre = 1e3;  // N/m
inline constexpr double kPercent = 1e-2;

/// Largest number of atoms that are marked in figures and named in the summary.
inline constexpr std::size_t kMostAtomsShown = 3;

/// Returns values/unit.
[[nodiscard]] inline std::vector<double> in_unit(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

}  // namespace microslip
