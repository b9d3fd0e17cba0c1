// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// An identification as text for a person and as a record for the joint file.

namespace microslip {

/// Summary: results, their uncertainty and warnings; some twenty lines.
/// @param level_count  of the levels as read, or as merged where only that is known; of records.
[[nodiscard]] std::string describe_identification(const Identification& found,
                                                  std::size_t level_count);

/// Record of the identification under that key of joint.json.
[[nodiscard]] NamedValues record_of_identification(const Identification& found);

/// The text of density.csv; negative values of methods that allow them are written as 0, and
/// comments tell of atoms and warnings, and how the band is to be read.
[[nodiscard]] std::string density_csv(const Identification& found);

}  // namespace microslip
