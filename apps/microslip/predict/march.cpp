// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/prediction.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/dynamics/march/release.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/signal/shock/load_shapes.hpp"
#include "microslip/workflow/predict/march_draws.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostEvery = 1'000'000'000;
constexpr std::uint64_t kMostElements = 1'000'000;

struct MarchArguments : ModelArguments {
  std::string forces;
  std::string release;
  std::string duration;
  std::string sampling_rate;
  std::string step;
  std::string every = "1";
  std::string law = "incremental";
  std::string elements = "1000";
  bool no_error_estimate = false;
  std::string peaks;
  DrawArguments draws;
};

MarchOptions march_options(const MarchArguments& arguments, const ModelFile& model) {
  MarchOptions options;
  options.points = {model.response};
  options.every = parse_whole_number("--every", arguments.every, 1, kMostEvery);
  options.estimate_error = !arguments.no_error_estimate;
  options.elements = parse_whole_number("--elements", arguments.elements, 1, kMostElements);
  if (arguments.step.empty()) return options;
  options.step = parse_quantity("--step", arguments.step, kTime);
  if (!(options.step > 0.0)) throw InputError("--step", options.step, "must be above 0 s");
  return options;
}

/// MODE:DISPLACEMENT, several between commas.
std::vector<DrawnMode> parse_release(const std::string& text, const ModelFile& model) {
  std::vector<DrawnMode> drawn;
  for (const std::string_view part : split(text, ',')) {
    const std::vector<std::string_view> ends = split(part, ':');
    if (ends.size() != 2) {
      throw InputError("--release", in_quotes(text),
                       "must read MODE:DISPLACEMENT, for instance 1:2mm",
                       "Separate several by commas.");
    }
    const std::uint64_t mode =
        parse_whole_number("MODE of --release", ends[0], 1, model.structure.linear().vibrations(),
                           "The model has that many modes.");
    drawn.push_back({mode - 1, parse_quantity("DISPLACEMENT of --release", ends[1], kLength)});
  }
  return drawn;
}

InitialState start_of(const MarchArguments& arguments, const ModelFile& model) {
  if (arguments.release.empty() && arguments.duration.empty()) return {};
  if (!model.structure.static_loads().empty()) {
    throw InputError("--release", in_quotes(arguments.release),
                     "must be left out: the model has static loads, and begins at rest under them",
                     "Release a force with --force-file instead.");
  }
  const auto modes = parse_release(arguments.release, model);
  try {
    return released(model.structure, model.response, modes);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("--release: {}", error.name()));
  }
}

/// Of the file; without one nothing acts, for so long.
LoadHistory loads_of(const MarchArguments& arguments, const ModelFile& model) {
  if (!arguments.forces.empty()) {
    const NormalLoadLaw law =
        arguments.law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental;
    return read_loads(arguments.forces, model.structure, law);
  }
  return {even_times(parse_quantity("--duration", arguments.duration, kTime),
                     parse_quantity("--sampling-rate", arguments.sampling_rate, kFrequency)),
          {}};
}

/// The table, the peaks, and the summary of a march with draws.
int run_draws(const MarchArguments& arguments, const ModelFile& model, const LoadHistory& loads,
              const MarchOptions& options, const Call& call) {
  const DrawOptions drawn = draw_options(arguments.draws);
  const StructureDraws draws = draws_of(model, arguments.model, drawn);
  const DrawnMarch march =
      drawn_march(model, loads, options, draws, drawn, Execution::threads(),
                  progress_bar("time", call.quiet), progress_bar("draws", call.quiet));
  std::string heading = heading_of(call.command_line, model);
  OutputFiles peaks;
  if (march.has_band()) {
    heading += "\n" + draws_comment(march.taken, uncertain_text(model)) + "\n" +
               march_peaks_comment(march);
    if (!arguments.peaks.empty()) peaks.add(arguments.peaks, march_peaks_table(march, heading));
  }
  write_drawn_march(arguments.out, model, loads, heading, march);
  peaks.commit();
  const int status = tell_ending(march.march.summary, true, arguments, call, [&] {
    const std::string spread =
        march.has_band()
            ? describe_march_spread(march) + describe_draws(march.taken, uncertain_text(model))
            : "";
    return describe_march(arguments.model, arguments.forces, model, loads, march.march, spread);
  });
  return march.taken.too_many_failed() ? kNotConverged : status;
}

