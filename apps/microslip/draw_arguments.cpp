// SPDX-License-Identifier: MIT
#include "draw_arguments.hpp"

#include <cstdint>
#include <limits>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/workflow/quantity_text.hpp"

namespace microslip::app {

void add_draw_arguments(CLI::App& command, DrawArguments& arguments, const std::string& columns) {
  CLI::Option* draws = command.add_option(
      "--draws", arguments.count,
      "Predict by so many draws of what is uncertain as well, and write between which values they "
      "lie: " +
          columns);
  command.add_option("--seed", arguments.seed, "Of the draws: the same seed, the same draws")
      ->needs(draws)
      ->capture_default_str();
  command
      .add_option("--confidence", arguments.confidence,
                  "Share of the draws that lies between the two, as much below as above")
      ->needs(draws)
      ->capture_default_str();
}

void add_correlation_argument(CLI::App& command, DrawArguments& arguments) {
  command
      .add_option(
          "--correlation", arguments.correlation,
          "Of the draws of several joints: those of the same number together, each joint by "
          "itself, or together where one calibration drew them")
      ->needs(command.get_option("--draws"))
      ->check(CLI::IsMember({"auto", "together", "independent"}))
      ->capture_default_str();
}

DrawOptions draw_options(const DrawArguments& arguments) {
  DrawOptions options;
  options.count = parse_whole_number("--draws", arguments.count, 1, DrawOptions::kMostDraws);
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
  return options;
}

}  // namespace microslip::app
