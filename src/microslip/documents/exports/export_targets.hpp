// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "microslip/documents/exports/exported_joint.hpp"

namespace microslip {

/// A program or language that joints are exported to.
struct ExportTarget {
  std::string_view name;    ///< as an option has it: "calculix"
  std::string_view words;   ///< what is written
  std::string_view ending;  ///< usual of a file: ".inp"
  bool si_only = false;     ///< whether the language fixes the units
  /// The file.
  std::string (*text)(const ExportedJoint& joint) = nullptr;
  /// Why no joint is exported to it; empty where one is.
  std::string_view reason = {};
  /// Words of the language that are no names there.
  std::span<const std::string_view> reserved = {};
  std::size_t longest_name = kLongestExportedName;   ///< letters
  std::size_t largest_number = kLargestFirstNumber;  ///< of ExportedJoint::first_number
  /// Letters of the name of a file without its ending, where the program calls it by that.
  std::size_t longest_file = std::numeric_limits<std::size_t>::max();
  /// Whether it is an archive that is handed on: it tells nothing of where it was made, and no
  /// terminal shows it.
  bool archive = false;
};

/// All of them, also those that are known and refused.
[[nodiscard]] std::span<const ExportTarget> all_export_targets();

/// The target of a name. @throws InputError  where there is none of this name, or with the reason
///                                           where no joint can be exported to it.
[[nodiscard]] const ExportTarget& export_target(std::string_view name);

/// A name for a joint in a target, made of any text: name_in_exports(), not longer than it may be,
/// and with `_joint` behind a reserved word.
[[nodiscard]] std::string name_for_target(const ExportTarget& target, std::string_view text);

/// The joint as the input of a target.
/// @throws InputError  where the units are not those that the language fixes, the name is a word of
///                     the language or too long for it, or the first number is too large.
[[nodiscard]] std::string export_text(const ExportTarget& target, const ExportedJoint& joint);

}  // namespace microslip
