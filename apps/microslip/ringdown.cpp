// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/identify/levels.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/warning_comment.hpp"
#include "microslip/signal/ring_down.hpp"
#include "microslip/signal/ring_down_levels.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "microslip/workflow/summary_text.hpp"
#include "progress_bar.hpp"
#include "recording_arguments.hpp"

namespace microslip::app {
namespace {

struct RingdownOptions {
  std::string recording;
  std::string out;
  std::vector<std::string> channels;
  std::string frequency;
  std::string band;
  std::string from;
  std::string to;
  std::string modal_mass;
  std::string joint_ratio = "1";
  std::string loss_factor = "0";
  std::string stick_frequency;
  std::string joint_stiffness;
  RecordingArguments reading;
};

std::optional<double> quantity_if_given(std::string_view option, const std::string& text,
                                        const Dimension& dimension) {
  if (text.empty()) return std::nullopt;
  return parse_quantity(option, text, dimension);
}

std::optional<std::pair<double, double>> band_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    throw InputError("--band", in_quotes(text), "must read LOW:HIGH", "For instance 40:70.");
  }
  return std::pair{parse_quantity("LOW of --band", text.substr(0, colon), kFrequency),
                   parse_quantity("HIGH of --band", text.substr(colon + 1), kFrequency)};
}

RingDownOptions analysis_options(const RingdownOptions& options) {
  RingDownOptions all;
  all.frequency = quantity_if_given("--frequency", options.frequency, kFrequency);
  all.band = band_of(options.band);
  all.from = quantity_if_given("--from", options.from, kTime);
  all.to = quantity_if_given("--to", options.to, kTime);
  return all;
}

RingDownLevelsOptions level_options(const RingdownOptions& options) {
  RingDownLevelsOptions all;
  all.modal_mass = parse_quantity("--modal-mass", options.modal_mass, kMass);
  all.joint_ratio = parse_quantity("--joint-ratio", options.joint_ratio, kDimensionless);
  all.loss_factor = parse_quantity("--loss-factor", options.loss_factor, kDimensionless);
  all.stick_frequency = quantity_if_given("--stick-frequency", options.stick_frequency, kFrequency);
  all.joint_stiffness = quantity_if_given("--joint-stiffness", options.joint_stiffness, kStiffness);
  return all;
}

/// One decay: channels of one recording, one at least.
struct Signal {
  const Recording* recording;
  std::vector<std::string> channels;
};

bool is_motion(const Recording& recording, const Channel& channel) {
  return recording.axis.dimension == kTime && channel.imaginary.empty() && channel.dimension &&
         (*channel.dimension == kLength || *channel.dimension == kVelocity ||
          *channel.dimension == kAcceleration);
}

/// The channel of that name, or the only motion there is.
Signal choose_signal(const std::vector<Recording>& recordings, const std::string& name,
                     const std::string& file) {
  std::vector<Signal> fits;
  std::string names;
  for (const Recording& recording : recordings) {
    for (const Channel& channel : recording.channels) {
      if (name.empty() ? is_motion(recording, channel) : channel.name == name) {
        fits.push_back({&recording, {channel.name}});
      }
      names += (names.empty() ? "'" : ", '") + channel.name + "'";
    }
  }
  if (fits.size() == 1) return fits.front();
  const std::string what =
      fmt::format("{}: {}", file, name.empty() ? "motion" : "channel " + in_quotes(name));
  const std::string state = fits.empty() ? "missing" : fmt::format("there {} times", fits.size());
  throw InputError(what, InputState{state},
                   name.empty() ? "must have one channel of displacement, velocity or acceleration "
                                  "over time"
                                : "must be there once",
                   fmt::format("The channels are {}; choose by --channel, and give units that the "
                               "file lacks by --assume-units.",
                               names.empty() ? "none" : names));
}

