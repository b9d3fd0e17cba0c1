// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Header of a dataset 58, "function at nodal degree of freedom". Values and units are as in the
/// file. Not installed.

namespace microslip {

/// A point of the structure and the direction there.
struct UffPoint {
  std::string entity = {};  ///< empty: none
  std::int64_t node = 0;
  std::int64_t direction = 0;  ///< 0 none, ±1…±3 = ±X, ±Y, ±Z, ±4…±6 rotations about them

  friend bool operator==(const UffPoint&, const UffPoint&) = default;
};

/// The label of values whose unit is not known, where a blank one would be taken for SI by the type
/// of the data and dataset 164.
inline constexpr std::string_view kUnknownUffUnit = "unknown";

/// Quantity of the numbers of an axis.
struct UffQuantity {
  std::int64_t type = 0;                    ///< specific data type, see uff_units.hpp
  std::array<std::int64_t, 3> exponents{};  ///< of length, force, temperature; for type 1 only
  std::string label;
  std::string unit;  ///< empty: none

  friend bool operator==(const UffQuantity&, const UffQuantity&) = default;
};

/// Records 1 to 11.
struct Uff58Header {
  std::array<std::string, 5> id_lines;
  std::int64_t function_type = 0;
  std::int64_t function_id = 0;
  std::int64_t version = 0;
  std::int64_t load_case = 0;
  UffPoint response;
  UffPoint reference;
  bool is_double = true;
  bool is_complex = false;
  std::size_t points = 0;
  bool even = true;
  double start = 0.0;
  double step = 0.0;
  double z = 0.0;
  UffQuantity abscissa;
  UffQuantity ordinate;
  UffQuantity denominator;
  UffQuantity z_axis;

  /// Values of a point: x where spacing is uneven, then one or two.
  [[nodiscard]] std::size_t values_per_point() const { return (even ? 0U : 1U) + components(); }
  [[nodiscard]] std::size_t components() const { return is_complex ? 2U : 1U; }
};

struct Uff58 {
  Uff58Header header;
  std::vector<double> x;  ///< empty where spacing is even
  std::vector<double> values;
  std::vector<double> imaginary;  ///< empty where they are real
};

}  // namespace microslip
