// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Units that a file may mean otherwise than it writes them. Accelerations that are labelled g
/// beside the factor 1/9.80665. Some analysers store m/s² and write label and factor for those who
/// want to show g; others store g. Nothing in the file tells which, and the wrong guess is off by a
/// factor of ten: the user is asked.

namespace microslip {

/// Whether it is standard gravity, the unit g.
[[nodiscard]] bool is_gravity(const Unit& unit);

/// Whether a number in the text is 1/9.80665 within 1e-3: 0.10197, 0.102.
[[nodiscard]] bool says_per_gravity(std::string_view text);

/// Whether the value of one of them does.
[[nodiscard]] bool says_per_gravity(const Attributes& attributes);

/// Warning on such a channel, which is treated as without unit: its largest value in either unit,
/// and how to say which holds.
/// @param place   of the channel, for the message.
/// @param name    of the channel.
/// @param values  as the file has them.
[[nodiscard]] Warning doubtful_gravity(std::string_view place, std::string_view name,
                                       std::span<const double> values);

/// Whether a channel called a force or a load is in lb, which is a mass: lbf is meant.
[[nodiscard]] bool is_force_in_pounds(std::string_view name, const Unit& unit);

/// Warning on such a channel, which is taken in lbf.
[[nodiscard]] Warning force_in_pounds(std::string_view place, std::string_view name);

/// The unit lbf.
[[nodiscard]] Unit pound_force();

}  // namespace microslip
