// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "microslip/identify/methods/identification.hpp"

/// @file
/// An identification as text for a person, and its density as a table.

namespace microslip {

/// Summary: results, their uncertainty and warnings; some twenty lines.
/// @param level_count  of the levels as read, or as merged where only that is known; of records.
[[nodiscard]] std::string describe_identification(const Identification& found,
                                                  std::size_t level_count);
/// As above, with some warnings in place of its own.
[[nodiscard]] std::string describe_identification(const Identification& found,
                                                  std::size_t level_count,
                                                  std::span<const Warning> warnings);

/// The text of density.csv; negative values of methods that allow them are written as 0, and
/// comments tell of atoms and warnings, and how the band is to be read.
/// @param command  of the first comment, see heading_of().
[[nodiscard]] std::string density_csv(const Identification& found, std::string_view command);

}  // namespace microslip
