// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// A field of a table of HDF5, one number a row; of a field of lists each place is one.
struct Hdf5Field {
  std::string name;            ///< without a unit in brackets; NAME_2 of the second of a list
  std::string unit;            ///< as in the file; empty: none
  std::vector<double> values;  ///< of all rows
};

/// A dataset of Hdf5Content::kTable by its fields.
struct Hdf5Table {
  std::vector<Hdf5Field> fields = {};         ///< of real numbers, in the order of the file
  std::vector<LeftOutChannel> left_out = {};  ///< those of other types
  std::vector<Warning> warnings = {};
};

/// A unit is the text of the attribute `NAME_unit` or `NAME_units`, that of `units` where this has
/// one for each field, or in brackets behind the name of the field, as in tables of text. Dates of
/// pandas and times of PyTables are seconds from the first on; whole numbers called time, as
/// whole_times().
/// @param place  of the dataset, for messages.
/// @throws FormatError  where the file holds fewer rows than the dataset claims, or they are
///     damaged.
[[nodiscard]] Hdf5Table read_hdf5_table(hid_t dataset, const std::string& place);

}  // namespace microslip
