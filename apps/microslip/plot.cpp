// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/text.hpp"
#include "microslip/report/paper_picture.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "picture_argument.hpp"
#include "plot_figures.hpp"
#include "plot_input.hpp"

namespace microslip::app {
namespace {

constexpr double kLeastWidth = 50.0;  // mm
constexpr double kMostWidth = 400.0;  // mm

struct PlotOptions {
  std::string in;
  std::string figure;
  std::string format;
  std::string out;
  std::vector<std::string> others;
  std::optional<double> width_mm;
  std::string time;
  bool grey = false;
  bool log = false;
  bool linear = false;
};

PictureFormat format_of_word(const std::string& word) {
  return picture_format("--format", "." + word);
}

const char* ending_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::kPng:
      return "png";
    case PictureFormat::kPdf:
      return "pdf";
    case PictureFormat::kSvg:
      break;
  }
  return "svg";
}

std::string_view kind_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::kPng:
      return "a PNG picture";
    case PictureFormat::kPdf:
      return "a PDF document";
    case PictureFormat::kSvg:
      break;
  }
  return "an SVG picture";
}

/// By --format, by the ending of --out, or SVG.
PictureFormat format_of(const PlotOptions& options) {
  const bool named = !options.out.empty() && options.out != "-";
  const bool has_ending = named && std::filesystem::path(options.out).has_extension();
  if (options.format.empty()) {
    return named ? picture_format("--out", options.out) : PictureFormat::kSvg;
  }
  const PictureFormat format = format_of_word(options.format);
  if (!has_ending || picture_format("--out", options.out) == format) return format;
  throw InputError("--format", "'" + options.format + "'",
                   fmt::format("must be the ending of --out, '{}'", options.out),
                   "Leave out --format.");
}

/// The joint is called by the name of its file.
std::vector<NamedJoint> other_joints(const std::vector<std::string>& paths) {
  std::vector<NamedJoint> joints;
  for (const std::string& path : paths) {
    joints.push_back({std::filesystem::path(path).stem().string(), read_joint(path).joint});
  }
  return joints;
}

PaperOptions paper_options(const PlotOptions& options, const PlotFigure& figure,
                           const PlotInput& input) {
  if ((options.log || options.linear) && !figure.has_amplitude(input)) {
    throw InputError(options.log ? "--log" : "--linear", InputState{"given"},
                     fmt::format("{} has no axis of an amplitude here", figure.name),
                     "Leave it out.");
  }
  if (!options.others.empty() && !figure.takes_others(input)) {
    throw InputError("--other", "'" + options.others.front() + "'",
                     fmt::format("{} draws no other joints here", figure.name), "Leave it out.");
  }
  PaperOptions paper{.others = other_joints(options.others)};
  if (options.log) paper.scale = AmplitudeScale::kLog;
  if (options.linear) paper.scale = AmplitudeScale::kLinear;
  return paper;
}

void cut_to_time(const std::string& time, const PlotFigure& figure, PlotInput& input) {
  if (input.history.empty()) {
    throw InputError("--time", in_quotes(time),
                     fmt::format("cuts the figure history, not {}", figure.name), "Leave it out.");
  }
  const auto [from, to] = parse_interval("--time", time, kTime);
  cut_history(input, from, to);
}

/// Says of which file, and where it can of which axis, a value is that cannot be drawn: for
/// "panels[0].layers[1].x[3]", for instance.
InputError named(const InputError& error, const PlotInput& input, const FigureGrid* grid) {
  const std::string& name = error.name();
  if (name.starts_with("--")) return error;
  const std::string panels = "panels[";
  std::string part = name.starts_with("layers") ? "value" : name;
  if (grid && name.starts_with(panels)) {
    const Figure& panel = grid->panels.at(std::stoul(name.substr(panels.size())));
    part = name.find(".x") != std::string::npos ? panel.x.label : panel.y.label;
  }
  return error.renamed(fmt::format("{}: {}", input.name, part));
}

PaperPicture drawn(const PlotOptions& options, const PlotInput& input, const PlotFigure& figure,
                   PictureFormat format) {
  const PaperOptions paper = paper_options(options, figure, input);
  FigureGrid grid;
  try {
    grid = figure.make(input, paper);
    return draw_for_paper(grid, format, {.width_mm = options.width_mm, .grey = options.grey});
  } catch (const InputError& error) {
    throw named(error, input, grid.panels.empty() ? nullptr : &grid);
  }
}

