// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {

/// Properties of an array of a struct that the rule for units needs.
struct UnitOfArray {
  std::string name;
  std::size_t channels = 1;                   ///< 0: it is the axis
  std::string unit;                           ///< as far as it is known; what is found is put in
  std::vector<std::string> of_channels = {};  ///< one for each of several, where they differ
};

/// The units that a struct of another program states for its arrays, in this order:
///   a field NAME_unit or NAME_units beside the array NAME;
///   `units` as a struct with a field NAME;
///   `units` as a list, a cell or a text between commas or semicolons,
///     of one for each array, the axis among them, in the order of the struct,
///     of one for each channel, in their order,
///     of one for the axis and then one for each channel,
///     of one for the axis and one for all channels,
///     else, where each channel's name tells its quantity (quantity_of_name()) and the list has one
///     unit of it: that one;
///   `units` with a single unit, for all channels.
/// Each rule is applied as a whole or not at all: where the axis got a unit of something else, a
/// channel that of a time or frequency, or one whose name is a word for another quantity that unit,
/// the next is tried. Where the order of several arrays is not known (HDF5) a list is taken only if
/// it gives all channels the same unit, or by names. An array that has a unit keeps it. A list that
/// fits none of these is reported in a warning.
/// @param list  the value of `units`; null where there is none.
void assign_units(MatValue& value, std::size_t element, const MatValue* list,
                  std::vector<UnitOfArray>& arrays, const std::string& place,
                  std::vector<Warning>& warnings);

/// The text of a value; empty where it is not one.
[[nodiscard]] std::string mat_text(const MatValue* value);

/// The texts of a cell, the rows of a text, or what stands between its commas or semicolons.
[[nodiscard]] std::vector<std::string> mat_texts(const MatValue* value);

}  // namespace microslip
