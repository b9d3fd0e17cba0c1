// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/rig/reduction/modal_reduction.hpp"
#include "microslip/workflow/reduce/reduction_inputs.hpp"

/// @file
/// Recordings of a structure with several joints to modal_levels.csv.

namespace microslip {

/// Options of reduce_modal_levels().
struct ModalLevelsReduction {
  std::string force = {};                 ///< channel; empty for that of the model or the only one
  std::vector<std::string> sensors = {};  ///< CHANNEL=POINT; empty for those of the model
  ModalReductionOptions reduction = {};   ///< of each recording
};

/// Result of reduce_modal_levels().
struct ReducedModalLevels {
  NamedInput model;                            ///< as read
  std::vector<std::string> recordings;         ///< as asked for
  ModalReducer reducer;                        ///< of the model
  ModalReductionBatch batch;                   ///< may be without levels
  std::vector<std::string> digests;            ///< SHA-256, one per recording; some may be empty
  std::vector<std::vector<Warning>> warnings;  ///< of the readers, one list a recording
};

/// @param inputs   steady records, with a model.toml.
/// @param options  channels, and how each is reduced.
/// @throws FileError, FormatError, InputError  as the readers and the reduction, unless what is
///                                             faulty is skipped; those of the model name its file.
/// @throws Cancelled  as the progress says.
[[nodiscard]] ReducedModalLevels reduce_modal_levels(const ReductionInputs& inputs,
                                                     const ModalLevelsReduction& options = {});

/// The text of modal_levels.csv: levels with D ≥ 0, version and command, digests of what was read,
/// and what is to be looked at.
/// @throws InputError  where no level is left.
[[nodiscard]] std::string modal_levels_text(const ReducedModalLevels& reduced,
                                            const std::string& command);

/// The summary: modes, levels, flags, and what was left out.
[[nodiscard]] std::string describe_modal_levels(const ReducedModalLevels& reduced);

}  // namespace microslip
