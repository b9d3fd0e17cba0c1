// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "microslip/base/summary.hpp"

/// @file
/// What times without a unit may be by their size: they are taken for seconds, which they need not
/// be.

namespace microslip {

/// What numbers since 1970 count.
struct CountedUnit {
  const char* unit;
  const char* words;
  double least;  ///< of the numbers, of 1973; the greatest is 100 times that, of 2286
};

/// The unit of times since 1970 of which the first is `number`: ms from 1e11, µs from 1e14, ns from
/// 1e17 on, each up to 1e2 times that. Null for others: no test is as long as these in seconds.
[[nodiscard]] const CountedUnit* counted_unit(double number);

/// Says which unit was taken, and that times are given from the first on.
/// @param place  of the times, for the text.
[[nodiscard]] Warning since_1970(const CountedUnit& unit, const std::string& place);

/// A warning where whole numbers taken for seconds are 10 or more from one to the next.
[[nodiscard]] std::optional<Warning> doubtful_seconds(double step, const std::string& place);

}  // namespace microslip
