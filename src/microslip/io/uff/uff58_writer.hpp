// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/io/output/file_output.hpp"
#include "microslip/io/uff/uff58.hpp"

/// @file
/// Writing of dataset 58. Internal to io.

namespace microslip {

/// The values of a dataset; x is empty where spacing is even, imaginary where they are real.
struct Uff58Values {
  std::span<const double> x;
  std::span<const double> real;
  std::span<const double> imaginary;
};

/// The format E13.5, of x and of the numbers in the header.
[[nodiscard]] std::string uff_e13(double value);

/// The whole dataset, in double precision. As text a value has 13 significant digits, x has 6; 58b
/// is exact: little-endian IEEE, 8 bytes for x too.
void write_uff58(FileOutput& output, const Uff58Header& header, const Uff58Values& values,
                 bool binary);

}  // namespace microslip
