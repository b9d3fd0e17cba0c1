// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/config/named_values.hpp"

namespace microslip {

/// The options of an identification from those that `identify` left in joint.json: method,
/// smoothing, linear damping, atom. Options not given have their defaults; stiffness and bands are
/// not among them.
/// @throws InputError  for a smoothing that is none of the method.
[[nodiscard]] IdentificationOptions recorded_options(const NamedValues& record);

/// What joint.json holds of the options as they were given.
struct OptionTexts {
  std::string smoothing = "gcv";              ///< as on the command line
  std::optional<std::string> smoothing_unit;  ///< as on the command line
  std::string samples_out = {};               ///< file that the draws go to; empty for none
};

}  // namespace microslip
