// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/io/path_file.hpp"
#include "microslip/report/prediction_figures.hpp"
#include "microslip/workflow/experiment_results.hpp"

namespace microslip::app {

/// What a folder or a file has to draw.
struct PlotInput {
  std::string name;          ///< of the folder or file, for messages
  std::string instead = {};  ///< what to name where it holds no figure, a sentence
  ExperimentResults test = {};
  std::optional<DensityCurve> density = {};  ///< of a density.csv without a joint
  std::optional<PredictedResponse> response = {};
  std::optional<PredictedBackbone> backbone = {};
  std::optional<DissipationCurve> dissipation = {};
  std::optional<DisplacementPath> path = {};
  std::vector<double> path_force = {};  ///< N, one a point of the path
  std::vector<HistorySignal> history = {};
  std::size_t left_out = 0;  ///< channels beyond those that a figure holds
};

/// @param path  a folder as read_experiment() takes it, a table or model of this program, a
///              recording, or "-" for a table or model on standard input.
/// @throws FileError, FormatError, InputError  as the readers of these.
[[nodiscard]] PlotInput read_plot_input(const std::string& path);

/// Keeps the history between two times, s. @throws InputError  naming --time where hardly any is
/// left.
void cut_history(PlotInput& input, double from, double to);

}  // namespace microslip::app
