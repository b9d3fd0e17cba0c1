// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"

/// @file
/// Numbers of a sweep without an effect.

namespace microslip {

/// Axes of more than one value along which all values of all outputs are the same, to the last bit,
/// at each place of the others: `axis_without_effect`. Grids of more than 10⁶ points and failed
/// jobs are not checked.
/// @param result   with its groups.
/// @param rows_of  rows of the jobs of a group.
[[nodiscard]] std::vector<Warning> grid_warnings(
    const EnsembleResult& result, const std::function<RowPass(std::size_t group)>& rows_of);

}  // namespace microslip
