// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The units that figures and tables of tests are shown in, in SI units. Internal to report.

namespace microslip {

inline constexpr double kMicrometre = 1e-6;         // m
inline constexpr double kMillijoule = 1e-3;         // J
inline constexpr double kMillisecond = 1e-3;        // s
inline constexpr double kPerKilonewton = 1e-3;      // 1/N
inline constexpr double kKilonewtonPerMetre = 1e3;  // N/m
inline constexpr double kPercent = 1e-2;

}  // namespace microslip
