// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// Conditions of tests in words. Their names may end in a unit, as `torque_Nm`.

/// "torque 5, 10 Nm", or "order rising" where the name has no unit.
/// @param values  as people write them.
[[nodiscard]] std::string condition_text(std::string_view name, std::string_view values);

/// "Nm of torque", or "unit of NAME": what a trend is per.
[[nodiscard]] std::string condition_step(std::string_view name);

/// "torque [Nm]", or "order" where the name has no unit: the head of its values.
[[nodiscard]] std::string condition_title(std::string_view name);

}  // namespace microslip
