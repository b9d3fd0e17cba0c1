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

NamedValues record_of_options(const LevelsIdentification& of) {
  const IdentificationOptions& options = of.options;
  NamedValues record;
  record.emplace_back("method", std::string(to_string(options.method)));
  record.emplace_back("smoothing", of.texts.smoothing);
  if (of.texts.smoothing_unit) record.emplace_back("smoothing_unit", *of.texts.smoothing_unit);
  record.emplace_back("linear_damping", options.inversion.linear_damping ? "fit" : "none");
  record.emplace_back("atom", options.inversion.atom ? "sought" : "none");
  record.emplace_back("edges", options.inversion.edges ? "sought" : "none");
  record.emplace_back("bands", options.bands ? static_cast<double>(options.bands->samples) : 0.0);
  if (!of.texts.samples_out.empty()) record.emplace_back("samples_out", of.texts.samples_out);
  record.emplace_back("dissipation_gain_std", of.errors.dissipation_gain_std);
  record.emplace_back("amplitude_gain_std", of.errors.amplitude_gain_std);
  record.emplace_back("loss_factor_std", of.errors.loss_factor_std);
  record.emplace_back("fit", options.fit ? std::string(to_string(*options.fit)) : "none");
  record.emplace_back("inner_reversals", of.use_inner_reversals ? "use" : "leave-out");
  return record;
}

Provenance levels_provenance(const LevelsIdentification& options,
                             const std::vector<NamedInput>& inputs, std::string_view command) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  for (const NamedInput& input : inputs) {
    provenance.inputs.push_back({input.path, sha256(input.text)});
  }
  provenance.options = record_of_options(options);
  if (options.options.bands) provenance.seed = options.options.bands->seed;
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
    return identify(LevelEvidence(file.levels, options.errors), options.stiffness, options.options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", file.file, error.name()));
  }
}

}  // namespace

IdentifiedLevels identify_levels(const LevelsIdentification& options) {
  const auto linear_loss =
      options.errors.loss_factor_std > 0.0 ? LinearLossColumn::kNeeded : LinearLossColumn::kIgnored;
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
  done.reversed_warning = std::move(table.reversed_warning);
  std::ranges::move(table.warnings, std::back_inserter(done.found.warnings));
  return done;
}

JointFile identified_joint(const LevelsIdentification& options, const Identification& found,
                           const std::vector<NamedInput>& inputs, std::string_view command) {
  return joint_file_of(found_joint(found), levels_provenance(options, inputs, command));
}

std::string joint_text(const LevelsIdentification& options, const Identification& found,
                       const NamedInput& input, std::string_view command) {
  return format_joint(identified_joint(options, found, {input}, command));
}

std::string samples_bytes(const LevelsIdentification& options, const Identification& found,
                          const NamedInput& input, std::string_view command,
                          const std::string& path) {
  return joint_samples_bytes(joint_samples(found, levels_provenance(options, {input}, command)),
                             path);
}

std::string describe_identified_levels(const LevelsIdentification& options,
                                       const IdentifiedLevels& done) {
  if (!done.reversed_warning) return describe_identification(done.found, done.count);
  // Levels with inner reversals have a line of their own.
  Identification found = done.found;
  std::erase_if(found.warnings, [&](const Warning& warning) {
    return warning.code == done.reversed_warning->code &&
           warning.text == done.reversed_warning->text;
  });
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
