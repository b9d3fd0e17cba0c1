// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/figure_options.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The levels of a test and their joint over the amplitude. Each figure is the same on
/// paper and on the page of a report; units have the prefix that suits the values.

namespace microslip {

/// Input energy, linear loss and dissipation of the joint over its amplitude, with bars of one
/// standard deviation, and D by the joints. [AR14 Fig. 8]
/// @throws InputError  without levels.
[[nodiscard]] Figure energies_figure(const ExperimentResults& results,
                                     const FigureOptions& options = {});

/// W_lin/W_ext, the share of the linear loss in the input energy. [AR14 Fig. 8]
/// @throws InputError  without levels that have both energies.
[[nodiscard]] Figure linear_share_figure(const ExperimentResults& results,
                                         const FigureOptions& options = {});

/// D over the amplitude, with that of the joint. @throws InputError  without a joint.
[[nodiscard]] Figure dissipation_figure(const ExperimentResults& results,
                                        const FigureOptions& options = {});

/// k_eq over the amplitude. @throws InputError  with neither a joint nor levels that have it.
[[nodiscard]] Figure stiffness_figure(const ExperimentResults& results,
                                      const FigureOptions& options = {});

/// The loss factor D/(π k_eq A²) of the joint over its amplitude; of levels that have a damping
/// ratio but no k_eq, that ratio.
/// @throws InputError  with neither a joint nor such levels.
[[nodiscard]] Figure damping_figure(const ExperimentResults& results,
                                    const FigureOptions& options = {});

/// D, k_eq and loss factor of the joints over the amplitude, with the levels if present.
/// @throws InputError  without a joint.
[[nodiscard]] FigureGrid joint_figures(const ExperimentResults& results,
                                       const FigureOptions& options = {});

/// The axis that the frequency of the levels is drawn over.
enum class FrequencyOver {
  kResponse,   ///< at the exciter; the amplitude of the joint where that is not known
  kAmplitude,  ///< of the joint, with what the joint predicts where the rig is known
};

/// The frequency of the drive and of the resonance. [AR14 Fig. 6]
/// @throws InputError  without levels that have frequencies, and for a unit that is none of
///                     acceleration.
[[nodiscard]] Figure resonance_figure(const ExperimentResults& results,
                                      const FigureOptions& options = {},
                                      FrequencyOver over = FrequencyOver::kResponse);

}  // namespace microslip
