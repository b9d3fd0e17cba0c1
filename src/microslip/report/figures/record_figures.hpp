// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Records as figures. Internal to report.

namespace microslip {

/// Names and styles of the two curves of a signal.
struct RecordNames {
  const char* recorded;
  const char* other;
  int other_colour;  ///< a dashed line in front of the recorded one
  bool other_shown;  ///< at first; that of the force is anyway
};

inline constexpr RecordNames kControlNames = {"", "before control", kPurple, false};
inline constexpr RecordNames kPredictedNames = {"recorded", "predicted", kBlack, true};

/// Histories of the channels, a figure per unit with the first eight, and their harmonics; the
/// reader chooses the record, which has its response beside its name where the levels have it.
void add_records(ReportSection& section, const ExperimentResults& results,
                 const std::vector<LevelRecord>& records, const RecordNames& names);

}  // namespace microslip
