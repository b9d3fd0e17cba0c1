// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/io/sandbox/parcel.hpp"

namespace microslip {

/// Has another program read a file, and takes over what it has read: reading_worker.hpp is its
/// side.
///
/// The HDF5 library (1.10 at least) follows some numbers of a file unchecked, such as the index
/// into a heap of texts or the size of an object. A changed byte can make it crash or run for ever,
/// before anything of the file could say that it is whole; checksums do not guard all of them. So
/// nothing of a file is read but in a process of its own, which contains all that.
/// @param command   the program and its arguments, see Child::start().
/// @param path      of the file, for messages.
/// @param progress  asked now and then whether to go on.
/// @param take      takes what the program sends as its result.
/// @throws FormatError  where the program crashes or does not come to an end.
/// @throws FileError    where it is not there, or the system does not start it.
/// @throws InputError, FormatError, FileError, std::bad_alloc  what reading there threw.
/// @throws Cancelled    also where a signal of the terminal (SIGINT, SIGTERM, SIGHUP) ended it.
void run_reading_process(const std::vector<std::string>& command, const std::string& path,
                         const Progress& progress,
                         const std::function<void(ParcelReader& from)>& take);

/// The same for a program that sends one value that parcel.hpp can pass().
template <class Result>
[[nodiscard]] Result read_in_process(const std::vector<std::string>& command,
                                     const std::string& path, const Progress& progress) {
  Result result;
  run_reading_process(command, path, progress, [&](ParcelReader& from) { pass(from, result); });
  return result;
}

}  // namespace microslip
