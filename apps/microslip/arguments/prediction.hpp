// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// Declarations common to `frf` and `backbone`, in part also `march`: a model, its harmonic
/// balance, and messages on the outcome.

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

/// The harmonic balance of a model file.
/// @param response  its kind.
/// @param options  but for harmonics and samples, which the arguments have.
/// @throws InputError  also for harmonics or samples that do not fit.
[[nodiscard]] HarmonicBalance balance_of(const ModelFile& model,
                                         const PredictionArguments& arguments,
                                         HarmonicBalanceOptions options = {},
                                         ResponseKind response = ResponseKind::kDisplacement);

/// A force on the command line. @throws InputError  if invalid or out of range.
[[nodiscard]] double parse_force(std::string_view option, std::string_view text);

/// FROM:TO of frequencies on the command line, in either order, Hz. @throws InputError  if invalid.
[[nodiscard]] std::pair<double, double> parse_frequencies(std::string_view option,
                                                          std::string_view text);

/// FROM:TO of displacements on the command line, the lower first, m. @throws InputError  if
/// invalid.
[[nodiscard]] std::pair<double, double> parse_displacements(std::string_view option,
                                                            std::string_view text);

/// Prints the summary, or reports on standard error what nothing else reports.
/// @param found    whether something was found, and written.
/// @param summary  composes it; called where there is.
/// @return the exit status.
[[nodiscard]] int tell_ending(const Summary& ended, bool found, const ModelArguments& arguments,
                              const Call& call, const std::function<std::string()>& summary);

/// Writes the table, prints the summary, and reports on standard error what nothing else reports.
/// @param found           whether there is something to write.
/// @param table, summary  compose them; called where there is.
/// @return the exit status.
[[nodiscard]] int finish(const Summary& ended, bool found, const ModelArguments& arguments,
                         const Call& call, const std::function<CsvWriter()>& table,
                         const std::function<std::string()>& summary);

/// Writes and summarises a curve, as above.
[[nodiscard]] int finish(const ResponseCurve& curve, const PredictionArguments& arguments,
                         const Call& call, const std::function<CsvWriter()>& table,
                         const std::function<std::string()>& summary);

}  // namespace microslip::app
