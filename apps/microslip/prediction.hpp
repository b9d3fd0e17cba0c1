// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "microslip/io/csv_writer.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/model_file.hpp"

/// @file
/// What `frf` and `backbone` share, and in part `march`: a model, the harmonic balance of it, and
/// what is said of how it went.

namespace microslip::app {

/// A model to read and a table to write.
struct ModelArguments {
  std::string model;
  std::string out;
};

struct PredictionArguments : ModelArguments {
  std::string harmonics = "5";
  std::string samples = "256";
};

/// The model, --harmonics, --samples, --out and --quiet.
/// @param columns  that the file will have, for the help.
void add_prediction_arguments(CLI::App& command, PredictionArguments& arguments, Call& call,
                              const std::string& columns);

/// The harmonic balance of a model file, its response a displacement.
/// @param options  but for harmonics and samples, which the arguments have.
/// @throws InputError  also for harmonics or samples that do not fit.
[[nodiscard]] HarmonicBalance balance_of(const ModelFile& model,
                                         const PredictionArguments& arguments,
                                         HarmonicBalanceOptions options = {});

/// A force on the command line. @throws InputError  where it is none, or one that nothing bears.
[[nodiscard]] double parse_force(std::string_view option, std::string_view text);

/// heading_of() of a prediction, with a line on the linear damping of each joint and on what is to be
/// known of it: that belongs into the file.
[[nodiscard]] std::string heading_of(const Call& call, const ModelFile& model);

/// "4672 J/m^2 beside slip": of a joint that is by itself. Empty where β is 0.
[[nodiscard]] std::string damping_text(double linear_damping);

/// "0.15915, 1.2 Hz": the natural frequencies with all joints stuck.
[[nodiscard]] std::string stuck_frequencies_text(const JointedStructure& structure);

/// The lines of a summary on the model: size and stuck resonances.
[[nodiscard]] std::string describe_model(const std::string& file,
                                         const JointedStructure& structure);

/// Lines of a summary on the linear damping of the joints: as identified, or as the model has it.
[[nodiscard]] std::string describe_damping(const ModelFile& model);

/// Where joints move more than in the levels that they were identified by.
/// @param amplitude  the largest of each joint, m.
[[nodiscard]] std::vector<Warning> reach_warnings(const ModelFile& model,
                                                  const std::vector<double>& amplitude);

/// The same of a curve, and losses that the model seems to hold twice, to its warnings: the table
/// holds them too.
void add_model_warnings(const ModelFile& model, ResponseCurve& curve);

/// Judges what the harmonics above leave out, by judge_truncation(): a warning of the curve where
/// that is much, and a line of the summary.
[[nodiscard]] std::string add_truncation(const HarmonicBalance& balance, Quantity kept,
                                         ResponseCurve& curve);

/// The lines of a summary on warnings.
[[nodiscard]] std::string describe_warnings(const std::vector<Warning>& warnings);

/// The same of a joint by itself that moves by so much.
[[nodiscard]] std::vector<Warning> reach_warnings(const JointFile& file, double amplitude);

/// The line on how it ended, broken where it is long.
[[nodiscard]] std::string describe_ending(const Summary& summary);

/// The lines that both summaries begin with: model, method, how it ended.
[[nodiscard]] std::string describe_curve(const HarmonicBalance& balance, const ResponseCurve& curve,
                                         const PredictionArguments& arguments);

/// Prints the summary, or says on standard error what nothing else would say.
/// @param found    whether something was found, and written.
/// @param summary  composes it; called where there is.
/// @return the exit status.
[[nodiscard]] int tell_ending(const Summary& ended, bool found, const ModelArguments& arguments,
                              const Call& call, const std::function<std::string()>& summary);

/// Writes the table, prints the summary, and says on standard error what nothing else would say.
/// @param found           whether there is something to write.
/// @param table, summary  compose them; called where there is.
/// @return the exit status.
[[nodiscard]] int finish(const Summary& ended, bool found, const ModelArguments& arguments,
                         const Call& call, const std::function<CsvWriter()>& table,
                         const std::function<std::string()>& summary);

/// The same of a curve.
[[nodiscard]] int finish(const ResponseCurve& curve, const PredictionArguments& arguments,
                         const Call& call, const std::function<CsvWriter()>& table,
                         const std::function<std::string()>& summary);

}  // namespace microslip::app
