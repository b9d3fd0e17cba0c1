// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/documents/levels/test_file.hpp"

namespace microslip {

/// Data from which a joint is identified.
enum class EvidenceKind {
  kLevels,  ///< levels.csv
  kRecord,  ///< forces and displacements over time, in any format of recordings
};

/// Kind of evidence in a file that was opened, by its content: a record where it is no text, or a
/// table without amplitude and dissipation of which a column is called as a time, a displacement or
/// a force. What comes through a pipe, which could be read only once, counts as levels.
/// @throws FileError, FormatError  as recording_format().
[[nodiscard]] EvidenceKind evidence_kind(const TestFile& file);

}  // namespace microslip
