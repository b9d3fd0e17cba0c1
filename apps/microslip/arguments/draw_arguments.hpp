// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "arguments/command.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Options common to all predictions with draws: number, seed and probability of the band.

namespace microslip::app {

struct DrawArguments {
  std::string count;
  std::string seed = "1";
  std::string confidence = "0.95";
  std::string correlation = "auto";

  /// Whether draws are asked for.
  [[nodiscard]] bool any() const { return !count.empty(); }
};

/// Adds --draws, --seed, --confidence.
/// @param columns  that draws add, for the help.
void add_draw_arguments(CLI::App& command, DrawArguments& arguments, const std::string& columns);

/// Adds --correlation, for models, which may have several joints.
void add_correlation_argument(CLI::App& command, DrawArguments& arguments);

/// Options of draws of a single joint.
struct JointDrawArguments : DrawArguments {
  std::string samples;
  std::string normal_load_std = "0";
};

/// Adds the options of draws of a single joint: add_draw_arguments(), --samples and
/// --normal-load-std.
/// @param columns  that draws add, for the help.
void add_joint_draw_arguments(CLI::App& command, JointDrawArguments& arguments,
                              const std::string& columns);

/// Adds the same without --confidence, for draws that are written one by one and make no band.
/// @param words  what becomes of them, for the help.
void add_single_draw_arguments(CLI::App& command, JointDrawArguments& arguments,
                               const std::string& words);

/// A standard deviation of a logarithm on the command line. @throws InputError  out of range.
[[nodiscard]] double parse_spread(std::string_view option, const std::string& text);

/// Uncertainty specified by --samples and --normal-load-std. @throws InputError  out of range.
[[nodiscard]] JointUncertainty uncertainty_of(const JointDrawArguments& arguments);

/// Draws that were requested, if any. @throws Error  as draws_of().
[[nodiscard]] std::optional<LoneJointDraws> draws_of(const JointFile& file,
                                                     const JointDrawArguments& arguments,
                                                     bool quiet);

/// Options of draws from the arguments that ask for them. @throws InputError  for values out of
/// their range.
[[nodiscard]] DrawOptions draw_options(const DrawArguments& arguments);

}  // namespace microslip::app
