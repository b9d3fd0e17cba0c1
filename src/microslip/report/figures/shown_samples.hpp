// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Which samples of a long record are drawn. Internal to report.

namespace microslip {

/// A part of a record: samples from begin, before end.
struct RecordPart {
  std::size_t begin;
  std::size_t end;
};

/// Samples of the part that are drawn, all or at most `most`: of each interval the lowest and the
/// highest of displacement, force and residual, so that no outlier is lost.
/// @param most  ≥ 16.
[[nodiscard]] std::vector<std::size_t> shown_samples(const ForcePath& path, RecordPart part,
                                                     std::size_t most);

/// All of the record where `most` samples draw its loops well; else a part about its largest
/// displacement, with as many cycles as they draw.
[[nodiscard]] RecordPart part_for_loops(const ForcePath& path, std::size_t most);

/// Measured less found force, N; NaN where that is.
[[nodiscard]] std::vector<double> residual_of(const ForcePath& path);

}  // namespace microslip
