// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/levels/path_file.hpp"
#include "microslip/workflow/compare/comparison.hpp"
#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/predicted_curves.hpp"

namespace microslip {

/// A density at points; one length.
struct DensityCurve {
  std::vector<double> slip_force;            ///< f*, N
  std::vector<double> density;               ///< φ, 1/N
  std::vector<double> lower = {};            ///< 1/N; empty where there is no band
  std::vector<double> upper = {};            ///< 1/N; as many as of `lower`
  double confidence = 0.95;                  ///< of the band, 1
  std::vector<double> band_slip_force = {};  ///< of the band, N; empty where it is `slip_force`
  std::optional<double> covered_from = {};   ///< kA of the lowest level, N
  std::optional<double> covered_to = {};     ///< kA of the highest level, N
  std::vector<double> atom_slip_force = {};  ///< N; marked
  std::string name = "identified";           ///< in the legend
  bool of_records = false;                   ///< covered by records, not by levels
};

/// Results in a folder or a file.
struct ResultInput {
  std::string name;                          ///< of the folder or file, for messages
  std::string instead = {};                  ///< what to name where it holds no figure, a sentence
  ExperimentResults test = {};               ///< of a folder, or what a file of one holds
  std::optional<DensityCurve> density = {};  ///< of a density.csv without a joint
  std::optional<PredictedResponse> response = {};    ///< of a CSV of frf
  std::optional<PredictedBackbone> backbone = {};    ///< of a CSV of backbone
  std::optional<ShockSpectrum> spectrum = {};        ///< of a CSV of spectrum
  std::optional<DissipationCurve> dissipation = {};  ///< of a CSV of dissipation
  std::optional<DisplacementPath> path = {};         ///< of a CSV of loop
  std::vector<double> path_force = {};               ///< N, one per point of the path
  CurveBand path_band = {};                          ///< of the force, N
  std::vector<EnsembleCurve> ensemble = {};          ///< of a CSV of ensemble
  std::vector<ComparedTest> compared = {};           ///< of a CSV of verify, of tests of a model
  std::optional<JointSamples> samples = {};          ///< of joint_samples.h5
  std::vector<HistorySignal> history = {};           ///< of a CSV of march, or a recording
  std::size_t left_out = 0;                          ///< channels beyond those that a figure holds
  std::string no_record = {};  ///< why a record of a joint is not there, a sentence
};

/// @param path  a folder as read_experiment() takes it, a table or model of this program, a
///              recording, or "-" for a table or model on standard input.
/// @param record  which of the records, from 1, that a joint was identified from.
/// @throws FileError, FormatError, InputError  as the readers of these; where the joint has fewer
///         records.
[[nodiscard]] ResultInput read_result(const std::string& path, std::size_t record = 1);

/// Several joints, for the figure of their densities. Each is called by the name of its file, or by
/// its path where two have one name.
/// @param paths  of joint.json; two or more.
/// @throws FileError, FormatError, InputError  as read_joint(), for a file that is no joint.
[[nodiscard]] ResultInput read_joints(const std::vector<std::string>& paths);

/// Keeps the history, or the record of a joint, between two times.
/// @param input  with one of them.
/// @param from   s.
/// @param to     s.
/// @throws InputError  naming --time where hardly any is
/// left.
void cut_history(ResultInput& input, double from, double to);

}  // namespace microslip
