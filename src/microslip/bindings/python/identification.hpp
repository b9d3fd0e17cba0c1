// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip::python {

/// Columns of Levels by the names of the package, which are those of levels.csv.
[[nodiscard]] Levels levels_of_columns(const pybind11::dict& columns);

/// An identification as the package takes it.
/// @param file  its joint.json, whose provenance is that of the draws.
[[nodiscard]] pybind11::dict identification_dict(const Identification& found,
                                                 const JointFile& file);

}  // namespace microslip::python