/// The channels of those names, all of one recording.
Signal choose_signals(const std::vector<Recording>& recordings,
                      const std::vector<std::string>& names, const std::string& file) {
  if (names.empty()) return choose_signal(recordings, "", file);
  Signal signal = choose_signal(recordings, names.front(), file);
  for (const std::string& name : std::span(names).subspan(1)) {
    const Signal other = choose_signal(recordings, name, file);
    if (other.recording != signal.recording) {
      throw InputError(fmt::format("{}: channel {}", file, in_quotes(name)), "of another recording",
                       fmt::format("must be recorded with {}: one blow", in_quotes(names.front())));
    }
    signal.channels.push_back(name);
  }
  return signal;
}

/// What holds for the whole decay: what single levels say of themselves is among their own flags.
std::string codes_of(const std::vector<Warning>& warnings) {
  std::string codes;
  for (const Warning& warning : warnings) {
    constexpr std::string_view kOfLevels[] = {"beats", "neighbour_leaks", "sensors_differ",
                                              "shape_moves", "steady_tone"};
    if (std::ranges::find(kOfLevels, warning.code) != std::end(kOfLevels)) continue;
    if ((" " + codes + " ").find(" " + warning.code + " ") != std::string::npos) continue;
    codes += (codes.empty() ? "" : " ") + warning.code;
  }
  return codes;
}

std::vector<std::string> flags_of(const RingDownLevels& found,
                                  const std::vector<Warning>& warnings) {
  const std::string all = codes_of(warnings);
  std::vector<std::string> flags = found.flags;
  for (std::string& own : flags) own += (own.empty() || all.empty() ? "" : " ") + all;
  return flags;
}

std::string start_text(const RingDown& decay) {
  std::string text = fmt::format("{:.5g} s, ", decay.start);
  switch (decay.start_by) {
    case DecayStart::kGiven:
      return text + "given";
    case DecayStart::kRecord:
      return text + "the beginning of the record: no blow is in it";
    case DecayStart::kBlow:
      return text + fmt::format("1.5 periods behind the blow at {:.5g} s", *decay.blow);
    case DecayStart::kFall:
      break;
  }
  return text + "where the mode begins to fall";
}

std::string band_text(const RingDown& decay, bool given) {
  return fmt::format("{:.6g}:{:.6g} Hz, {}", decay.band.first, decay.band.second,
                     given ? "given" : "by the neighbouring modes and the damping");
}

std::string sensors_text(const RingDown& decay) {
  std::string text;
  for (const RingDownSensor& sensor : decay.sensors) {
    text += (text.empty() ? "" : ", ") + sensor.name;
    if (&sensor == &decay.sensors.front()) continue;
    text += fmt::format(" ({:.4g} of its amplitude, {:.2g} % apart over the decay)", sensor.ratio,
                        100.0 * sensor.ratio_range);
  }
  return text;
}

/// What is said of the decay above the levels.
std::string comment_of(const RingDown& decay, const std::vector<Warning>& warnings, bool banded,
                       const Call& call) {
  std::string text = microslip::heading_of(call.command_line);
  text += "\nsensors: " + sensors_text(decay);
  text += "\nfree decay from: " + start_text(decay);
  text += "\nband: " + band_text(decay, banded);
  text += "\nended: " + decay.summary.reason;
  for (const Warning& warning : warnings) text += "\n" + warning_comment(warning);
  return text;
}

CsvWriter dissipation_table(const RingDownLevels& found) {
  return levels_table({.amplitude = found.amplitude,
                       .dissipation = found.dissipation,
                       .amplitude_std = found.amplitude_std,
                       .dissipation_std = found.dissipation_std,
                       .secant_stiffness = found.secant_stiffness,
                       .secant_stiffness_std = found.secant_stiffness_std});
}

