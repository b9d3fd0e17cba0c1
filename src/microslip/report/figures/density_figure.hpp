// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/figure_options.hpp"
#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/result_input.hpp"

namespace microslip {

/// The density over the slip forces that the levels cover, with its band: below them the shape is
/// an assumption. Marks where they begin and end, and where atoms are, which no density shows; with
/// the truth where it is known. Of a joint of atoms alone, the share of k that slips up to a force.
/// [AR14 Fig. 9]
/// @throws InputError  without a joint, or where no part of it slips.
[[nodiscard]] Figure density_figure(const ExperimentResults& results,
                                    const FigureOptions& options = {});

/// Figure of a density that is given at points, as above.
[[nodiscard]] Figure density_figure(const DensityCurve& curve, const FigureOptions& options = {});

}  // namespace microslip
