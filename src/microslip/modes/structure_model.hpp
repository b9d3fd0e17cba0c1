// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/modes/structure_modes.hpp"

/// @file
/// From a STRUCTURE.toml to a model.toml, for `microslip modes`.

namespace microslip {

/// A model by the modes of a structure.
struct StructureModel {
  ModelFile file;        ///< its joint files are named from where the text will lie
  StructureModes modes;  ///< and how they were found
  std::string text;      ///< of the model.toml, with warnings and how it came to be
  /// Origin of the modes of a test: lines on the whole, then one per mode; empty for matrices.
  std::vector<std::string> origin = {};
};

/// @param path      STRUCTURE.toml. @param out  where the text will lie; "-" is standard output.
/// @param command   the command line, for the file.
/// @param progress  of ModesOptions.
/// @throws FileError, FormatError, InputError  as read_structure_file() and
///                                             compute_structure_modes(). @throws Cancelled
[[nodiscard]] StructureModel model_of_structure(const std::string& path, const std::string& out,
                                                const std::string& command,
                                                const Progress& progress);

/// The summary: size, modes with their frequencies, what the model lacks at its joints.
[[nodiscard]] std::string describe_structure_model(const std::string& path,
                                                   const StructureModel& model);

}  // namespace microslip