/// Without modal mass the levels have no dissipation.
std::string levels_text(const RingDownLevels& found, const Signal& signal,
                        const std::vector<Warning>& warnings, std::string_view comment) {
  const std::size_t n = found.amplitude.size();
  const bool damping_alone = found.dissipation.empty();
  CsvWriter table = damping_alone ? CsvWriter() : dissipation_table(found);
  if (damping_alone) {
    table.add_numbers("amplitude", kLength, found.amplitude);
    table.add_numbers("amplitude_std", kLength, found.amplitude_std);
  }
  table.add_numbers("frequency", kFrequency, found.frequency);
  table.add_numbers("frequency_std", kFrequency, found.frequency_std);
  table.add_numbers("damping_ratio", kDimensionless, found.damping_ratio);
  table.add_numbers("damping_ratio_std", kDimensionless, found.damping_ratio_std);
  // A column `time` would make the table a history, which no table of levels may replace.
  table.add_numbers("decay_time", kTime, found.time);
  table.add_text("source", std::vector<std::string>(n, signal.recording->source));
  table.add_text("flags", flags_of(found, warnings));
  table.add_comment(comment);
  return table.str();
}

std::string describe(const RingDown& decay, const RingDownLevels& levels, const Signal& signal,
                     const std::vector<Warning>& warnings, bool banded) {
  const auto span = [](const std::vector<double>& values) {
    return fmt::format("{:.4g} to {:.4g}", values.front(), values.back());
  };
  std::string text = "Ring-down\n";
  text += line("recording", fmt::format("{}, {}", signal.recording->source, sensors_text(decay)));
  text += line("method", decay.summary.method);
  text += line("free decay from", start_text(decay));
  text += line("band", band_text(decay, banded));
  text += line("decay used",
               fmt::format("{:.4g} to {:.4g} s, {}", decay.from, decay.to, decay.summary.reason));
  text += line("levels", fmt::format("{}, by falling amplitude", levels.amplitude.size()));
  const bool damping_alone = levels.dissipation.empty();
  text += line(damping_alone ? "amplitude" : "joint amplitude", span(levels.amplitude) + " m");
  text += line("dissipation",
               damping_alone ? "none: without --modal-mass" : span(levels.dissipation) + " J");
  text += line("frequency",
               fmt::format("{:.6g} to {:.6g} Hz ({:+.2g} %)", levels.frequency.front(),
                           levels.frequency.back(),
                           100.0 * (levels.frequency.back() / levels.frequency.front() - 1.0)));
  text += line("damping ratio", span(levels.damping_ratio));
  text +=
      line("noise", fmt::format("{:.2g} of the first amplitude, a sample", decay.summary.residual));
  for (const Warning& warning : warnings) text += wrapped("  warning: ", warning.text, 11);
  return text;
}

/// Options that only D and k_eq need.
void check_damping_alone(const RingdownOptions& options) {
  const auto refuse = [](std::string_view option, const std::string& value) {
    throw InputError(option, value, "must not be given without --modal-mass",
                     "Without it there is no dissipation to take it from.");
  };
  if (parse_quantity("--loss-factor", options.loss_factor, kDimensionless) != 0.0) {
    refuse("--loss-factor", options.loss_factor);
  }
  if (!options.stick_frequency.empty()) refuse("--stick-frequency", options.stick_frequency);
  if (!options.joint_stiffness.empty()) refuse("--joint-stiffness", options.joint_stiffness);
}

RingDownLevels levels_by(const RingdownOptions& options, const RingDown& decay) {
  if (options.modal_mass.empty()) {
    return damping_levels_of(decay,
                             parse_quantity("--joint-ratio", options.joint_ratio, kDimensionless));
  }
  const RingDownLevelsOptions reduction = level_options(options);
  RingDownLevels levels = levels_of(decay, reduction);
  if (levels.amplitude.empty()) {
    throw InputError("--loss-factor", reduction.loss_factor,
                     "must leave some loss to the joint, and exceeds all that was measured");
  }
  return levels;
}

