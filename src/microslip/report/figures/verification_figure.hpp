// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/figure_options.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {

/// A row of panels for each of at most three records, of the lowest, a middle and the highest
/// level: force and the first acceleration over the histories, recorded and predicted, and, where
/// they are known, the harmonics of the acceleration over the first one recorded. Titles give the
/// level, subtitles the NRMSE and that of the noise alone, where they are known, and the record.
/// [AR14 Fig. 11]
/// @param results  with predictions: of a folder, or by add_verified().
/// @param options  the unit of the response.
/// @throws InputError  where there are no histories, and for a unit that is none of acceleration.
[[nodiscard]] FigureGrid verification_figure(const ExperimentResults& results,
                                             const FigureOptions& options = {});

/// Size of the picture at which the panels are readable.
[[nodiscard]] PictureSize verification_size(const FigureGrid& figure);

}  // namespace microslip
