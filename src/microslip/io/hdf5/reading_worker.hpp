// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/io/sandbox/parcel.hpp"

namespace microslip {

/// Worker side of a reading program, see reading_process.hpp.
struct ReadingWork {
  std::function<void(const Progress& progress)> read;
  std::function<void(ParcelWriter& to)> give;  ///< what has been read
};

/// Reads and sends, on standard output, what was read or what was thrown. Nothing else gets there,
/// for what others print goes to `/dev/null`. No core file is left. The process may work for 2 s +
/// 1 s per 4 MiB of the file + 1 s per 32 MiB that it is found to hold (60 s with its waits, + 1 s
/// per MiB), and take 512 MiB of memory + 16 times the size of the file + twice what it is found to
/// hold.
/// @return the exit status of the program.
[[nodiscard]] int run_reading_worker(const std::string& path, const ReadingWork& work);

/// So many bytes are going to be read that the file is known to hold, compressed perhaps. Time and
/// memory for them are added to the limits. In another process it does nothing.
void expect_to_read(std::size_t bytes);

}  // namespace microslip
