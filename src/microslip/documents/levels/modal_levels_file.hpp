// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/observe/modal_levels.hpp"

/// @file
/// modal_levels.csv as input: one row per level. Needed: `mode [1]`, from 1, `displacement [m]` and
/// `dissipation [J]` (of all joints together) or `damping_ratio [1]` (structure included), or
/// `dissipation_NAME [J]` of a joint. Optional: `frequency [Hz]`, `amplitude_NAME [m]`, and the
/// standard deviation `_std` of each but mode and displacement; for those who ask `source` and
/// `flags`. Other columns are left alone.

namespace microslip {

/// Levels from the text of a modal_levels.csv.
/// @param text    the file's whole text.
/// @param file    its name, for messages.
/// @param joints  names of the joints of the model.
/// @param modes   how many modes it has.
/// @throws FormatError  at the cell that breaks a rule of ModalLevels, a mode that is none of the
///                      model, a column of a joint that it does not have; without a loss.
[[nodiscard]] ModalLevels parse_modal_levels(std::string text, std::string_view file,
                                             std::span<const std::string> joints,
                                             std::size_t modes);

/// Levels with what their table says of each.
struct LabelledModalLevels {
  ModalLevels levels;               ///< in the order of the file
  std::vector<std::string> source;  ///< record of each; empty where not given
  std::vector<std::string> flags;   ///< of each, separated by blanks; empty where not given
};

/// parse_modal_levels() with the columns `source` and `flags`.
[[nodiscard]] LabelledModalLevels parse_labelled_modal_levels(std::string text,
                                                              std::string_view file,
                                                              std::span<const std::string> joints,
                                                              std::size_t modes);

}  // namespace microslip
