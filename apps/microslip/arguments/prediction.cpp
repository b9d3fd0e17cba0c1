// SPDX-License-Identifier: MIT
#include "arguments/prediction.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <utility>
#include <vector>

#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/response/response_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostHarmonics = 1000;
constexpr std::uint64_t kMostSamples = 1'000'000;
constexpr double kHighestFrequency = 1e9;  // Hz

}  // namespace

void add_prediction_arguments(CLI::App& command, PredictionArguments& arguments, Call& call,
                              const std::string& columns) {
  command.add_option("model", arguments.model, "Structure with joints, model.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      .add_option("--out", arguments.out,
                  "CSV to write: " + columns +
                      ", energies, amplitude and dissipation of each joint; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command
      .add_option("--harmonics", arguments.harmonics,
                  "H: the motion has harmonics 0 to H. 3 suffice where a joint hardly slips, 9 in "
                  "macro-slip")
      ->capture_default_str();
  command
      .add_option("--samples", arguments.samples,
                  "Samples per cycle for the joint forces, 2H + 2 or more")
      ->capture_default_str();
  command.add_flag("--quiet", call.quiet, "No summary, no progress");
}

HarmonicBalance balance_of(const ModelFile& model, const PredictionArguments& arguments,
                           HarmonicBalanceOptions options, ResponseKind response) {
  options.harmonics = parse_whole_number("--harmonics", arguments.harmonics, 1, kMostHarmonics);
  options.samples = parse_whole_number("--samples", arguments.samples, 4, kMostSamples);
  try {
    return HarmonicBalance(model.structure, {model.response, response}, std::move(options));
  } catch (const InputError& error) {
    const bool option = error.name() == "harmonics" || error.name() == "samples";
    throw error.renamed(option ? "--" + error.name()
                               : fmt::format("{}: {}", input_name(arguments.model), error.name()));
  }
}

double parse_force(std::string_view option, std::string_view text) {
  const double force = parse_quantity(option, text, kForce);
  if (force >= 1e-12 && force <= 1e12) return force;
  throw InputError(option, force, "must be above 0 N: from 1e-12 to 1e12");
}

std::pair<double, double> parse_frequencies(std::string_view option, std::string_view text) {
  const auto [from, to] = parse_ends(option, text, kFrequency);
  for (const auto& [end, value] : {std::pair{"FROM", from}, std::pair{"TO", to}}) {
    const std::string name = fmt::format("{} of {}", end, option);
    if (!(value > 0.0)) throw InputError(name, value, "must be above 0 Hz");
    if (!(value <= kHighestFrequency)) throw InputError(name, value, "must be 1e9 or less");
  }
  return {from, to};
}

std::pair<double, double> parse_displacements(std::string_view option, std::string_view text) {
  const auto [from, to] = parse_interval(option, text, kLength);
  check_displacement(fmt::format("FROM of {}", option), from);
  check_displacement(fmt::format("TO of {}", option), to);
  return {from, to};
}

int tell_ending(const Summary& ended, bool found, const ModelArguments& arguments, const Call& call,
                const std::function<std::string()>& summary) {
  const bool converged = ended.converged();
  if (found && !call.quiet) {
    print_text(arguments.out == "-" ? stderr : stdout, with_option_names(summary()));
  } else if (!converged) {
    print_text(stderr, fmt::format("microslip: {}: not converged: {}; {}\n",
                                   input_name(arguments.model), ended.reason,
                                   found ? "the result so far is written and marked"
                                         : "nothing is written"));
  }
  return converged ? kDone : kNotConverged;
}

int finish(const Summary& ended, bool found, const ModelArguments& arguments, const Call& call,
           const std::function<CsvWriter()>& table, const std::function<std::string()>& summary) {
  if (found) write_file(arguments.out, table().str());
  return tell_ending(ended, found, arguments, call, summary);
}

int finish(const ResponseCurve& curve, const PredictionArguments& arguments, const Call& call,
           const std::function<CsvWriter()>& table, const std::function<std::string()>& summary) {
  return finish(curve.summary, has_rows(curve), arguments, call, table, summary);
}

}  // namespace microslip::app
