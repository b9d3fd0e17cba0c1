// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/loggers/byte_values.hpp"
#include "microslip/io/loggers/tdms_contents.hpp"

/// @file
/// Metadata of a segment of a TDMS file. Internal to io/loggers.

namespace microslip {

/// Where in a row of bytes the values of one source of a channel of DAQmx lie.
struct DaqmxScaler {
  std::uint32_t type = 0;    ///< of DAQmx
  std::uint32_t buffer = 0;  ///< which of the blocks of rows
  std::uint32_t offset = 0;  ///< bytes; bits of a digital line
  std::uint32_t id = 0;      ///< of the source
  bool is_digital = false;
};

/// How the values of a channel lie in a segment.
struct TdmsIndex {
  std::uint32_t type = 0;
  std::uint64_t count = 0;  ///< in each chunk
  std::uint64_t bytes = 0;  ///< of texts, in each chunk
  std::vector<DaqmxScaler> scalers = {};
  std::vector<std::uint32_t> widths = {};  ///< of the rows of DAQmx, bytes

  [[nodiscard]] bool is_daqmx() const { return !widths.empty(); }
};

/// Types of values.
inline constexpr std::uint32_t kTdmsInt64 = 4;
inline constexpr std::uint32_t kTdmsUint64 = 8;
inline constexpr std::uint32_t kTdmsExtended = 0x0B;  ///< 16 bytes, which are not read
inline constexpr std::uint32_t kTdmsExtendedWithUnit = 0x1B;
inline constexpr std::uint32_t kTdmsText = 0x20;
inline constexpr std::uint32_t kTdmsTime = 0x44;

/// The type of the values of a source of DAQmx: of 0 U8, 1 I8, 2 U16, …, 7 I64, 8 single and 9
/// double precision. 0 where it is not known.
[[nodiscard]] std::uint32_t tdms_type_of_daqmx(std::uint32_t type);

/// What converts values of this type to doubles; null where they are no numbers, or not read.
[[nodiscard]] ConvertBytes tdms_converter(std::uint32_t type, bool swap);

/// Bytes of a value of this type; 0 where it has no fixed number of them or is not known.
[[nodiscard]] std::size_t tdms_size(std::uint32_t type);

/// The time stamp in 16 bytes.
[[nodiscard]] TdmsTime tdms_time_of(const char* from, bool swap);

/// An object as a segment states it.
struct TdmsEntry {
  enum class Index { kNone, kSame, kNew };

  std::string path;
  Index has = Index::kNone;
  TdmsIndex index = {};
  TdmsProperties properties = {};
};

/// @param bytes  of the metadata, all of them.
/// @param swap   whether their byte order is not that of this machine.
/// @param place  of their first byte, for messages.
/// @throws FormatError  where they are not of the form.
[[nodiscard]] std::vector<TdmsEntry> parse_tdms_metadata(std::string_view bytes, bool swap,
                                                         const std::string& place);

}  // namespace microslip
