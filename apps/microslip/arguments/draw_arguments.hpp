// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "arguments/command.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

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

/// Draws of a joint by itself.
struct JointDrawArguments : DrawArguments {
  std::string samples;
  std::string normal_load_std = "0";
};

/// The draws of a joint by itself: add_draw_arguments(), --samples and --normal-load-std.
/// @param columns  that draws add, for the help.
void add_joint_draw_arguments(CLI::App& command, JointDrawArguments& arguments,
                              const std::string& columns);

/// A standard deviation of a logarithm on the command line. @throws InputError  out of range.
[[nodiscard]] double parse_spread(std::string_view option, const std::string& text);

/// What --samples and --normal-load-std say. @throws InputError  out of range.
[[nodiscard]] JointUncertainty uncertainty_of(const JointDrawArguments& arguments);

/// The draws that are asked for, if any. @throws Error  as draws_of().
[[nodiscard]] std::optional<LoneJointDraws> draws_of(const JointFile& file,
                                                     const JointDrawArguments& arguments,
                                                     bool quiet);

/// Of arguments that ask for draws. @throws InputError  for values out of their range.
[[nodiscard]] DrawOptions draw_options(const DrawArguments& arguments);

}  // namespace microslip::app
