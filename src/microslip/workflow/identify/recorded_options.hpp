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

/// Options that are not in the options of the library.
struct OptionTexts {
  std::string smoothing = "gcv";              ///< as on the command line
  std::optional<std::string> smoothing_unit;  ///< as on the command line
  std::string inner_reversals = "leave-out";  ///< what was done with such levels
  CommonErrors common_errors = {};            ///< given for the levels
  std::string samples_out = {};               ///< file that the draws go to; empty for none
};

/// The same options as joint.json holds them.
[[nodiscard]] NamedValues record_of_options(const IdentificationOptions& options,
                                            const OptionTexts& texts = {});

}  // namespace microslip
