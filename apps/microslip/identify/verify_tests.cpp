// SPDX-License-Identifier: MIT
#include "identify/verify_tests.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <string_view>

#include "arguments/option_names.hpp"
#include "arguments/picture_argument.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/report/figures/comparison_figure.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

std::optional<TestKind> test_kind(const std::string& name) {
  for (const TestKind kind :
       {TestKind::kSweep, TestKind::kConstantResponse, TestKind::kRingDown, TestKind::kLoops}) {
    if (name == to_string(kind)) return kind;
  }
  return std::nullopt;
}

TestsVerification verification_of(const TestsCall& options, bool quiet) {
  const TestArguments& arguments = options.arguments;
  TestsVerification all{.model = options.model, .tests = options.tests, .joint = arguments.joint};
  all.reading = {.kind = test_kind(arguments.kind),
                 .sensors = arguments.sensors,
                 .modes = arguments.modes,
                 .channels = {.force = arguments.force, .displacement = arguments.displacement},
                 .reading = read_options(options.reading)};
  all.harmonics = options.harmonics;
  if (options.drawn.any()) {
    all.draws = draw_options(options.drawn);
    all.uncertain = uncertainty_of(options.drawn);
    all.progress = progress_bar("draws", quiet);
  }
  return all;
}

void write_tests(const TestsCall& options, const VerifiedTests& verified) {
  OutputFiles outputs;
  outputs.add(options.out, comparison_table(verified));
  if (!options.picture.empty()) {
    const FigureGrid figure = comparison_figure(verified.tests);
    outputs.add(options.picture, draw(figure, picture_format("--picture", options.picture),
                                      comparison_size(figure)));
  }
  outputs.commit();
}

}  // namespace

void add_test_arguments(CLI::App& command, TestArguments& arguments) {
  command
      .add_option(
          "--kind", arguments.kind,
          "Kind of the tests of a model; default: detected from the files. sweep: response at the "
          "force measured at each step; constant-response: force at the response; ringdown: "
          "frequency and damping over amplitude; loops: force and losses of a joint along its path")
      ->check(CLI::IsMember({"sweep", "constant-response", "ringdown", "loops"}));
  command
      .add_option("--sensor", arguments.sensors,
                  "CHANNEL=POINT, for ring-downs: the sensor of a channel is at that point of the "
                  "model; may be repeated; replaces [[accelerometer]] of model.toml")
      ->allow_extra_args(false);
  command
      .add_option("--mode", arguments.modes,
                  "Mode of ring-downs, from 1; may be repeated; default: all that can be tracked")
      ->check(CLI::Range(1, 100000))
      ->allow_extra_args(false);
  command.add_option("--force", arguments.force,
                     "Channel of the force of loops; not needed if there is only one");
  command.add_option("--displacement", arguments.displacement,
                     "Channel of the displacement of loops; not needed if there is only one");
  command.add_option("--joint", arguments.joint,
                     "Joint of the model that the loops are of; not needed if there is only one");
}

int run_of_tests(const TestsCall& options, const Call& call) {
  std::vector<PlannedOutput> planned{{options.out, kComparisonKind}};
  if (!options.picture.empty()) {
    planned.push_back({options.picture, kind_of(picture_format("--picture", options.picture))});
  }
  check_outputs(planned);
  const VerifiedTests verified =
      verify_tests(verification_of(options, call.quiet), call.command_line);
  write_tests(options, verified);
  if (!call.quiet) {
    print_text(options.out == "-" ? stderr : stdout, with_option_names(describe_tests(verified)));
  }
  return verified.converged() ? kDone : kNotConverged;
}

}  // namespace microslip::app
