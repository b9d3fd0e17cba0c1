// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "fuzz/memory_file.hpp"

namespace microslip::fuzz {

/// What one run of the fuzzer reads by.
struct Reader {
  std::string_view name;  ///< as scripts/fuzz is called with it, and of the folder of its seeds
  /// Hands the bytes to all functions that read such files, and checks what they return. Errors are
  /// caught: of these the message is checked.
  void (*read)(const std::string& bytes, MemoryFile& file);
};

/// All of them.
[[nodiscard]] std::span<const Reader> readers();

}  // namespace microslip::fuzz
