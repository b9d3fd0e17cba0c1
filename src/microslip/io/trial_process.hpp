// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/io/hdf5_handle.hpp"

namespace microslip {

/// Lets a copy of this process read the file first, and returns where it comes to an end, well or
/// with an exception: the caller then does the same.
///
/// The HDF5 library (1.10 at least) follows some numbers of a file unchecked, such as the index into
/// a heap of texts. Where no checksum guards them, a changed byte can make it crash or run for ever,
/// and nothing but a process of its own contains that.
///
/// Other threads may run meanwhile. The copy has none of them, so what one of them held locked stays
/// locked in it: `read` must take no lock, and the session, which it must not open again, keeps the
/// others out of the HDF5 library. The copy prints nothing, leaves no core file, and may
/// work for 3 s (60 s with its waits) + 1 s per MiB of the file.
/// @param progress  asked now and then whether to go on, with nothing done yet.
/// @throws FormatError  where the copy crashes or does not come to an end.
/// @throws FileError    where the system starts no process.
/// @throws Cancelled
void try_in_child(const Hdf5Session& session, const std::string& path, const Progress& progress,
                  const std::function<void()>& read);

}  // namespace microslip
