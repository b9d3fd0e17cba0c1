// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/hdf5/hdf5_dates.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Numbers and attributes of HDF5 files. Each `place` is that of the object, for messages.

namespace microslip {

/// Whether a type is one of real numbers.
[[nodiscard]] bool is_hdf5_number(hid_t type);

/// The length along each dimension; empty for a single value and where there is none.
[[nodiscard]] std::vector<hsize_t> hdf5_sizes(hid_t dataset);

enum class Hdf5Content { kReal, kComplex, kReferences, kTable, kTimes, kOther };

/// Values of a dataset; a table has named fields, times are of a type of HDF5 (is_hdf5_time()).
/// Complex numbers are compounds of two: `{r, i}` or `{real, imag}`.
[[nodiscard]] Hdf5Content hdf5_content(hid_t dataset);

/// Whether its values are floating-point numbers of four bytes.
[[nodiscard]] bool is_single_precision(hid_t dataset);

/// All values of a dataset, row by row, straight into the vector.
/// @throws FormatError  where the file holds fewer than the dataset claims, or they are damaged.
void read_hdf5_real(hid_t dataset, std::vector<double>& values, const std::string& place);
/// The same of whole numbers of eight bytes.
[[nodiscard]] WholeNumbers read_hdf5_integers(hid_t dataset, const std::string& place);
/// Seconds from the first on, of Hdf5Content::kTimes.
[[nodiscard]] std::vector<double> read_hdf5_times(hid_t dataset, const std::string& place);
void read_hdf5_complex(hid_t dataset, std::vector<double>& real, std::vector<double>& imaginary,
                       const std::string& place);

/// The rows or the columns of a dataset of two dimensions.
[[nodiscard]] std::vector<std::vector<double>> read_hdf5_rows(hid_t dataset,
                                                              const std::string& place);
[[nodiscard]] std::vector<std::vector<double>> read_hdf5_columns(hid_t dataset,
                                                                 const std::string& place);

/// Checks that the file holds so many values as the dataset claims, in itself and in whole, before
/// memory is made ready for them. @return their number.
std::size_t check_hdf5_storage(hid_t dataset, const std::string& place);

/// Whether Octave's save -hdf5 wrote this group: it has a dataset `type` and a value.
[[nodiscard]] bool is_octave_variable(hid_t group);

/// A text of fixed length in a dataset. @throws FormatError  where it is none.
[[nodiscard]] std::string hdf5_text_of_dataset(hid_t dataset, const std::string& place);

/// Nothing where there is no such attribute, or not one text or number.
[[nodiscard]] std::optional<std::string> hdf5_text(hid_t object, const char* name,
                                                   const std::string& place);
[[nodiscard]] std::optional<double> hdf5_number(hid_t object, const char* name,
                                                const std::string& place);

/// Texts of an attribute of any size: of fixed or variable length, or lists of single characters,
/// as MATLAB writes them; none where there is no such attribute, or it is something else.
[[nodiscard]] std::vector<std::string> hdf5_texts(hid_t object, const char* name,
                                                  const std::string& place);

/// Numbers of an attribute of any size; none where there is no such attribute, or it is text.
[[nodiscard]] std::vector<double> hdf5_numbers(hid_t object, const char* name,
                                               const std::string& place);

/// All attributes that are one text or one number, in the order in which they were written where
/// the file knows it, else by name; numbers as text.
[[nodiscard]] Attributes hdf5_attributes(hid_t object, const std::string& place);

}  // namespace microslip
