// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "microslip/io/hdf5/hdf5_handle.hpp"

/// @file
/// Dimension scales: datasets that a file names for the dimensions of others (HDF5 Dimension Scale
/// Specification 1.0). netCDF-4 stores each of its dimensions as one, whether it has values or not.

namespace microslip {

/// Address of an object in its file, the same for each link to it.
[[nodiscard]] haddr_t hdf5_address(hid_t object);

/// Whether a dataset is the scale of a dimension.
[[nodiscard]] bool is_hdf5_scale(hid_t dataset, const std::string& place);

/// Whether it is a dimension of netCDF without a variable of its name. Its values were never
/// written.
[[nodiscard]] bool is_bare_dimension(hid_t dataset, const std::string& place);

/// The scales of each dimension of a dataset, by its attribute DIMENSION_LIST; all are empty where
/// it has none.
/// @throws FormatError  where the attribute cannot be read.
[[nodiscard]] std::vector<std::vector<Hdf5Handle>> hdf5_scales(hid_t dataset,
                                                               const std::string& place);

}  // namespace microslip