int run(const PlotOptions& options, const Call& call) {
  const PictureFormat format = format_of(options);
  if (!options.out.empty()) check_output(options.out, kind_of(format));
  PlotInput input = read_plot_input(options.in);
  const PlotFigure& figure = find_figure(options.figure, input);
  if (!options.time.empty()) cut_to_time(options.time, figure, input);
  const std::string out =
      options.out.empty() ? fmt::format("{}.{}", figure.name, ending_of(format)) : options.out;
  check_output(out, kind_of(format));

  const PaperPicture picture = drawn(options, input, figure, format);
  write_file(out, picture.bytes);
  if (!call.quiet && out != "-") {
    fmt::print("{}: {}, {:.0f} mm wide, {:.0f} mm high\n", out, figure.name, picture.width_mm,
               picture.height_mm);
    if (input.left_out > 0) {
      fmt::print("{} further channels are not drawn: a figure holds eight of a quantity\n",
                 input.left_out);
    }
  }
  return kDone;
}

/// As CLI::Range, with a message that can be understood.
CLI::Validator width_range() {
  CLI::Validator range = CLI::Range(kLeastWidth, kMostWidth);
  range.operation([](const std::string& text) -> std::string {
    double width = 0.0;
    if (CLI::detail::lexical_cast(text, width) && width >= kLeastWidth && width <= kMostWidth) {
      return "";
    }
    return fmt::format("'{}' must be a number of mm without a unit, from {:g} to {:g}", text,
                       kLeastWidth, kMostWidth);
  });
  return range;
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const PlotFigure& figure : plot_figures()) names.emplace_back(figure.name);
  return names;
}

std::string figure_texts() {
  std::string text = "\nFigures:\n";
  for (const PlotFigure& figure : plot_figures()) {
    text += fmt::format("  {:<18}{}\n", figure.name, figure.shows);
  }
  return text;
}

void add_look_options(CLI::App& command, PlotOptions& options) {
  command.add_option("--time", options.time,
                     "FROM:TO of a history, in s or with units; without it all of it");
  command
      .add_option("--width-mm", options.width_mm,
                  "Width in mm: 90 fills a column, 190 a page; letters stay 8 points high. "
                  "Without it whichever of the two suits the figure")
      ->check(width_range());
  command.add_flag("--grey", options.grey, "Shades of grey, for print without colours");
  CLI::Option* log = command.add_flag("--log", options.log, "Logarithmic axis of the amplitude");
  command.add_flag("--linear", options.linear, "Linear axis of the amplitude")->excludes(log);
}

}  // namespace

void add_plot(CLI::App& program, Call& call) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program.add_subcommand(
      "plot", "A figure for a paper, of what a folder holds of a test or of one result");
  command
      ->add_option(
          "IN", options->in,
          "Folder as for the report, or a file: levels.csv, joint.json, density.csv, a table "
          "of frf, backbone, march, loop, dissipation, verify or a recording; - is "
          "standard input")
      ->required()
      ->type_name(kResultValue);
  command
      ->add_option("--figure", options->figure,
                   "Which one; without it the only one there is, or the program tells which "
                   "there are")
      ->check(CLI::IsMember(figure_names()));
  command
      ->add_option("--format", options->format,
                   "Format; without it the ending of --out tells, or it is svg")
      ->check(CLI::IsMember({"svg", "pdf", "png"}));
  command
      ->add_option(
          "--out", options->out,
          "The picture; - is standard output. Without it FIGURE.FORMAT in the current folder")
      ->type_name(kPictureValue);
  command
      ->add_option("--other", options->others,
                   "Another joint, drawn beside that of IN under the name of its file; may be "
                   "repeated")
      ->type_name(kJsonValue)
      ->allow_extra_args(false);
  add_look_options(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip plot test --figure energies --format pdf",
                          "microslip plot joint.json --figure loops --grey --out loops.pdf",
                          "microslip plot frf.csv --figure response --width-mm 140 --out frf.svg"});
  command->footer(command->get_footer() + figure_texts());
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
