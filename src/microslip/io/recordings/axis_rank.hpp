// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "microslip/base/units.hpp"

/// @file
/// Which of several columns or datasets is the axis of the others: a shaft's speed in rpm, or the
/// hours that a machine has run, are channels where there is a time.

namespace microslip {

/// How well numbers fit as the axis, the best first.
enum class AxisRank {
  kNamedTime,       ///< called time or t, with a unit of time
  kTimeUnit,        ///< with a unit of a second or less
  kLongTime,        ///< in minutes or more, by a name such as "elapsed time"
  kNamedFrequency,  ///< called frequency, with a unit of frequency
  kWithoutUnit,     ///< called time or frequency, without unit: it may be that of a clock
  kFrequencyUnit,   ///< in Hz, by another name
  kSpan,            ///< a span in a unit of time, such as a delay, given over something else
  kUnknownUnit,     ///< called time or frequency, with an unknown unit such as hh:mm:ss
  kDoubtful,        ///< in minutes, hours or rpm, by another name
};

/// Whether a name is one of time: that of "elapsed" or of a quantity of time.
[[nodiscard]] bool is_named_as_time(std::string_view name);

/// The rank by name and unit; nothing where the unit is neither of time nor of frequency.
[[nodiscard]] std::optional<AxisRank> rank_as_axis(std::string_view name, const Unit& unit);

}  // namespace microslip