int run(const RingdownOptions& options, const Call& call) {
  const bool damping_alone = options.modal_mass.empty();
  check_output(options.out, damping_alone ? kDampingLevelsKind : kLevelsKind);
  const RingDownOptions analysis = analysis_options(options);
  if (damping_alone) {
    check_damping_alone(options);
  } else {
    (void)level_options(options);  // what cannot be read is refused before the work
  }
  const Recordings file = read_recordings(
      options.recording, read_options(options.reading, progress_bar("reading", call.quiet)));
  const Signal signal = choose_signals(file.recordings, options.channels, options.recording);
  const RingDown decay = ring_down(*signal.recording, signal.channels, analysis);
  const RingDownLevels levels = levels_by(options, decay);
  std::vector<Warning> warnings = file.warnings;
  for (const auto* more : {&decay.warnings, &levels.warnings}) {
    warnings.insert(warnings.end(), more->begin(), more->end());
  }
  const bool banded = analysis.band.has_value();
  write_file(options.out,
             levels_text(levels, signal, warnings, comment_of(decay, warnings, banded, call)));
  if (!call.quiet) {
    fmt::print(options.out == "-" ? stderr : stdout, "{}",
               describe(decay, levels, signal, warnings, banded));
  }
  return decay.summary.converged() ? kDone : kNotConverged;
}

void add_analysis_options(CLI::App& command, RingdownOptions& options) {
  command
      .add_option(
          "--channel", options.channels,
          "Displacement, velocity or acceleration; not needed where there is only one. "
          "Repeated: several sensors of one blow, reduced together; amplitude and modal mass "
          "are those of the first")
      ->allow_extra_args(false);
  command.add_option("--frequency", options.frequency,
                     "Near which the mode is sought: the nearest peak within 10 % [Hz]; else the "
                     "highest peak of all");
  command.add_option(
      "--band", options.band,
      "LOW:HIGH [Hz]: the mode is inside, and other modes outside are kept out; else "
      "by the neighbouring modes");
  command.add_option(
      "--from", options.from,
      "Where the free decay begins [s]; else 1.5 periods behind the blow, or where the "
      "mode begins to fall");
  command.add_option("--to", options.to, "Where it ends [s]; else where the noise begins");
  add_recording_arguments(command, options.reading);
}

void add_level_options(CLI::App& command, RingdownOptions& options) {
  command.add_option(
      "--modal-mass", options.modal_mass,
      "Mass of the mode at the (first) sensor, 1/shape^2 for a mass-normalised shape "
      "[kg]; without it amplitude, frequency and damping ratio alone");
  command
      .add_option("--joint-ratio", options.joint_ratio,
                  "Joint displacement over displacement at the sensor [1]")
      ->capture_default_str();
  command
      .add_option("--loss-factor", options.loss_factor,
                  "Loss factor of the linear part, taken off the dissipation [1]")
      ->capture_default_str();
  command.add_option("--stick-frequency", options.stick_frequency,
                     "The mode's frequency with the joint stuck [Hz]; else the highest measured");
  command.add_option("--joint-stiffness", options.joint_stiffness,
                     "k of the stuck joint [N/m]: gives secant_stiffness too; needs "
                     "--stick-frequency");
}

}  // namespace

void add_ringdown(CLI::App& program, Call& call) {
  auto options = std::make_shared<RingdownOptions>();
  CLI::App* command =
      program.add_subcommand("ringdown", "Levels of amplitude and dissipation from one free decay");
  command
      ->add_option("recording", options->recording,
                   "Recording of a free decay, evenly sampled: time [s], acc1 [m/s^2], ...")
      ->required()
      ->type_name(kRecordingValue);
  command
      ->add_option(
          "--out", options->out,
          "Levels to write as CSV: amplitude [m], dissipation [J], frequency [Hz], "
          "damping_ratio [1], each with its standard deviation (_std), decay_time [s], source, "
          "flags; no dissipation without --modal-mass; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  add_analysis_options(*command, *options);
  add_level_options(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip ringdown decay.csv --modal-mass 1.2 --out levels.csv",
                "microslip ringdown decay.csv --channel acc1 --frequency 50 --band 40:65 \\",
                "          --modal-mass 1.2 --joint-ratio 0.3 --loss-factor 0.001 --out levels.csv",
                "microslip ringdown decay.csv --out damping.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
