// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/joint/joint.hpp"
#include "microslip/report/figure.hpp"
#include "microslip/report/identification_figures.hpp"
#include "microslip/workflow/experiment_results.hpp"

/// @file
/// What a test left behind, as figures for papers (report/paper_picture): without titles, which are
/// in the caption there; units have the prefix that suits the values.

namespace microslip {

/// Of the axis of an amplitude, and of energies over it.
enum class AmplitudeScale { kAsSuits, kLinear, kLog };

/// What the figures of a test leave to choose.
struct PaperOptions {
  AmplitudeScale scale = AmplitudeScale::kAsSuits;  ///< of the axis of an amplitude
  std::vector<NamedJoint> others = {};              ///< drawn beside the joint of the results
};

/// Input energy, linear loss and dissipation of the joint over its amplitude, with bars of one
/// standard deviation; what the joints make of it. [AR14 Fig. 8]
/// @throws InputError  without levels.
[[nodiscard]] Figure paper_energies(const ExperimentResults& results,
                                    const PaperOptions& options = {});

/// The density with its band; with the truth where it is known. [AR14 Fig. 9]
/// @throws InputError  without a joint.
[[nodiscard]] Figure paper_density(const ExperimentResults& results,
                                   const PaperOptions& options = {});

/// The same of a density at points.
[[nodiscard]] Figure paper_density(const DensityCurve& curve, const PaperOptions& options = {});

/// Steady loops at four amplitudes up to the highest level, or up to where all that can slip does.
/// [AR14 Fig. 10]
/// @throws InputError  without a joint.
[[nodiscard]] Figure paper_loops(const ExperimentResults& results,
                                 const PaperOptions& options = {});

/// The frequency of the drive and of the resonance over the response at the exciter or, where that
/// is not known, over the amplitude of the joint. [AR14 Fig. 6]
/// @throws InputError  without levels that have frequencies.
[[nodiscard]] Figure paper_resonance(const ExperimentResults& results,
                                     const PaperOptions& options = {});

/// k_eq over the amplitude. @throws InputError  with neither a joint nor levels that have it.
[[nodiscard]] Figure paper_stiffness(const ExperimentResults& results,
                                     const PaperOptions& options = {});

/// The loss factor D/(π k_eq A²) of the joint over its amplitude; of levels that have a damping
/// ratio but no k_eq, that ratio.
/// @throws InputError  with neither a joint nor such levels.
[[nodiscard]] Figure paper_damping(const ExperimentResults& results,
                                   const PaperOptions& options = {});

/// D, k_eq and loss factor of the joints over the amplitude, with the levels where there are some.
/// @throws InputError  without a joint.
[[nodiscard]] FigureGrid paper_dissipation(const ExperimentResults& results,
                                           const PaperOptions& options = {});

/// Force over frequency that holds the response, as acceleration over force. [AR14 Fig. 4]
/// @throws InputError  without responses.
[[nodiscard]] Figure paper_constant_response(const ExperimentResults& results);

/// NRMSE and noise of each channel, a panel each, over the response. @throws InputError  without
/// comparisons.
[[nodiscard]] FigureGrid paper_deviations(const ExperimentResults& results,
                                          const PaperOptions& options = {});

}  // namespace microslip
