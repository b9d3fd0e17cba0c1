// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// @file
/// The plan of an ensemble, schema microslip.ensemble/1: any number of jobs of one kind. Files are
/// relative to the folder of the plan.
///
///     schema = "microslip.ensemble/1"
///     kind = "predict"          or "bootstrap", "design", "sweep"; its table has the same name
///     seed = 1                  optional, as all that follow
///     confidence = 0.95         share of the jobs between lower and upper
///     raw = ["peak_frequency"]  outputs whose values of all jobs are kept; "*": all
///     most_failed = 0.1         share of the jobs that may fail
///     block = 16                jobs that are dealt and written at a time
///
///     [predict]    model, draws; optional correlation = "auto" | "together" | "independent"
///     [bootstrap]  levels, stiffness_N_per_m, count; optional resample = "residuals" | "levels",
///                  linear_damping, atom, edges = true | false, points
///     [design]     joint (the truth), count, levels = […] (numbers of them), noise = […] (of D,
///                  relative), amplitude_m = [lowest, highest]; optional spacing = "linear" |
///                  "log", amplitude_noise = […] and secant_noise = […] (relative), linear_damping,
///                  atom, edges, draws (of each identification, for the band). With rig in place of
///                  joint, noise and amplitudes, records of its sensors are reduced: rig, count,
///                  levels; optional sensor_noise = […] (factors of that of the rig), sensors =
///                  [["acc1", "ldv"], …] (channels that are looked at), linear_damping, atom,
///                  edges, draws
///     [sweep]      model
///     [[sweep.axis]]  number = "structure.loss_factor[1]" or, of the file of a joint,
///                  "JOINT: stiffness_N_per_m"; values = […]
///     [[case]]     of predict and sweep: what is predicted; name optional
///       kind = "frf":      force_N, acceleration_m_per_s2 of a base or response_m, frequency_Hz =
///                          [from, to]
///       kind = "backbone": response_m = […], optional mode
///       kind = "march":    force_file; optional step_s
///       optional harmonics, samples of frf and backbone
///
/// A list of values is an array of numbers, or { from, to, count, spacing = "linear" | "log" }.

namespace microslip {

/// A prediction that a plan asks for.
struct PlannedCase {
  /// Kind of prediction.
  enum class Kind { kFrf, kBackbone, kMarch };

  std::string name;                         ///< "case 1" where the plan has none
  Kind kind = Kind::kFrf;                   ///< what it is
  std::optional<double> force = {};         ///< that is kept, N; of a frf
  std::optional<double> acceleration = {};  ///< that is kept, of a base, m/s²; of a frf
  std::optional<double> response = {};      ///< that is kept, m; of a frf
  double from = 0.0;                        ///< of a frf, Hz
  double to = 0.0;                          ///< of a frf, Hz
  std::vector<double> responses = {};       ///< of a backbone, m
  std::size_t mode = 1;                     ///< of a backbone, from 1
  std::string force_file = {};              ///< of a march, as it is opened
  double step = 0.0;                        ///< of a march, s; 0: as march chooses
  std::size_t harmonics = 5;                ///< H
  std::size_t samples = 256;                ///< of a cycle
};

/// Draws of a model through its cases.
struct PredictPlan {
  std::string model;                 ///< path of model.toml, as it is opened
  std::size_t draws = 0;             ///< of each case
  std::string correlation = "auto";  ///< of several joints
};

/// Options of the identification of a job.
struct PlannedIdentification {
  bool linear_damping = false;  ///< β is fitted
  bool atom = false;            ///< an atom is sought
  bool edges = false;           ///< edges are sought
};

/// Levels resampled from those that were measured, and identified.
struct BootstrapPlan {
  std::string levels;                         ///< path of levels.csv, as it is opened
  double stiffness = 0.0;                     ///< k, N/m
  std::size_t count = 0;                      ///< identifications
  bool residuals = true;                      ///< residuals are drawn, not levels
  std::size_t points = 50;                    ///< of the density that is written
  PlannedIdentification identification = {};  ///< options of each
};

/// Virtual tests of a known joint and their identification.
struct DesignPlan {
  std::string joint = {};  ///< path of joint.json, the truth, as it is opened
  std::string rig = {};    ///< path of rig.toml, as it is opened; empty: levels are drawn
  std::size_t count = 0;   ///< tests of each design
  std::vector<std::size_t> levels = {};                ///< numbers of levels
  std::vector<double> sensor_noise = {1.0};            ///< of a rig: factors of its noise
  std::vector<std::vector<std::string>> sensors = {};  ///< of a rig: channels; empty: all
  std::vector<double> noise = {};                      ///< of D, relative standard deviation
  std::vector<double> amplitude_noise = {0.0};         ///< of A, relative
  std::vector<double> secant_noise = {};      ///< of k_eq over k; empty: it is not measured
  double lowest = 0.0;                        ///< amplitude, m
  double highest = 0.0;                       ///< amplitude, m
  bool equal_ratios = false;                  ///< of the amplitudes
  std::size_t draws = 0;                      ///< of each identification; 0: no band
  PlannedIdentification identification = {};  ///< options of each
};

/// A number that is varied.
struct SweepAxis {
  std::string number;          ///< as the plan names it
  std::string joint = {};      ///< the joint in whose file it is; empty: in the model
  std::string path;            ///< of the number in the file: "structure.loss_factor[1]"
  std::vector<double> values;  ///< that it takes
};

/// A model over a grid of numbers.
struct SweepPlan {
  std::string model;            ///< path of model.toml, as it is opened
  std::vector<SweepAxis> axes;  ///< the last runs fastest
};

/// A plan as read.
struct EnsemblePlan {
  std::string file;                       ///< its name, for messages
  std::string text;                       ///< all of it
  std::string kind;                       ///< "predict"…
  std::uint64_t seed = 1;                 ///< of all random numbers
  double confidence = 0.95;               ///< share between lower and upper
  std::vector<std::string> raw = {};      ///< outputs that are kept whole; "*" is all
  double most_failed = 0.1;               ///< share of the jobs
  std::optional<std::size_t> block = {};  ///< jobs in a block; nothing: by their number
  std::variant<PredictPlan, BootstrapPlan, DesignPlan, SweepPlan> work;  ///< of the kind
  std::vector<PlannedCase> cases = {};                                   ///< of predict and sweep
  /// Settings that determine the jobs, "key = value" each: all of the plan but raw, confidence and
  /// most_failed, which can change without a job being done again. The confidence is among them
  /// where a design has draws, of which each job makes a band.
  std::vector<std::string> settings = {};

  static constexpr double kMostJobs = 1e9;  ///< of a plan
};

/// @param text  of the file. @param file  its name; paths are relative to its folder.
/// @throws FormatError  for text that is no TOML, another schema or kind, keys unknown or missing.
/// @throws InputError   naming `plan.toml:12:3: sweep.axis[1].values` for a value that breaks a
///     rule.
[[nodiscard]] EnsemblePlan parse_ensemble_plan(std::string_view text, std::string_view file);

/// parse_ensemble_plan() of a file. @throws FileError, FormatError, InputError
[[nodiscard]] EnsemblePlan read_ensemble_plan(const std::string& path);

}  // namespace microslip
