// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/report/document/figure_options.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Several joints identified from levels of modes, and levels of modes alone. Marks are measured,
/// lines computed from the joints; modes and joints differ by colour and by mark or line. Each
/// figure is the same on paper and on the page of a report.

namespace microslip {

/// The densities of all joints with their bands, grey where the prior determines them.
/// @throws InputError  without densities.
[[nodiscard]] Figure densities_figure(const ExperimentResults& results,
                                      const FigureOptions& options = {});

/// The density of one joint, grey where the prior determines it.
/// @param joint  of `results.densities`.
[[nodiscard]] Figure density_with_prior_figure(const ExperimentResults& results, std::size_t joint);

/// Variance reduction, the share of the prior variance that the levels removed, over slip force, a
/// line per joint. @throws InputError  where no joint has it.
[[nodiscard]] Figure variance_reduction_figure(const ExperimentResults& results);

/// For paper: density_with_prior_figure() per joint, and variance_reduction_figure().
[[nodiscard]] FigureGrid identifiability_figure(const ExperimentResults& results,
                                                const FigureOptions& options);

// Over the displacement at the response point, one mark or line per mode.

/// Loss per cycle. @throws InputError  without a loss.
[[nodiscard]] Figure modal_loss_figure(const ExperimentResults& results,
                                       const FigureOptions& options = {});

/// The loss as measured over that found, less 1. @throws InputError  where nothing was found.
[[nodiscard]] Figure modal_loss_error_figure(const ExperimentResults& results,
                                             const FigureOptions& options = {});

/// Damping ratio of structure and joints. @throws InputError  without one.
[[nodiscard]] Figure modal_damping_figure(const ExperimentResults& results,
                                          const FigureOptions& options = {});

/// Frequency over that of the lowest level of its mode, less 1; measured ones without the offset of
/// their mode, unless frequencies were used as they are. @throws InputError  without frequencies.
[[nodiscard]] Figure modal_frequency_figure(const ExperimentResults& results,
                                            const FigureOptions& options = {});

/// Residuals of losses over their scatter. @throws InputError  without them.
[[nodiscard]] Figure loss_residual_figure(const ExperimentResults& results,
                                          const FigureOptions& options = {});

/// Residuals of frequencies over their scatter. @throws InputError  without them.
[[nodiscard]] Figure frequency_residual_figure(const ExperimentResults& results,
                                               const FigureOptions& options = {});

/// Displacement of each joint over that at the response point, a panel per joint.
/// @throws InputError  without a joint.
[[nodiscard]] FigureGrid joint_amplitudes_figure(const ExperimentResults& results,
                                                 const FigureOptions& options = {});

/// Share of each joint in the loss of all, a panel per joint. @throws InputError  without a joint.
[[nodiscard]] FigureGrid loss_shares_figure(const ExperimentResults& results,
                                            const FigureOptions& options = {});

/// For paper: losses and their error, or the damping ratio where the losses were not measured.
[[nodiscard]] FigureGrid modal_losses_figure(const ExperimentResults& results,
                                             const FigureOptions& options);

/// For paper: both residuals, or the existing one.
[[nodiscard]] FigureGrid modal_residuals_figure(const ExperimentResults& results,
                                                const FigureOptions& options);

/// Draws of a joint as thin lines, with their mean and band.
[[nodiscard]] Figure draws_figure(const JointSamples& samples, const FigureOptions& options = {});

// Whether the results have the data of these figures.
[[nodiscard]] bool has_variance_reduction(const ExperimentResults& results);
[[nodiscard]] bool has_modal_losses(const ExperimentResults& results);
[[nodiscard]] bool has_modal_damping(const ExperimentResults& results);
[[nodiscard]] bool has_modal_frequencies(const ExperimentResults& results);
[[nodiscard]] bool has_modal_residuals(const ExperimentResults& results);
[[nodiscard]] bool has_joint_amplitudes(const ExperimentResults& results);
[[nodiscard]] bool has_loss_shares(const ExperimentResults& results);

}  // namespace microslip
