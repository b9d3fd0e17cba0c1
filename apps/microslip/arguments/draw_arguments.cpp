// SPDX-License-Identifier: MIT
#include "arguments/draw_arguments.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

/// None would be a prediction without draws.
void refuse_empty(const std::string& text) {
  if (text.empty()) {
    throw InputError("--draws", in_quotes(text), "must be a whole number in digits",
                     "Leave it out for a prediction without draws.");
  }
}

void add_seed_argument(CLI::App& command, DrawArguments& arguments) {
  command
      .add_option("--seed", arguments.seed, "Seed of the draws; the same seed gives the same draws")
      ->needs(command.get_option("--draws"))
      ->capture_default_str();
}

void add_uncertainty_arguments(CLI::App& command, JointDrawArguments& arguments) {
  CLI::Option* draws = command.get_option("--draws");
  command
      .add_option("--samples", arguments.samples,
                  "Posterior draws of the joint, joint_samples.h5, from identify --samples-out or "
                  "calibrate")
      ->needs(draws)
      ->type_name(kHdf5Value);
  command
      .add_option("--normal-load-std", arguments.normal_load_std,
                  "Relative standard deviation of the normal load, which scales all slip forces "
                  "but not k: 0.1 or 10%")
      ->needs(draws)
      ->capture_default_str();
}

}  // namespace

void add_draw_arguments(CLI::App& command, DrawArguments& arguments, const std::string& columns) {
  CLI::Option* draws = command.add_option(
      "--draws", arguments.count,
      "Propagate this many posterior draws of the uncertain parameters and write their band: " +
          columns);
  draws->each(refuse_empty);
  add_seed_argument(command, arguments);
  command
      .add_option("--confidence", arguments.confidence,
                  "Probability of the band, with equal tails below and above")
      ->needs(draws)
      ->capture_default_str();
}

void add_correlation_argument(CLI::App& command, DrawArguments& arguments) {
  command
      .add_option("--correlation", arguments.correlation,
                  "How draws of several joints are combined: by their number, independently of "
                  "each other, or (auto) by number where one calibration drew them")
      ->needs(command.get_option("--draws"))
      ->check(CLI::IsMember({"auto", "together", "independent"}))
      ->capture_default_str();
}

void add_joint_draw_arguments(CLI::App& command, JointDrawArguments& arguments,
                              const std::string& columns) {
  add_draw_arguments(command, arguments, columns);
  add_uncertainty_arguments(command, arguments);
}

void add_single_draw_arguments(CLI::App& command, JointDrawArguments& arguments,
                               const std::string& words) {
  command.add_option("--draws", arguments.count, words)->each(refuse_empty);
  add_seed_argument(command, arguments);
  add_uncertainty_arguments(command, arguments);
}

double parse_spread(std::string_view option, const std::string& text) {
  const double spread = parse_quantity(option, text, kDimensionless);
  if (spread >= 0.0 && spread <= DrawnJoints::kLargestSpread) return spread;
  throw InputError(option, spread,
                   fmt::format("must be from 0 to {:g}", DrawnJoints::kLargestSpread),
                   "It is relative: 0.1 or 10%.");
}

JointUncertainty uncertainty_of(const JointDrawArguments& arguments) {
  return {arguments.samples, parse_spread("--normal-load-std", arguments.normal_load_std)};
}

std::optional<LoneJointDraws> draws_of(const JointFile& file, const JointDrawArguments& arguments,
                                       bool quiet) {
  if (!arguments.any()) return std::nullopt;
  LoneJointDraws draws =
      microslip::draws_of(file, uncertainty_of(arguments), draw_options(arguments));
  draws.progress = progress_bar("draws", quiet);
  return draws;
}

DrawOptions draw_options(const DrawArguments& arguments) {
  DrawOptions options{.count = DrawOptions::kMostDraws};  // until the confidence is known
  options.seed =
      parse_whole_number("--seed", arguments.seed, 0, std::numeric_limits<std::uint64_t>::max());
  options.confidence = parse_quantity("--confidence", arguments.confidence, kDimensionless);
  if (arguments.correlation == "together") options.correlation = Correlation::kTogether;
  if (arguments.correlation == "independent") options.correlation = Correlation::kIndependent;
  try {
    options.check();
  } catch (const InputError& error) {
    throw error.renamed("--" + error.name());
  }
  options.count = parse_whole_number(
      "--draws", arguments.count, DrawOptions::fewest(options.confidence), DrawOptions::kMostDraws,
      fmt::format("With fewer, no draw lies beyond the edges of a band of {:g} %; 1000 give its "
                  "edges to about 5 % of its width. Leave it out for a prediction without bands.",
                  100.0 * options.confidence));
  return options;
}

}  // namespace microslip::app
