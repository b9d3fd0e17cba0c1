// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "command.hpp"
#include "microslip/workflow/model_draws.hpp"

/// @file
/// What all predictions by draws share: how many, of which seed, and how much of them lies in the
/// band.

namespace microslip::app {

struct DrawArguments {
  std::string count;
  std::string seed = "1";
  std::string confidence = "0.95";
  std::string correlation = "auto";

  /// Whether draws are asked for.
  [[nodiscard]] bool any() const { return !count.empty(); }
};

/// --draws, --seed, --confidence.
/// @param columns  that draws add, for the help.
void add_draw_arguments(CLI::App& command, DrawArguments& arguments, const std::string& columns);

/// --correlation, of models, which may have several joints.
void add_correlation_argument(CLI::App& command, DrawArguments& arguments);

/// Of arguments that ask for draws. @throws InputError  for values out of their range.
[[nodiscard]] DrawOptions draw_options(const DrawArguments& arguments);

}  // namespace microslip::app