int run(const MarchArguments& arguments, const Call& call) {
  check_output(arguments.out);
  const ModelFile model = read_model(arguments.model);
  // Without joints the table is one of point motions, as a recording can be.
  std::vector<PlannedOutput> outputs{
      {arguments.out, model.structure.joints().empty() ? std::string_view{} : kMarchKind}};
  if (!arguments.peaks.empty()) outputs.push_back({arguments.peaks, kMarchPeaksKind});
  check_outputs(outputs);
  MarchOptions options = march_options(arguments, model);
  options.start = start_of(arguments, model);
  const LoadHistory loads = loads_of(arguments, model);
  if (arguments.draws.any()) return run_draws(arguments, model, loads, options, call);
  const MarchResult result =
      march_to_table(arguments.out, model, loads, options, heading_of(call.command_line, model),
                     progress_bar("time", call.quiet));
  return tell_ending(result.summary, true, arguments, call, [&] {
    return describe_march(arguments.model, arguments.forces, model, loads, result);
  });
}

void add_loads(CLI::App& command, MarchArguments& arguments) {
  CLI::Option* forces =
      command
          .add_option(
              "--force-file", arguments.forces,
              "Load history as CSV: time [s], force [N] at the excitation of the model, force "
              "at POINT [N] or acceleration of BASE [m/s^2]; normal_load [1] or "
              "normal_load of JOINT [1] if the normal load of a joint varies. Linear between the "
              "times; - is standard input")
          ->type_name(kCsvValue);
  CLI::Option* release = command.add_option(
      "--release", arguments.release,
      "Release from rest in the shape of a mode of the stuck structure: MODE:DISPLACEMENT at the "
      "response point, in m or with a unit; separate several by commas");
  CLI::Option* duration =
      command
          .add_option("--duration", arguments.duration,
                      "Length of a free decay without --force-file, in s or with a unit")
          ->needs(release)
          ->excludes(forces);
  CLI::Option* rate = command.add_option("--sampling-rate", arguments.sampling_rate,
                                         "Sampling rate of its rows, in Hz or with a unit");
  rate->needs(duration)->excludes(forces);
  duration->needs(rate);
}

void add_steps(CLI::App& command, MarchArguments& arguments) {
  command.add_option(
      "--step", arguments.step,
      "Longest step, in s or with a unit; default: 1/20 of the shortest period of the stuck "
      "structure, 1/80 if a density has more than 16 atoms, 1/400 if a normal load varies");
  command.add_flag("--no-error-estimate", arguments.no_error_estimate,
                   "Skip the second march with twice the step that estimates the error: saves a "
                   "third of the time");
  command
      .add_option("--every", arguments.every,
                  "Times of the force file, or of --sampling-rate, per output row")
      ->capture_default_str();
  command
      .add_option("--normal-load-law", arguments.law,
                  "Behaviour of a stuck element when its normal load varies")
      ->check(CLI::IsMember({"incremental", "total"}))
      ->capture_default_str();
  command
      .add_option("--elements", arguments.elements,
                  "Number of Jenkins elements of a joint whose normal load varies")
      ->capture_default_str();
}

void add_march_draws(CLI::App& command, MarchArguments& arguments) {
  add_draw_arguments(command, arguments.draws,
                     "displacement_lower and displacement_upper [m] at each time, and those of "
                     "each computed column");
  add_correlation_argument(command, arguments.draws);
  command
      .add_option("--peaks-csv", arguments.peaks,
                  "Largest values and rms of each column as CSV, with their bands from the draws")
      ->needs(command.get_option("--draws"))
      ->type_name(kCsvValue);
}

}  // namespace

void add_march(CLI::App& program, Call& call) {
  auto arguments = std::make_shared<MarchArguments>();
  CLI::App* command =
      program.add_subcommand("march", "Time history of a structure with joints under any force");
  command->add_option("model", arguments->model, "Structure with joints, model.toml")
      ->required()
      ->type_name(kTomlValue);
  add_loads(*command, *arguments);
  command
      ->add_option("--out", arguments->out,
                   "CSV to write: time [s], loads, displacement [m], velocity [m/s], acceleration "
                   "[m/s^2], JOINT displacement [m], JOINT force [N], and absolute_displacement "
                   "[m], absolute_velocity [m/s], absolute_acceleration [m/s^2] if a base is "
                   "shaken; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  add_steps(*command, *arguments);
  add_march_draws(*command, *arguments);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(
      *command,
      {"microslip march model.toml --force-file force.csv --out march.csv",
       "microslip march model.toml --force-file force.csv --step 20ms --every 10 \\",
       "          --out -",
       "microslip march model.toml --force-file force.csv --no-error-estimate \\",
       "          --out march.csv", "microslip march model.toml --release 1:2mm --duration 5s \\",
       "          --sampling-rate 2kHz --out decay.csv",
       "microslip march model.toml --force-file force.csv --draws 1000 \\",
       "          --out march.csv --peaks-csv peaks.csv"});
  command->callback([arguments, &call] {
    if (arguments->forces.empty() && arguments->duration.empty()) {
      throw CLI::RequiredError("--force-file, or --release and --duration,");
    }
    call.run = [arguments, &call] { return run(*arguments, call); };
  });
}

}  // namespace microslip::app
