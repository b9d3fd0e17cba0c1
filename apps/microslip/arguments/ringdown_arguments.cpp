// SPDX-License-Identifier: MIT
#include "arguments/ringdown_arguments.hpp"
#include <CLI/CLI.hpp>

#include <optional>
#include <string_view>
#include <utility>

#include "arguments/command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

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

RingDownOptions analysis_options(const RingdownArguments& options) {
  RingDownOptions all;
  all.frequency = quantity_if_given("--frequency", options.frequency, kFrequency);
  all.band = band_of(options.band);
  all.from = quantity_if_given("--from", options.from, kTime);
  all.to = quantity_if_given("--to", options.to, kTime);
  return all;
}

RingDownLevelsOptions level_options(const RingdownArguments& options) {
  RingDownLevelsOptions all;
  all.modal_mass = parse_quantity("--modal-mass", options.modal_mass, kMass);
  all.joint_ratio = parse_quantity("--joint-ratio", options.joint_ratio, kDimensionless);
  all.loss_factor = parse_quantity("--loss-factor", options.loss_factor, kDimensionless);
  all.stick_frequency = quantity_if_given("--stick-frequency", options.stick_frequency, kFrequency);
  all.joint_stiffness = quantity_if_given("--joint-stiffness", options.joint_stiffness, kStiffness);
  return all;
}

/// Options that only D and k_eq need.
void check_damping_alone(const RingdownArguments& options) {
  const auto refuse = [](std::string_view option, const std::string& value) {
    throw InputError(option, value, "must not be given without --modal-mass",
                     "Without it there is no dissipation to subtract it from.");
  };
  if (parse_quantity("--loss-factor", options.loss_factor, kDimensionless) != 0.0) {
    refuse("--loss-factor", options.loss_factor);
  }
  if (!options.stick_frequency.empty()) refuse("--stick-frequency", options.stick_frequency);
  if (!options.joint_stiffness.empty()) refuse("--joint-stiffness", options.joint_stiffness);
}

void add_analysis_options(CLI::App& command, RingdownArguments& options) {
  command
      .add_option("--channel", options.channels,
                  "Displacement, velocity or acceleration; not needed where there is only one. "
                  "Repeated: several sensors of one impact, reduced together; amplitude and modal "
                  "mass are those of the first")
      ->allow_extra_args(false);
  command.add_option("--frequency", options.frequency,
                     "Approximate frequency of the mode: the nearest peak within 10 % [Hz]; "
                     "default: the highest peak");
  command.add_option("--band", options.band,
                     "LOW:HIGH [Hz]: pass band that contains the mode and excludes others; "
                     "default: from the neighbouring modes");
  command.add_option("--from", options.from,
                     "Start of the free decay [s]; default: 1.5 periods after the impact, or where "
                     "the mode begins to decay");
  command.add_option("--to", options.to,
                     "End of the free decay [s]; default: where it falls below noise");
  add_recording_arguments(command, options.reading);
}

void add_level_options(CLI::App& command, RingdownArguments& options) {
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
                  "Loss factor of the linear part, subtracted from the dissipation [1]")
      ->capture_default_str();
  command.add_option(
      "--stick-frequency", options.stick_frequency,
      "Frequency of the mode with the joint stuck [Hz]; default: the highest measured");
  command.add_option("--joint-stiffness", options.joint_stiffness,
                     "k of the stuck joint [N/m]: gives secant_stiffness too; needs "
                     "--stick-frequency");
}

void add_modal_options(CLI::App& command, RingdownArguments& options) {
  command
      .add_option("--model", options.model,
                  "Structure with joints, model.toml: its modes are looked for near their "
                  "frequencies with stuck joints, and modal_levels.csv is written")
      ->type_name(kTomlValue);
  command
      .add_option("--sensor", options.sensors,
                  "CHANNEL=POINT: the sensor of a channel is at that point of the model; may be "
                  "repeated; replaces [[accelerometer]] of model.toml")
      ->allow_extra_args(false);
  command
      .add_option("--mode", options.modes,
                  "Mode, from 1, whose modal levels are written; with --model may be repeated, "
                  "default all that can be tracked; without --model the number for the table, with "
                  "the (first) sensor at the response point")
      ->check(CLI::Range(1, 100000))
      ->allow_extra_args(false);
}

/// Modal levels have the damping of the whole mode: what takes something off it has no place.
void check_modal(const RingdownArguments& options) {
  const auto refuse = [](std::string_view option, const std::string& value, std::string_view with) {
    if (value.empty()) return;
    throw InputError(option, value, "must not be given with " + std::string(with));
  };
  constexpr std::string_view kModal = "--mode or --model: modal levels have the total damping";
  refuse("--modal-mass", options.modal_mass, kModal);
  if (parse_quantity("--joint-ratio", options.joint_ratio, kDimensionless) != 1.0) {
    refuse("--joint-ratio", options.joint_ratio, kModal);
  }
  check_damping_alone(options);
  if (options.model.empty()) {
    refuse("--sensor", options.sensors.empty() ? "" : options.sensors.front(),
           "no --model, which defines the points");
    return;
  }
  constexpr std::string_view kModel = "--model, which specifies it";
  refuse("--channel", options.channels.empty() ? "" : options.channels.front(), kModel);
  refuse("--frequency", options.frequency, kModel);
  refuse("--band", options.band, kModel);
}

}  // namespace

void add_ringdown_arguments(CLI::App& command, RingdownArguments& arguments) {
  add_analysis_options(command, arguments);
  add_level_options(command, arguments);
  add_modal_options(command, arguments);
}

bool is_modal(const RingdownArguments& arguments) {
  return !arguments.model.empty() || !arguments.modes.empty() || !arguments.sensors.empty();
}

ModalDecayReduction modal_decay_options(const RingdownArguments& arguments) {
  check_modal(arguments);
  return {.recording = arguments.recording,
          .model = arguments.model,
          .sensors = arguments.sensors,
          .channels = arguments.channels,
          .modes = arguments.modes,
          .analysis = analysis_options(arguments),
          .reading = read_options(arguments.reading)};
}

DecayReduction decay_options(const RingdownArguments& arguments) {
  DecayReduction all{.recording = arguments.recording,
                     .channels = arguments.channels,
                     .analysis = analysis_options(arguments)};
  if (arguments.modal_mass.empty()) {
    check_damping_alone(arguments);
    all.joint_ratio = parse_quantity("--joint-ratio", arguments.joint_ratio, kDimensionless);
  } else {
    all.levels = level_options(arguments);
  }
  all.reading = read_options(arguments.reading);
  return all;
}

}  // namespace microslip::app
