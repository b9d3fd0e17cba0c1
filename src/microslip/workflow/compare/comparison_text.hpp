// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/base/units.hpp"
#include "microslip/workflow/compare/comparison.hpp"

/// @file
/// Compared values in words. Internal to workflow and report.

namespace microslip {

/// "damping ratio".
[[nodiscard]] std::string shown_name(const ComparedCurve& curve);

/// "0.0837 mm" by the prefix that suits; a number alone of what has no unit; empty of NaN.
[[nodiscard]] std::string value_text(double value, const Dimension& dimension);

/// "-2.4 %", "-0.12 Hz", "+0.013 rad": predicted less measured; empty where one is missing.
[[nodiscard]] std::string difference_text(const ComparedCurve& curve, std::size_t i);

/// The rms difference of a curve, "2.1 %" or "0.013 rad"; empty where nothing can be compared.
[[nodiscard]] std::string deviation_text(const ComparedCurve& curve);

}  // namespace microslip
