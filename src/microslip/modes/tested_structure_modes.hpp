// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/documents/structure/structure_file.hpp"
#include "microslip/modes/structure_modes.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// A structure by the modes of a test in place of its matrices. Internal to modes.

namespace microslip {

/// The modes of a test at points and joints, with its further data.
struct TestedStructureModes {
  StructureModes modes;             ///< without attachments; loss factors as measured
  DampingLaw law;                   ///< of the modes
  std::vector<std::string> origin;  ///< lines on the origin of the modes
  std::vector<std::string> lines;   ///< one per mode: how it was measured
};

/// @param file  with a test.
/// @throws InputError  as modes_of_shapes() and modes_of_responses(); naming a point or joint whose
///                     motion was not measured or is 0, and a joint whose k the modes contradict.
[[nodiscard]] TestedStructureModes modes_of_test(const StructureFile& file);

}  // namespace microslip
