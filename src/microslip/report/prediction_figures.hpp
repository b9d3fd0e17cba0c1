// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/report/figure.hpp"
#include "microslip/report/paper_figures.hpp"

/// @file
/// What a model predicts, as figures for papers (report/paper_figures). All values are SI.

namespace microslip {

/// Steady vibrations over frequency; one length.
struct PredictedResponse {
  std::vector<double> frequency;     ///< Hz, in the order of the curve
  std::vector<double> force;         ///< amplitude, N; > 0
  std::vector<double> displacement;  ///< amplitude of the first harmonic, m
  std::vector<double> phase;         ///< lag behind the force, rad
};

/// Displacement, or displacement over force where the force varies, and phase over the frequency,
/// one below the other. @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid paper_response(const PredictedResponse& response);

/// Vibrations in phase resonance; one length.
struct PredictedBackbone {
  std::vector<double> displacement;   ///< amplitude, m
  std::vector<double> frequency;      ///< Hz
  std::vector<double> damping_ratio;  ///< 1
};

/// Frequency and damping ratio over the amplitude, side by side.
/// @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid paper_backbone(const PredictedBackbone& backbone,
                                        const PaperOptions& options = {});

/// Dissipation, secant stiffness and loss factor of a joint; one length.
struct DissipationCurve {
  std::vector<double> amplitude;         ///< m
  std::vector<double> dissipation;       ///< J
  std::vector<double> secant_stiffness;  ///< N/m
  std::vector<double> loss_factor;       ///< 1
};

/// D, k_eq and loss factor over the amplitude, side by side.
/// @throws InputError  without points, or where lengths differ.
[[nodiscard]] FigureGrid paper_dissipation(const DissipationCurve& curve,
                                           const PaperOptions& options = {});

/// A signal over time.
struct HistorySignal {
  std::string name;            ///< in the legend
  std::string quantity;        ///< labels the axis: "joint force"; empty for that of the unit
  std::string unit;            ///< SI; "" where it is not known
  std::vector<double> time;    ///< s
  std::vector<double> values;  ///< one a time, in that unit
};

/// The signals over time, those of one quantity and unit on one pair of axes, below each other; in
/// two columns where there are four quantities or more. A line of more points than paper can show
/// is drawn by the lowest and highest of each 1/2000 of its length.
/// @throws InputError  without signals, or where lengths differ.
[[nodiscard]] FigureGrid paper_history(std::span<const HistorySignal> signals);

/// Force over displacement along a path. @throws InputError  without points, or where lengths
/// differ.
[[nodiscard]] Figure paper_path(const std::vector<double>& displacement,
                                const std::vector<double>& force);

}  // namespace microslip
