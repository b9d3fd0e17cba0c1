// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// An identification as text for a person and as a record for the joint file.

namespace microslip {

/// What was identified, how sure it is and what to worry about; some twenty lines.
/// @param level_count  of the levels as read, or as merged where only that is known; of records.
[[nodiscard]] std::string describe_identification(const Identification& found,
                                                  std::size_t level_count);

/// What joint.json says of the identification under that key.
[[nodiscard]] NamedValues record_of_identification(const Identification& found);

/// The text of density.csv; negative values of methods that allow them are written as 0, and
/// comments tell of atoms and warnings, and how the band is to be read.
[[nodiscard]] std::string density_csv(const Identification& found);

}  // namespace microslip
