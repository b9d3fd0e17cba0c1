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

/// A number and where the file has it, for messages: "valid_max".
struct Hdf5Mark {
  double number = 0.0;
  std::string name;
};

/// How a dataset stores its values.
struct Hdf5Packing {
  double scale_factor = 1.0;              ///< value = stored·scale_factor + add_offset
  double add_offset = 0.0;                ///< in the unit of the values
  std::vector<Hdf5Mark> missing = {};     ///< stored numbers that stand for no value
  std::optional<Hdf5Mark> least = {};     ///< a number below it stands for no value
  std::optional<Hdf5Mark> greatest = {};  ///< a number above it stands for no value
  bool range_of_values = false;           ///< least and greatest are of values, not as stored
  /// Whether scale_factor, add_offset and the range are those of the stored numbers.
  bool applies = true;
};

/// By the attributes scale_factor, add_offset, _FillValue, missing_value, valid_min, valid_max and
/// valid_range, and by the fill value of the dataset itself where it is other than 0: HDF5 puts it
/// where nothing was written; without one or a _FillValue, by that of netCDF in its files. A range
/// of floating-point numbers beside packed integers is one of values (NetCDF Users Guide,
/// valid_range). Where floating-point numbers of a file that is not netCDF have a scale_factor, an
/// add_offset or a range, these may be those of a sensor: they do not apply.
/// @param netcdf  whether the file is known to be one of netCDF; a dataset with scales is one.
[[nodiscard]] Hdf5Packing hdf5_packing(hid_t dataset, const std::string& place, bool netcdf);

/// Turns stored numbers into values, NaN where they stand for none.
/// @return  why the first of those is none, "-3 is the _FillValue"; empty where all are values.
[[nodiscard]] std::string unpack(const Hdf5Packing& packing, std::vector<double>& values);

/// Whether an attribute of this name is one of a packed dataset: scale_factor, add_offset or a
/// range.
[[nodiscard]] bool is_packing_attribute(const std::string& name);

/// Whether it names what stands for no value.
[[nodiscard]] bool is_missing_attribute(const std::string& name);

/// The attributes of which is_packing_attribute() is true, between commas.
[[nodiscard]] std::string packing_attributes(hid_t dataset);

}  // namespace microslip
