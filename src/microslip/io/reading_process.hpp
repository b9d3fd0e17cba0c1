// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/io/hdf5_handle.hpp"
#include "microslip/io/parcel.hpp"

namespace microslip {

/// What happens in the copy, and what this process does with what it sends.
struct ReadingProcess {
  std::function<void(const Progress& progress)> read;  ///< in the copy
  std::function<void(ParcelWriter& to)> give;          ///< in the copy: what has been read
  std::function<void(ParcelReader& from)> take;        ///< in this process
};

/// Lets a copy of this process read the file and takes over what it has read.
///
/// The HDF5 library (1.10 at least) follows some numbers of a file unchecked, such as the index
/// into a heap of texts or the size of an object. A changed byte can make it crash or run for ever,
/// before anything of the file could say that it is whole; checksums do not guard all of them. So
/// nothing of a file is read but in a process of its own, which contains all that.
///
/// Other threads may run meanwhile. The copy has none of them, so what one of them held locked
/// stays locked in it: `read` must take no lock, and the session, which it must not open again,
/// keeps the others out of the HDF5 library. The copy prints nothing, leaves no core file, and may
/// work for 1 s + 1 s per 4 MiB of the file + 1 s per 32 MiB that it is found to hold (60 s with
/// its waits, + 1 s per MiB), and take 512 MiB of memory + 16 times the size of the file + twice
/// what it is found to hold.
/// @param progress  asked now and then whether to go on.
/// @throws FormatError  where the copy crashes or does not come to an end.
/// @throws FileError    where the system starts no process.
/// @throws InputError, FormatError, FileError, std::bad_alloc  what `read` throws.
/// @throws Cancelled
void run_reading_process(const Hdf5Session& session, const std::string& path,
                         const Progress& progress, const ReadingProcess& process);

/// The same for a function that returns what it has read: something that parcel.hpp can pass().
template <class Result, class Read>
[[nodiscard]] Result read_in_process(const Hdf5Session& session, const std::string& path,
                                     const Progress& progress, const Read& read) {
  Result result;  // one in each process
  run_reading_process(session, path, progress,
                      {.read = [&](const Progress& told) { result = read(told); },
                       .give = [&](ParcelWriter& to) { pass(to, result); },
                       .take = [&](ParcelReader& from) { pass(from, result); }});
  return result;
}

/// In such a copy: so many bytes are going to be read that the file is known to hold, compressed
/// perhaps. Time and memory for them are added to the limits. Elsewhere it does nothing.
void expect_to_read(std::size_t bytes);

}  // namespace microslip
