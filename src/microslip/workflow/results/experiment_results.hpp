// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/identified_joint.hpp"
#include "microslip/documents/study/calibration_summary.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/workflow/identify/calibration_results.hpp"
#include "microslip/workflow/reduce/measured_levels.hpp"
#include "microslip/workflow/results/comparison_results.hpp"
#include "microslip/workflow/results/predicted_curves.hpp"

/// @file
/// Results of a test and of its evaluation. All values are SI.

namespace microslip {

/// A record of force and displacement, and what the joint makes of its path. Vectors of one length.
struct ForcePath {
  std::size_t record = 0;                 ///< of FoundByRecords::records
  std::string source = {};                ///< its file, with the recording where it holds several
  std::vector<double> time = {};          ///< s
  std::vector<double> displacement = {};  ///< as recorded, m
  std::vector<double> path = {};          ///< without its noise, m
  std::vector<double> force = {};         ///< as recorded, N
  std::vector<double> found = {};         ///< of the joint with the offset, N; NaN where not known
  double displacement_noise = 0.0;        ///< standard deviation of a sample, m
  std::size_t reversals = 0;              ///< of the path
};

/// A signal over some cycles.
struct SignalPair {
  std::string name;              ///< its channel
  std::string unit;              ///< SI
  std::vector<double> time;      ///< s
  std::vector<double> recorded;  ///< one a time
  // Predicted, or before force control; empty where there is none.
  std::vector<double> other_time;  ///< s
  std::vector<double> other;       ///< one a time
};

/// The harmonics of a signal, from the first.
struct HarmonicsPair {
  std::string name;              ///< its channel
  std::string unit;              ///< SI
  std::vector<double> recorded;  ///< amplitudes
  std::vector<double> other;     ///< empty, or as many
  /// Of real and imaginary part; empty where it is not known.
  std::vector<double> recorded_std = {};
};

/// History of the force control at a level. [AR14 Fig. 7]
struct ForceControlLevel {
  std::string level;      ///< its name or number
  double response = 0.0;  ///< acceleration amplitude at the exciter, m/s²
  // Harmonics of the force from the second, over the first, 1; one length.
  std::vector<double> before;  ///< without force control
  std::vector<double> after;   ///< with it
};

/// Recordings of a level.
struct LevelRecord {
  std::string source;                    ///< its file
  std::vector<SignalPair> signals;       ///< over some cycles
  std::vector<HarmonicsPair> harmonics;  ///< of the signals
};

/// Force over frequency that holds the response. [AR14 Fig. 4]
struct ConstantResponse {
  double response = 0.0;          ///< acceleration amplitude at the exciter, m/s²
  std::vector<double> frequency;  ///< Hz
  std::vector<double> force;      ///< amplitude of the first harmonic, N; one per frequency
  /// The same by the true joint of a virtual test, Hz; empty where there is none.
  std::vector<double> true_frequency = {};
  std::vector<double> true_force = {};  ///< N; one a true frequency
};

/// Phase resonance over the amplitude of the joint. Vectors of one length.
struct JointBackbone {
  std::vector<double> amplitude;      ///< A, m; rising
  std::vector<double> frequency;      ///< Hz
  std::vector<double> damping_ratio;  ///< of the structure with its joint, 1
  /// W/(4πζ) with W the energy that a cycle loses, J: with it ζ follows from a measured W.
  std::vector<double> vibration_energy = {};
};

/// How far the prediction of a channel is from its record.
struct ChannelMisfit {
  std::string source = {};          ///< its file
  std::string channel = {};         ///< of the record
  std::string status = {};          ///< "converged"
  double frequency = 0.0;           ///< Hz
  double response_amplitude = 0.0;  ///< m/s²
  double nrmse = 0.0;               ///< 1
  double noise_share = 0.0;         ///< 1
  double amplitude_ratio = 0.0;     ///< predicted over recorded, 1
  double phase_error = 0.0;         ///< rad
  std::string flags = {};           ///< with blanks between them
};

/// A file that the report is made from.
struct SourceFile {
  std::string name;     ///< relative to the folder of the test
  std::string sha256;   ///< of its content, hexadecimal
  std::string made_by;  ///< command, where the file tells
};

/// All results; sections without data name the command that makes them.
struct ExperimentResults {
  std::string title = {};                     ///< of the report
  std::string subtitle = {};                  ///< below it
  std::optional<Rig> rig = {};                ///< that was tested
  std::optional<MeasuredLevels> levels = {};  ///< as measured
  std::optional<IdentifiedJoint> joint = {};  ///< as identified
  /// Options of the identification of the joint, as far as its file gives them; stiffness and bands
  /// are not used.
  IdentificationOptions options = {};
  std::optional<Joint> truth = {};                 ///< of a virtual test
  double true_linear_damping = 0.0;                ///< β of the truth, J/m²
  std::optional<MeasuredLevels> true_levels = {};  ///< of a virtual test, without errors
  /// The other: before force control. Some may have harmonics alone.
  std::vector<LevelRecord> records = {};
  std::size_t record_count = 0;  ///< of the test that can be read; `records` are some
  std::vector<ForceControlLevel> force_control = {};   ///< one per level that was controlled
  std::vector<ConstantResponse> responses = {};        ///< predicted by the joint
  std::optional<JointBackbone> backbone = {};          ///< predicted by the joint
  std::optional<JointBackbone> true_backbone = {};     ///< of a virtual test
  std::vector<ChannelMisfit> comparisons = {};         ///< one per channel and record
  std::vector<LevelRecord> predictions = {};           ///< recorded, and predicted as the other
  PredictedCurves curves = {};                         ///< of a model, by frf and others
  std::optional<ComparisonFound> comparison = {};      ///< tests against a model
  std::optional<CampaignFound> campaign = {};          ///< several tests of one structure
  std::optional<LevelsOfModes> modal_levels = {};      ///< of several joints, or as measured alone
  std::vector<DensityFound> densities = {};            ///< of several joints
  std::optional<CalibrationSummary> calibration = {};  ///< of several joints
  std::vector<ForcePath> force_paths = {};  ///< records that the joint was identified from, or some
  /// Whether comparisons and predictions are those of the joint and the rig of the results.
  bool predictions_are_of_this_joint = true;
  std::vector<SourceFile> files = {};  ///< that were read
  /// names and values, for the last section
  std::vector<std::pair<std::string, std::string>> provenance = {};
  std::vector<Warning> warnings = {};  ///< of reading the files

  /// Whether a report has nothing to show beside what was given of the rig or the truth.
  [[nodiscard]] bool is_empty() const {
    return !levels && !joint && !calibration && !modal_levels && densities.empty() &&
           records.empty() && comparisons.empty() && predictions.empty() && force_control.empty() &&
           !comparison && !campaign;
  }
};

/// @throws InputError  where vectors that belong together differ in length.
void check_results(const ExperimentResults& results);

/// The last part of a path.
[[nodiscard]] std::string_view file_name(std::string_view path);

}  // namespace microslip
