// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// @file
/// The numbers of MAT files of version 5 [MathWorks, MAT-File Format, R2019b, chapter 1]. Internal
/// to io.
///
/// A file is a header of 128 bytes and elements: a tag of 8 bytes (type, number of bytes) and the
/// bytes, filled up to a multiple of 8. An array is an element of type kMatrix that holds elements:
/// flags, sizes, name, and then numbers (one part or two), text, or further arrays.

namespace microslip::mat5 {

inline constexpr std::size_t kHeaderSize = 128;

/// Of an element: what its bytes are.
enum Type : std::uint32_t {
  kInt8 = 1,
  kUint8 = 2,
  kInt16 = 3,
  kUint16 = 4,
  kInt32 = 5,
  kUint32 = 6,
  kSingleNumbers = 7,
  kDoubleNumbers = 9,
  kInt64 = 12,
  kUint64 = 13,
  kMatrix = 14,
  kCompressed = 15,
  kUtf8 = 16,
  kUtf16 = 17,
  kUtf32 = 18,
};

/// Of an array: what it holds.
enum Class : std::uint32_t {
  kCellClass = 1,
  kStructClass = 2,
  kObjectClass = 3,
  kCharClass = 4,
  kSparseClass = 5,
  kDoubleClass = 6,
  kSingleClass = 7,
  kUint64Class = 15,
  kFunctionClass = 16,
  kOpaqueClass = 17,
};

/// Beside the class: the array has an imaginary part.
inline constexpr std::uint32_t kComplexFlag = 0x800;

}  // namespace microslip::mat5
