// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "microslip/base/units.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58.hpp"

/// @file
/// The units of dataset 58: its labels are taken at their word; where they are blank, the specific
/// data type and dataset 164 tell. Nothing is taken for SI on no evidence. Internal to io.

namespace microslip {

/// Of the abscissa. A blank label means s or Hz where the data type says time or frequency, since
/// dataset 164 leaves no choice of them.
/// @param units  the system of units of the file, if it has one.
[[nodiscard]] std::optional<Unit> uff_abscissa_unit(const Uff58Header& header,
                                                    const std::optional<Uff164>& units);

/// Of the values: the ordinate's, over the denominator's where that is used.
[[nodiscard]] std::optional<Unit> uff_ordinate_unit(const Uff58Header& header,
                                                    const std::optional<Uff164>& units);

/// The unit of the denominator alone; a number where it is not used.
[[nodiscard]] std::optional<Unit> uff_denominator_unit(const Uff58Header& header,
                                                       const std::optional<Uff164>& units);

/// The SI unit in the 20 characters of a label, as find_unit() reads it; nothing where it needs
/// more.
[[nodiscard]] std::optional<std::string> find_uff_unit_label(const Dimension& dimension);

/// Type, exponents and unit label for values of this dimension in SI; all blank for an unknown one.
/// @throws InputError  where the label of the unit has no place.
[[nodiscard]] UffQuantity uff_quantity(const std::optional<Dimension>& dimension);

}  // namespace microslip
