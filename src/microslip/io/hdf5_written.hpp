// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/io/hdf5_handle.hpp"
#include "microslip/signal/recording.hpp"

namespace microslip {

/// Reads a file that has just been written and compares, see written_recordings.hpp.
/// @throws WriteError  where the file does not hold the recordings.
void check_written_hdf5(const Hdf5Session& session, const std::string& path,
                        std::span<const Recording> recordings);

}  // namespace microslip
