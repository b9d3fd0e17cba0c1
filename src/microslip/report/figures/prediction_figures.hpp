// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/report/document/figure_options.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/workflow/results/result_input.hpp"

/// @file
/// Predictions of a model as figures. All values are SI. Where draws were taken, the band of a
/// curve lies behind it.

namespace microslip {

/// Displacement, or displacement over force where the force varies, and phase over the frequency,
/// one below the other. @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid response_figure(const PredictedResponse& response);

/// Maximax, positive and negative shock response spectrum over the natural frequency.
/// @throws InputError  without points, or where lengths differ.
[[nodiscard]] Figure spectrum_figure(const ShockSpectrum& spectrum);

/// Frequency and damping ratio over the amplitude, side by side.
/// @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid backbone_figure(const PredictedBackbone& backbone,
                                         const FigureOptions& options = {});

/// D, k_eq and loss factor over the amplitude, side by side.
/// @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid joint_figures(const DissipationCurve& curve,
                                       const FigureOptions& options = {});

/// The signals over time, those of one quantity and unit on one pair of axes, below each other; in
/// two columns where there are four quantities or more. A line of more points than paper can show
/// is drawn by the lowest and highest of each 1/2000 of its length.
/// @throws InputError  without signals, or where lengths differ.
[[nodiscard]] FigureGrid histories_figure(std::span<const HistorySignal> signals);

/// Whether an output of an ensemble is a curve, not some numbers.
[[nodiscard]] bool is_curve(const EnsembleCurve& curve);

/// The outputs of an ensemble that are curves, each with its band, in three columns.
/// @throws InputError  without one.
[[nodiscard]] FigureGrid ensemble_figure(std::span<const EnsembleCurve> curves);

/// Force over displacement along a path. @throws InputError  without points, or where lengths
/// differ.
[[nodiscard]] Figure path_figure(const std::vector<double>& displacement,
                                 const std::vector<double>& force, const CurveBand& band = {});

}  // namespace microslip
