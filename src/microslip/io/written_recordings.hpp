// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/signal/recording.hpp"

/// @file
/// Libraries that write files let some errors of a disk pass, one that is full above all: a file
/// that has just been written is read again and compared.

namespace microslip {

/// The recordings as the reader gave them are those that were written.
[[nodiscard]] bool are_same(std::span<const Recording> read, std::span<const Recording> written);

/// Of a file that is not what was written.
[[noreturn]] void fail_as_not_written(const std::string& path);

}  // namespace microslip
