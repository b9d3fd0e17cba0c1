// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "microslip/base/units.hpp"

namespace microslip {

/// What a channel of such a name measures: by a word in it (force, acceleration, accel or acc,
/// velocity or vel, displacement, displ or disp, pressure, time, frequency or freq, in capitals or
/// not, with digits or `_` around it: acc1, tip_acceleration), or by the letter that is all of the
/// name but for digits: x, y or u for a displacement, v for a velocity, a for an acceleration, f
/// for a force, t for time.
/// @return  nothing where it does not tell, or two words say different things.
[[nodiscard]] std::optional<Dimension> quantity_of_name(std::string_view name);

}  // namespace microslip
