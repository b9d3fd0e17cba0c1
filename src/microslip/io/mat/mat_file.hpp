// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/recordings/mat_tree.hpp"

/// @file
/// MAT files, whatever their version. Internal to io.

namespace microslip {

class InputStream;

/// Reads a file of version 4, 5 (compressed or not) or 7.3, a text file of Octave, or one of HDF5
/// that another program wrote: variables of Octave's save -hdf5 are what they were there; else
/// groups are structs, datasets of numbers arrays, transposed, and a group with `data`, `indices`
/// and `indptr`, as SciPy has them, is a sparse matrix, transposed where its rows are compressed.
/// @throws FileError    where it cannot be read.
/// @throws FormatError  where it is no such file or is damaged.
[[nodiscard]] MatTree read_mat_tree(const std::string& path, const MatReadOptions& options = {});

/// As above, of a file that is open, of which nothing was taken. Version 7.3 and HDF5 are opened
/// again, by the process that reads them.
[[nodiscard]] MatTree read_mat_tree(InputStream& file, const MatReadOptions& options);

}  // namespace microslip
