// SPDX-License-Identifier: MIT
#pragma once

#include <new>
#include <string>

#include "microslip/base/error.hpp"

namespace microslip {

/// Returns what reads a file, where that fits into memory.
/// @param name  of the file, for the message.
/// @throws FileError  where it does not.
template <typename Read>
[[nodiscard]] auto within_memory(const std::string& name, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw FileError(name, "does not fit into memory",
                    "Is it the right file? If so, give a part of it.");
  }
}

}  // namespace microslip
