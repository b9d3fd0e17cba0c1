// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/report/document/figure_options.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Figures of a test on a rig and of its predictions, on paper and on the page of a report.

namespace microslip {

/// Acceleration over force, over the frequency, at constant responses by the joint of the results,
/// dotted by the true one where that is known; with the levels of the test. [AR14 Fig. 4]
/// @throws InputError  without responses, and for a unit that is none of acceleration.
[[nodiscard]] Figure constant_response_figure(const ExperimentResults& results,
                                              const FigureOptions& options = {});

/// The largest harmonic of the force from the second, over the first, before and after the force
/// control, over the response. [AR14 Fig. 7]
/// @param levels   one with harmonics at least.
/// @param options  of the axes.
/// @throws InputError  without such levels, and for a unit that is none of acceleration.
[[nodiscard]] Figure force_distortion_figure(std::span<const ForceControlLevel> levels,
                                             const FigureOptions& options = {});

/// The harmonics of the force at a level, from the second, over the first. [AR14 Fig. 7]
[[nodiscard]] Figure force_harmonics_figure(const ForceControlLevel& level);

/// The harmonics of the force at the highest level, and force_distortion_figure() beside them.
/// @throws InputError  as force_distortion_figure().
[[nodiscard]] FigureGrid force_control_figure(std::span<const ForceControlLevel> levels,
                                              const FigureOptions& options = {});

/// The force of the highest level over a cycle, and the figures above.
/// @param levels     of a virtual test with a shaker; one at least.
/// @param harmonics  that were controlled, from 2.
/// @param options    of the axes.
/// @throws InputError  for a unit that is none of acceleration.
[[nodiscard]] FigureGrid force_control_figure(std::span<const VirtualLevel> levels,
                                              std::size_t harmonics,
                                              const FigureOptions& options = {});

/// NRMSE and noise of each channel, a figure each with its name as the title, over the response.
/// @throws InputError  without comparisons.
[[nodiscard]] std::vector<Figure> deviation_figures(const ExperimentResults& results,
                                                    const FigureOptions& options = {});

}  // namespace microslip
