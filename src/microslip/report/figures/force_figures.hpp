// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/figure_options.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Figures of the first of the records that a joint was identified from. Of long records those
/// samples are drawn that stand out.

namespace microslip {

/// Force over time, measured and of the joint, and below it the difference.
/// @throws InputError  where there is no such record.
[[nodiscard]] FigureGrid record_force_figure(const ExperimentResults& results,
                                             const FigureOptions& options = {});

/// Force over displacement, measured and of the joint.
/// @throws InputError  where there is no such record.
[[nodiscard]] Figure record_loops_figure(const ExperimentResults& results,
                                         const FigureOptions& options = {});

/// Measured less found force over time and over the displacement.
/// @throws InputError  where there is no such record.
[[nodiscard]] FigureGrid residuals_figure(const ExperimentResults& results,
                                          const FigureOptions& options = {});

}  // namespace microslip
