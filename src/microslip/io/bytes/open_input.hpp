// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "microslip/io/bytes/file_descriptor.hpp"

/// @file
/// Input files by their descriptor, for readers that do not take them whole. Internal to io.

namespace microslip {

/// @param path  "-" is standard input.
/// @throws FileError  where it does not exist or may not be read.
[[nodiscard]] FileDescriptor open_input(const std::string& path);

/// Its size in bytes; nothing for a pipe or a device.
/// @throws FileError  where it is a folder.
[[nodiscard]] std::optional<std::size_t> regular_size(const FileDescriptor& file,
                                                      const std::string& name);

/// @param error  the value of errno after a call that failed.
[[noreturn]] void fail_reading(const std::string& name, int error);

}  // namespace microslip
