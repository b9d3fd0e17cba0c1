// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// In a build without the HDF5 library. @throws FileError  which says so, always.
[[noreturn]] void refuse_hdf5(const std::string& path);

}  // namespace microslip
