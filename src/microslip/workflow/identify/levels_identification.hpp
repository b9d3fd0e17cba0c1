// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/observe/common_errors.hpp"
#include "microslip/workflow/identify/recorded_options.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

/// @file
/// levels.csv to joint.json and density.csv.

namespace microslip {

/// Inputs and options of identify_levels().
struct LevelsIdentification {
  std::string levels = {};             ///< path of levels.csv; "-" is standard input
  double stiffness = 0.0;              ///< k of the stuck joint, N/m; > 0
  IdentificationOptions options = {};  ///< of the method
  /// Takes levels with inner reversals, too, whose D is not that of one loop [AR14 (7)].
  bool use_inner_reversals = false;
  AssemblyColumn assemblies = AssemblyColumn::kUnsaid;  ///< how the column `assembly` is taken
  CommonErrors errors = {};                             ///< that all levels share
  OptionTexts texts = {};                               ///< of options, for joint.json
};

/// Result of identify_levels().
struct IdentifiedLevels {
  NamedInput input;                        ///< as read
  Identification found;                    ///< with warnings of the file, too
  std::size_t count = 0;                   ///< levels that were used
  std::vector<std::size_t> reversed = {};  ///< lines of those with inner reversals
  /// Of these; among the warnings of `found`, too.
  std::optional<Warning> reversed_warning = {};
};

/// Reads the levels and identifies the joint.
/// @throws FileError, FormatError  as read_level_table().
/// @throws InputError  as identify(); what the levels are at fault for names their file.
/// @throws Cancelled   as the progress of the options says.
[[nodiscard]] IdentifiedLevels identify_levels(const LevelsIdentification& options);

/// Identifies from levels that were read before.
/// @param table    of identify_levels(); `levels` of the options is not looked at.
/// @param options  as of identify_levels().
/// @throws FormatError, InputError, Cancelled  as identify_levels().
[[nodiscard]] IdentifiedLevels identify_table(LevelTable table,
                                              const LevelsIdentification& options);

/// Contents of joint.json.
/// @param options  that it was found with.
/// @param found    with its warnings.
/// @param inputs   the levels; empty where they came from no file.
/// @param command  that the file is made by.
[[nodiscard]] JointFile identified_joint(const LevelsIdentification& options,
                                         const Identification& found,
                                         const std::vector<NamedInput>& inputs,
                                         std::string_view command);

/// The text of joint.json.
/// @param options  that it was found with.
/// @param found    with its warnings.
/// @param input    the levels.
/// @param command  that the file is made by.
[[nodiscard]] std::string joint_text(const LevelsIdentification& options,
                                     const Identification& found, const NamedInput& input,
                                     std::string_view command);

/// The bytes of joint_samples.h5.
/// @param options  that it was found with.
/// @param found    with its draws.
/// @param input    the levels.
/// @param command  that the file is made by.
/// @param path     of the file.
/// @throws InputError  as joint_samples(). @throws FileError  as joint_samples_bytes().
[[nodiscard]] std::string samples_bytes(const LevelsIdentification& options,
                                        const Identification& found, const NamedInput& input,
                                        std::string_view command, const std::string& path);

/// The summary.
[[nodiscard]] std::string describe_identified_levels(const LevelsIdentification& options,
                                                     const IdentifiedLevels& done);

}  // namespace microslip
