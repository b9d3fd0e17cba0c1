// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

/// @file
/// Files of HDF5, read where they are asked for: in a process that may crash, see hdf5_reader.hpp.

namespace microslip {

/// All recordings of a file, or the variables of Octave's save -hdf5.
/// @param options  of which progress, allow_untimed and rate count.
/// @throws FormatError, InputError  as read_recordings_hdf5().
[[nodiscard]] Hdf5Recordings hdf5_recordings(const std::string& path,
                                             const RecordingReadOptions& options);

/// The variables of a MATLAB file of version 7.3, which is one of HDF5.
/// @throws FormatError  as read_mat_tree().
[[nodiscard]] MatTree mat73_tree(const std::string& path, const MatReadOptions& options);

}  // namespace microslip
