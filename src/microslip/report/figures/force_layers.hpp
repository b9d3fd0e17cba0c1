// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// A record beside the joint that was identified from it, as layers in SI units, before show_x()
/// and show_y(). Internal to report.

namespace microslip {

inline constexpr const char* kResidualLabel = "residual force";

/// Force over time, measured and found. @param most  samples.
[[nodiscard]] std::vector<Layer> force_layers(const ForcePath& path, std::size_t most);

/// Force over displacement, of part_for_loops().
[[nodiscard]] std::vector<Layer> loop_layers(const ForcePath& path, std::size_t most);

/// Measured less found force over time.
/// @param scatter  of a sample, N, where it is known: lines at ±2 of it.
[[nodiscard]] std::vector<Layer> residual_layers(const ForcePath& path,
                                                 std::optional<double> scatter, std::size_t most);

/// The residual over the displacement: some samples, and the means of the samples at which it rises
/// and at which it falls.
[[nodiscard]] std::vector<Layer> residual_over_displacement(const ForcePath& path,
                                                            std::optional<double> scatter);

/// Scatter s of a sample of the record, N; nothing where joint.json does not give it.
[[nodiscard]] std::optional<double> scatter_of(const ExperimentResults& results,
                                               const ForcePath& path);

}  // namespace microslip
