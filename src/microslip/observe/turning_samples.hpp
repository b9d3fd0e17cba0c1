// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Samples at which a path turns by more than the threshold, the first and the last among them.
/// @param path       displacement of each sample, m; not empty.
/// @param threshold  smaller turns are ignored, m; ≥ 0.
[[nodiscard]] std::vector<std::size_t> turning_samples(std::span<const double> path,
                                                       double threshold);

}  // namespace microslip
