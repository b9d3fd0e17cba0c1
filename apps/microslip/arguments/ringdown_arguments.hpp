// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "arguments/recording_arguments.hpp"
#include "microslip/workflow/reduce/decay_reduction.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"

namespace microslip::app {

/// The options of `ringdown` as they are typed.
struct RingdownArguments {
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
  std::string model;
  std::vector<std::string> sensors;
  std::vector<std::size_t> modes;
  RecordingArguments reading;
};

/// All but the recording, --out and --quiet.
void add_ringdown_arguments(CLI::App& command, RingdownArguments& arguments);

/// @throws InputError  where one cannot be read, or belongs to another that was not given.
[[nodiscard]] DecayReduction decay_options(const RingdownArguments& arguments);

/// Whether modal levels are asked for.
[[nodiscard]] bool is_modal(const RingdownArguments& arguments);

/// The same for modal levels.
/// @throws InputError  where one cannot be read, or is of no use for them.
[[nodiscard]] ModalDecayReduction modal_decay_options(const RingdownArguments& arguments);

}  // namespace microslip::app
