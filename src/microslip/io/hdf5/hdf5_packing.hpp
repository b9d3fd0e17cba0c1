// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <optional>
#include <string>
#include <vector>

/// @file
/// Values that are stored otherwise than they are meant, by the conventions of netCDF: packed into
/// integers, and values that stand for missing ones (NetCDF Users Guide, Attribute Conventions; CF
/// Conventions 1.10, sections 2.5.1 and 8.1).

namespace microslip {

/// How a dataset stores its values.
struct Hdf5Packing {
  double scale_factor = 1.0;            ///< value = stored·scale_factor + add_offset
  double add_offset = 0.0;              ///< in the unit of the values
  std::vector<double> missing;          ///< stored numbers that stand for no value
  std::optional<double> least = {};     ///< a stored number below it stands for no value
  std::optional<double> greatest = {};  ///< a stored number above it stands for no value
};

/// By the attributes scale_factor, add_offset, _FillValue, missing_value, valid_min, valid_max and
/// valid_range, and by the fill value of the dataset itself where it is other than 0: HDF5 puts it
/// where nothing was written.
[[nodiscard]] Hdf5Packing hdf5_packing(hid_t dataset, const std::string& place);

/// Turns stored numbers into values, NaN where they stand for none.
void unpack(const Hdf5Packing& packing, std::vector<double>& values);

/// Whether an attribute of this name tells the packing, so that it holds no longer for the values.
[[nodiscard]] bool is_packing_attribute(const std::string& name);

}  // namespace microslip
