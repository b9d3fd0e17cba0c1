// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "microslip/workflow/levels_identification.hpp"

namespace microslip::app {

/// The options of `identify` as they are typed.
struct IdentifyArguments {
  std::string levels;
  std::string stiffness;
  std::string out;
  std::string density_csv;
  std::string method = "inversion";
  std::string smoothing = "gcv";
  std::optional<std::string> smoothing_unit;
  std::string linear_damping = "none";
  bool atom = false;
  std::string bands = "0";
  std::optional<std::string> seed;
  std::string dissipation_gain = "0";
  std::string amplitude_gain = "0";
  std::string loss_factor = "0";
  std::string fit = "none";
  std::string inner_reversals = "leave-out";
};

/// All but the levels and --quiet.
void add_identify_arguments(CLI::App& command, IdentifyArguments& arguments);

/// @throws InputError  where one cannot be read, or they do not go together.
[[nodiscard]] LevelsIdentification identification_options(const IdentifyArguments& arguments,
                                                          bool quiet);

}  // namespace microslip::app
