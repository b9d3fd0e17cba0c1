// SPDX-License-Identifier: MIT
#include "arguments/plot_arguments.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <filesystem>

#include "arguments/command.hpp"
#include "arguments/picture_argument.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"

namespace microslip::app {
namespace {

constexpr double kLeastWidth = 50.0;  // mm
constexpr double kMostWidth = 400.0;  // mm

/// The joint is called by the name of its file.
std::vector<NamedJoint> other_joints(const std::vector<std::string>& paths) {
  std::vector<NamedJoint> joints;
  for (const std::string& path : paths) {
    joints.push_back({std::filesystem::path(path).stem().string(), read_joint(path).joint});
  }
  return joints;
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
  for (const NamedFigure& figure : named_figures()) names.emplace_back(figure.name);
  return names;
}

void add_look_options(CLI::App& command, PlotArguments& options) {
  command.add_option("--time", options.time,
                     "FROM:TO of a history or a record, in s or with units; default: all of it");
  command
      .add_option("--record", options.record,
                  "Number of the record that the joint was identified from; default 1")
      ->check(CLI::Range(1, 1'000'000));
  command
      .add_option("--width-mm", options.width_mm,
                  "Width in mm: 90 fills a column, 190 a page; text stays 8 points high. Default: "
                  "whichever of the two suits the figure")
      ->check(width_range());
  command.add_flag("--grey", options.grey, "Shades of grey, for printing without colours");
  CLI::Option* log = command.add_flag("--log", options.log, "Logarithmic axis of the amplitude");
  command.add_flag("--linear", options.linear, "Linear axis of the amplitude")->excludes(log);
}

}  // namespace

void add_plot_arguments(CLI::App& command, PlotArguments& options) {
  command
      .add_option(
          "IN", options.in,
          "Folder as for the report, or a file: levels.csv, joint.json, density.csv, a table "
          "of frf, backbone, march, spectrum, loop, dissipation, verify, what calibrate reads and "
          "writes, "
          "draws of a joint, or a recording; - is standard input. Several joint.json are drawn "
          "together")
      ->required()
      ->type_name(kResultValue);
  command
      .add_option(
          "--figure", options.figure,
          "Figure to draw; if omitted, the only one available, or a list of those available")
      ->check(CLI::IsMember(figure_names()));
  command.add_option("--format", options.format, "Format; default: the ending of --out, or svg")
      ->check(CLI::IsMember({"svg", "pdf", "png"}));
  command
      .add_option(
          "--out", options.out,
          "Picture to write; - is standard output. Default: FIGURE.FORMAT in the current folder")
      ->type_name(kPictureValue);
  command
      .add_option("--other", options.others,
                  "Another joint, drawn with that of IN and labelled by its file name; may be "
                  "repeated")
      ->type_name(kJsonValue)
      ->allow_extra_args(false);
  add_look_options(command, options);
}

std::string figures_help() {
  std::string text = "\nFigures:\n";
  for (const NamedFigure& figure : named_figures()) {
    text += fmt::format("  {:<18}{}\n", figure.name, figure.shows);
  }
  return text;
}

PictureFormat format_of(const PlotArguments& options) {
  const bool named = !options.out.empty() && options.out != "-";
  const bool has_ending = named && std::filesystem::path(options.out).has_extension();
  if (options.format.empty()) {
    return named ? picture_format("--out", options.out) : PictureFormat::kSvg;
  }
  const PictureFormat format = picture_format("--format", "." + options.format);
  if (!has_ending || picture_format("--out", options.out) == format) return format;
  throw InputError("--format", "'" + options.format + "'",
                   fmt::format("must be the ending of --out, '{}'", options.out),
                   "Leave out --format.");
}

FigureOptions figure_options(const PlotArguments& options, const NamedFigure& figure,
                             const ResultInput& input) {
  if ((options.log || options.linear) && !figure.has_amplitude(input)) {
    throw InputError(options.log ? "--log" : "--linear", InputState{"given"},
                     fmt::format("{} has no amplitude axis here", figure.name), "Leave it out.");
  }
  if (options.record && !figure.of_record) {
    throw InputError("--record", fmt::format("{}", *options.record),
                     fmt::format("chooses a record, and {} is not of one", figure.name),
                     "Leave it out.");
  }
  if (!options.others.empty() && !figure.takes_others(input)) {
    throw InputError("--other", "'" + options.others.front() + "'",
                     fmt::format("{} draws no other joints here", figure.name), "Leave it out.");
  }
  FigureOptions made{.others = other_joints(options.others)};
  if (options.log) made.scale = AmplitudeScale::kLog;
  if (options.linear) made.scale = AmplitudeScale::kLinear;
  return made;
}

}  // namespace microslip::app
