// SPDX-License-Identifier: MIT
#pragma once

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
};

/// All of them, also those that are known and refused.
[[nodiscard]] std::span<const ExportTarget> all_export_targets();

/// The target of a name. @throws InputError  where there is none of this name, or with the reason
///                                           where no joint can be exported to it.
[[nodiscard]] const ExportTarget& export_target(std::string_view name);

/// The joint as the input of a target.
/// @throws InputError  where the units are not those that the language fixes.
[[nodiscard]] std::string export_text(const ExportTarget& target, const ExportedJoint& joint);

}  // namespace microslip
