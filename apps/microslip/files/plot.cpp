// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/picture_argument.hpp"
#include "arguments/plot_arguments.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

int run(const PlotArguments& options, const Call& call) {
  const PictureFormat format = format_of(options);
  if (!options.out.empty()) check_output(options.out, kind_of(format));
  ResultInput input = options.in.size() == 1
                          ? read_result(options.in.front(), options.record.value_or(1))
                          : read_joints(options.in);
  const NamedFigure& figure = find_figure(
      options.figure.empty() && options.in.size() > 1 ? "densities" : options.figure, input);
  if (!options.time.empty()) {
    if (input.history.empty() && !figure.of_record) {
      throw InputError("--time", in_quotes(options.time),
                       fmt::format("cuts a history or a record, and {} is none", figure.name),
                       "Leave it out.");
    }
    const auto [from, to] = parse_interval("--time", options.time, kTime);
    cut_history(input, from, to);
  }
  const std::string out =
      options.out.empty() ? fmt::format("{}.{}", figure.name, ending_of(format)) : options.out;
  check_output(out, kind_of(format));

  const PaperPicture picture =
      draw_named(figure, input, figure_options(options, figure, input), format,
                 {.width_mm = options.width_mm, .grey = options.grey});
  write_file(out, picture.bytes);
  if (!call.quiet && out != "-") {
    print_text(stdout, fmt::format("{}: {}, {:.0f} mm wide, {:.0f} mm high\n", out, figure.name,
                                   picture.width_mm, picture.height_mm));
    if (input.left_out > 0) {
      print_text(
          stdout,
          fmt::format(
              "{} further channels are not drawn: a figure shows at most eight of a quantity\n",
              input.left_out));
    }
  }
  return kDone;
}

}  // namespace

void add_plot(CLI::App& program, Call& call) {
  auto options = std::make_shared<PlotArguments>();
  CLI::App* command = program.add_subcommand(
      "plot", "Draw a figure for a paper, of a test folder or of one result");
  add_plot_arguments(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip plot test --figure energies --format pdf",
                          "microslip plot joint.json --figure loops --grey --out loops.pdf",
                          "microslip plot joint.json --figure force --time 2:3 --format pdf",
                          "microslip plot frf.csv --figure response --width-mm 140 --out frf.svg"});
  command->footer(command->get_footer() + figures_help());
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
