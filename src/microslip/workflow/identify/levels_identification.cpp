// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/levels_identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/workflow/identify/found_joint.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

Provenance levels_provenance(const IdentificationOptions& options,
                             const std::vector<NamedInput>& inputs, std::string_view command,
                             const OptionTexts& texts) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  for (const NamedInput& input : inputs) {
    provenance.inputs.push_back({input.path, sha256(input.text)});
  }
  provenance.options = record_of_options(options, texts);
  if (options.bands) provenance.seed = options.bands->seed;
  return provenance;
}

/// Without any loss no density can be identified.
void check_losses(const LevelsFile& file) {
  if (std::ranges::any_of(file.levels.dissipation, [](double d) { return d > 0.0; })) return;
  throw FormatError({.file = file.file, .line = file.line.front(), .column = 0},
                    "a dissipation above 0 at one level at least",
                    fmt::format("0 at all {} levels from here on", file.levels.size()),
                    "Check the column, or measure at larger amplitudes.");
}

/// Errors of the levels name their file.
Identification identified(const LevelsFile& file, const LevelsIdentification& options) {
  try {
    return identify(LevelEvidence(file.levels, options.texts.common_errors), options.stiffness,
                    options.options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", file.file, error.name()));
  }
}

}  // namespace

IdentifiedLevels identify_levels(const LevelsIdentification& options) {
  const auto linear_loss = options.texts.common_errors.loss_factor_std > 0.0
                               ? LinearLossColumn::kNeeded
                               : LinearLossColumn::kIgnored;
  LevelTable table =
      read_level_table(options.levels, {.use_inner_reversals = options.use_inner_reversals,
                                        .linear_dissipation = linear_loss,
                                        .assemblies = options.assemblies});
  return identify_table(std::move(table), options);
}

IdentifiedLevels identify_table(LevelTable table, const LevelsIdentification& options) {
  check_losses(table.used);
  IdentifiedLevels done{.input = std::move(table.input), .found = identified(table.used, options)};
  done.count = table.used.levels.size();
  done.reversed = std::move(table.reversed);
  std::ranges::move(table.warnings, std::back_inserter(done.found.warnings));
  return done;
}

JointFile identified_joint(const Identification& found, const IdentificationOptions& options,
                           const std::vector<NamedInput>& inputs, std::string_view command,
                           const OptionTexts& texts) {
  return joint_file_of(found_joint(found), levels_provenance(options, inputs, command, texts));
}

std::string joint_text(const Identification& found, const IdentificationOptions& options,
                       const NamedInput& input, std::string_view command,
                       const OptionTexts& texts) {
  return format_joint(identified_joint(found, options, {input}, command, texts));
}

std::string samples_bytes(const Identification& found, const IdentificationOptions& options,
                          const NamedInput& input, std::string_view command,
                          const OptionTexts& texts, const std::string& path) {
  return joint_samples_bytes(
      joint_samples(found, levels_provenance(options, {input}, command, texts)), path);
}

std::string describe_identified_levels(const LevelsIdentification& options,
                                       const IdentifiedLevels& done) {
  // Levels with inner reversals have a line of their own.
  Identification found = done.found;
  if (done.reversed.empty()) return describe_identification(found, done.count);
  found.warnings.pop_back();
  const bool one = done.reversed.size() == 1;
  return describe_identification(found, done.count) +
         line("inner reversals",
              fmt::format("{} level{} (line{} {}){}", done.reversed.size(), one ? "" : "s",
                          one ? "" : "s", fmt::join(done.reversed, ", "),
                          options.use_inner_reversals
                              ? ", used nevertheless"
                              : ", left out; `inner_reversals use` includes them"));
}

}  // namespace microslip
