// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/uff/uff_mode_shape.hpp"

/// @file
/// Mode shapes from universal files: datasets 55, "data at nodes", and 2414, "analysis data", of
/// the Structural Dynamics Research Laboratory, University of Cincinnati.

namespace microslip {

/// Contents of the datasets 55 and 2414 of a file.
struct UffModeShapes {
  std::vector<UffModeShape> shapes;  ///< in the order of the file; none where it has none
  std::vector<Warning> warnings;     ///< what the reader had to forgive or left out
};

/// Reads all datasets 55 and 2414 of a file and skips the others; of 2414 those of no motion of
/// nodes (stresses, values on elements) too, with a warning.
/// @throws FormatError  where the file is not of this form or ends within a dataset.
/// @throws FileError    where it cannot be read.
[[nodiscard]] UffModeShapes read_mode_shapes_uff(const std::string& path);

}  // namespace microslip
