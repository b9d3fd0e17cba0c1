// SPDX-License-Identifier: MIT
#include "microslip/workflow/levels_identification.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/sha256.hpp"
#include "microslip/io/text.hpp"
#include "microslip/workflow/identification_text.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

/// Values of a column from the first to the second limit; 0 too where that has a meaning.
struct Sizes {
  double from;
  double to;
  bool or_zero = true;
};

void check_size(const LevelsFile& file, const std::vector<double>& values, std::string_view name,
                const Sizes& sizes, const Dimension& dimension) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= sizes.from && values[i] <= sizes.to) continue;
    if (values[i] == 0.0 && sizes.or_zero) continue;
    throw FormatError({.file = file.file, .line = file.line[i], .column = 0},
                      fmt::format("{} {}from {:g} to {:g} {}", name, sizes.or_zero ? "0 or " : "",
                                  sizes.from, sizes.to, si_unit(dimension)),
                      fmt::format("{:g}", values[i]),
                      "Check the value and the unit of the column.");
  }
}

/// Far beyond every joint something else was measured or labelled, and products of such numbers
/// leave the range of doubles.
void check_sizes(const LevelsFile& file) {
  constexpr Sizes kEnergies{1e-30, 1e12};
  constexpr Sizes kDeviations{1e-24, 1e6};
  constexpr Sizes kStiffnesses{kSmallestStiffness, kLargestStiffness, false};
  const Levels& levels = file.levels;
  check_size(file, levels.amplitude, "amplitude", {1e-15, 1e6, false}, kLength);
  check_size(file, levels.amplitude_std, "amplitude_std", kDeviations, kLength);
  check_size(file, levels.dissipation, "dissipation", kEnergies, kEnergy);
  check_size(file, levels.dissipation_std, "dissipation_std", kEnergies, kEnergy);
  check_size(file, levels.linear_dissipation, "linear_dissipation", kEnergies, kEnergy);
  check_size(file, levels.secant_stiffness, "secant_stiffness", kStiffnesses, kStiffness);
  check_size(file, levels.secant_stiffness_std, "secant_stiffness_std",
             {kSmallestStiffness, kLargestStiffness}, kStiffness);
}

/// D of a level whose joint turns more than twice a cycle is not that of [AR14 (7)].
LevelsFile usable_levels(LevelsFile file, const LevelsIdentification& options) {
  if (options.use_inner_reversals) return file;
  LevelsFile usable = without_inner_reversals(file);
  if (usable.levels.size() > 0) return usable;
  throw FormatError({.file = file.file, .line = file.line.front(), .column = 0},
                    "a level with 2 reversals a cycle",
                    fmt::format("inner reversals in all {}", file.levels.size()),
                    "`inner_reversals use` takes them all the same.");
}

void warn_of_reversed(const LevelsFile& all, const LevelsIdentification& options,
                      std::vector<Warning>& warnings) {
  const std::vector<std::size_t> lines = all.lines_with_inner_reversals();
  if (lines.empty()) return;
  const bool used = options.use_inner_reversals;
  warnings.push_back(
      {used ? "inner_reversals_used" : "levels_left_out",
       fmt::format("{} of {} levels ({} {} of {}) have inner reversals; they were {}.",
                   lines.size(), all.levels.size(), lines.size() == 1 ? "line" : "lines",
                   fmt::join(lines, ", "), printable(all.file),
                   used ? "used all the same" : "left out")});
}

/// Flags that the levels used carry.
void warn_of_flags(const LevelsFile& file, std::vector<Warning>& warnings) {
  std::map<std::string, std::size_t> levels_with;
  for (const std::string& flags : file.flags) {
    std::istringstream words(flags);
    std::set<std::string> of_level;
    for (std::string flag; words >> flag;) of_level.insert(flag);
    for (const std::string& flag : of_level) ++levels_with[flag];
  }
  std::string text;
  for (const auto& [flag, count] : levels_with) {
    text += fmt::format("{}{} ({} of {})", text.empty() ? "" : ", ", printable(flag), count,
                        file.levels.size());
  }
  if (text.empty()) return;
  warnings.push_back(
      {"levels_flagged", "levels carry flags: " + text +
                             "; the summary of the command that wrote them says what they mean."});
}

/// What the levels are at fault for names their file.
Identification identified(const LevelsFile& file, const LevelsIdentification& options) {
  check_sizes(file);
  try {
    return identify(LevelEvidence(file.levels, options.texts.common_errors), options.stiffness,
                    options.options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", file.file, error.name()));
  }
}

}  // namespace

IdentifiedLevels identify_levels(const LevelsIdentification& options) {
  NamedInput input{options.levels, read_file(options.levels)};
  const bool linear_loss = options.texts.common_errors.loss_factor_std > 0.0;
  const LevelsFile all =
      parse_levels(input.text, input_name(options.levels), {.linear_dissipation = linear_loss});
  const LevelsFile file = usable_levels(all, options);
  IdentifiedLevels done{.input = std::move(input), .found = identified(file, options)};
  done.count = file.levels.size();
  done.reversed = all.lines_with_inner_reversals();
  warn_of_flags(file, done.found.warnings);
  warn_of_reversed(all, options, done.found.warnings);
  return done;
}

std::string joint_text(const Identification& found, const IdentificationOptions& options,
                       const NamedInput& input, std::string_view command,
                       const OptionTexts& texts) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  provenance.inputs.push_back({input.path, sha256(input.text)});
  provenance.options = record_of_options(options, texts);
  if (options.bands) provenance.seed = options.bands->seed;
  return format_joint({found.joint, provenance, record_of_identification(found)});
}

std::string describe_identified_levels(const LevelsIdentification& options,
                                       const IdentifiedLevels& done) {
  // What was done with levels that have inner reversals has a line of its own.
  Identification found = done.found;
  if (done.reversed.empty()) return describe_identification(found, done.count);
  found.warnings.pop_back();
  const bool one = done.reversed.size() == 1;
  return describe_identification(found, done.count) +
         line("inner reversals",
              fmt::format("{} level{} (line{} {}){}", done.reversed.size(), one ? "" : "s",
                          one ? "" : "s", fmt::join(done.reversed, ", "),
                          options.use_inner_reversals
                              ? ", used all the same"
                              : ", left out; `inner_reversals use` takes them"));
}

}  // namespace microslip
