// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/report/figure.hpp"
#include "microslip/report/gnuplot.hpp"
#include "microslip/rig/verification.hpp"
#include "microslip/workflow/experiment_results.hpp"

namespace microslip {

/// A row of panels for each of at most three records, of the lowest, a middle and the highest
/// level: force and acceleration over the histories, recorded and predicted, and the harmonics of
/// the acceleration, that at the exciter or of the first accelerometer, over the first one
/// recorded. [AR14 Fig. 11]
/// @param records  one at least, of one rig, with histories.
/// @param unit     in which the level of a record is told: "m/s²", "g".
/// @throws InputError  for a unit that is none of acceleration.
[[nodiscard]] FigureGrid verification_figure(std::span<const Verification> records,
                                             const std::string& unit = "m/s²");

/// The same of what files hold: force and the first acceleration over the histories and, where they
/// are known, the harmonics of the latter. Titles tell the level, subtitles the NRMSE, where it is
/// known.
/// @throws InputError  where there are no histories.
[[nodiscard]] FigureGrid verification_figure(const ExperimentResults& results);

/// That the panels are readable.
[[nodiscard]] PictureSize verification_size(const FigureGrid& figure);

}  // namespace microslip
