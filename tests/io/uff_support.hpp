// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/uff/uff_recording.hpp"

/// @file
/// Universal files put together by hand, column by column as the format has them.

namespace microslip::test {

/// A dataset 58 for tests. What follows the header is up to them.
struct Function58 {
  std::string id = "force";
  int function_type = 1;
  std::string response = "NONE";  ///< padded to 10 bytes
  int response_node = 0;
  int response_direction = 0;
  int ordinate_type = 4;
  long long points = 0;
  bool even = true;
  std::string start = " 0.00000E+00";
  std::string step = " 1.00000E-03";
  int abscissa_type = 17;
  std::string abscissa_unit = "s";
  int ordinate_type_code = 13;
  std::string ordinate_unit = "N";
  int denominator_type = 0;
  std::string denominator_unit = "NONE";
  std::string ordinate_line{};  ///< record 9 as it is, in place of its fields
};

std::string marker();

std::string quantity_line(int type, std::string_view label, std::string_view unit);

/// The eleven lines behind that of the number.
std::string header_lines(const Function58& f);

std::string text_dataset(const Function58& f, std::string_view values);

std::string binary_dataset(const Function58& f, std::string_view payload, long long announced,
                           int byte_order = 1, int format = 2, std::string_view before_end = "");

/// The bytes of an unsigned number, the least significant first where little.
template <class Bits>
std::string bytes_of_bits(Bits bits, bool little) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof bits; ++i) {
    const std::size_t at = little ? i : sizeof bits - 1 - i;
    bytes += static_cast<char>((bits >> (8 * at)) & 0xFFU);
  }
  return bytes;
}

std::string ieee8(double value, bool little = true);
std::string ieee4(double value, bool little = true);

std::string doubles(const std::vector<double>& values);

/// A force over three points in double precision, and its values as text.
Function58 three_points();

inline const std::string kThree = "  1.000000000000E+00  2.000000000000E+00  3.000000000000E+00\n";

/// Dataset 164 with these factors.
std::string units164(int code, const std::string& length, const std::string& force);

/// Reads a text as the file t.uff.
Recordings read_uff(const std::string& content, bool allow_truncated = false);

/// The only channel of the only recording.
Channel read_channel(const std::string& content, bool allow_truncated = false);

/// What is wrong with a file, without the folder.
std::string uff_fault(const std::string& content);

std::vector<std::string> codes(const Recordings& read);

}  // namespace microslip::test
