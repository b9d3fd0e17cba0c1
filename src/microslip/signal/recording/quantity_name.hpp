// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "microslip/base/units.hpp"

namespace microslip {

/// The quantity that a channel measures, by a word in its name (force, acceleration, accel or acc,
/// velocity or vel, displacement, displ or disp, pressure, time, frequency or freq, in capitals or
/// not, with digits or `_` around it: acc1, tip_acceleration), or by the letter that is the whole
/// name but for digits: x, y or u for a displacement, v for a velocity, a for an acceleration, f
/// for a force, t for time.
/// @return  none where the name is not conclusive, or two words contradict each other.
[[nodiscard]] std::optional<Dimension> quantity_of_name(std::string_view name);

}  // namespace microslip
