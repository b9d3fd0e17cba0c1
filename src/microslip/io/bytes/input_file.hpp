// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/io/bytes/input_name.hpp"

namespace microslip {

/// No table or model that this library is meant for comes near it; a device without an end does.
inline constexpr std::size_t kLargestFile = std::size_t{16} << 30U;

/// The whole content of a file, whatever it holds. Pipes are read to their end.
/// @param path   its path, or "-" for standard input.
/// @param limit  the largest size taken, in bytes.
/// @throws FileError  where it does not exist, is a folder, may not be read or is too large.
[[nodiscard]] std::string read_file(const std::string& path, std::size_t limit = kLargestFile);

/// read_file() of a text. It is judged as it comes: at the first byte 0x00, which no text has but a
/// file after a crash of the system or a device may have without end, nothing more is read.
/// @throws FileError    as read_file(). @throws FormatError  naming the place of such a byte.
[[nodiscard]] std::string read_text(const std::string& path, std::size_t limit = kLargestFile);

class InputStream;

/// Reads what is left of a stream. @throws FileError  as read_file().
[[nodiscard]] std::string read_rest(InputStream& file, std::size_t limit = kLargestFile);

/// Reads what is left of a stream as a text. @throws FileError, FormatError  as read_text().
[[nodiscard]] std::string read_rest_of_text(InputStream& file, std::size_t limit = kLargestFile);

/// Returns the SHA-256 of what is left of a stream, without keeping it.
/// @throws FileError  where the system reports a failure, or it is larger than kLargestFile.
[[nodiscard]] std::string sha256_of_rest(InputStream& file);

/// The first bytes of a file, at most `size` of them. @throws FileError  as read_file().
[[nodiscard]] std::string read_file_head(const std::string& path, std::size_t size);

/// Whether a path leads to a pipe or a device, which can be read only once or has no end. False for
/// what does not exist, which its reader reports, and for "-": InputStream::rewind() tells of it.
[[nodiscard]] bool is_pipe_or_device(const std::string& path);

}  // namespace microslip
