// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/config/json_texts.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// joint.json, schema microslip.joint/1: a joint, how it came to be, and what its identification
/// knows.

namespace microslip {

/// Contents of a joint.json.
struct JointFile {
  Joint joint;                           ///< the joint itself
  std::optional<Provenance> provenance;  ///< origin of the file; nothing where it is not given
  NamedValues identification;  ///< range covered, remainder, bands…; empty where the file has none
};

/// The key of kA of the highest level in an identification, N.
inline constexpr std::string_view kCoveredToKey = "covered_to_N";

/// kA of the highest level that the joint was identified from, N; nothing where the file does not
/// give it.
[[nodiscard]] std::optional<double> covered_to(const JointFile& file);

/// The key of β in an identification.
inline constexpr std::string_view kLinearDampingKey = "linear_damping_J_per_m2";
/// The largest β that is read, J/m²: beyond all that joins.
inline constexpr double kLargestLinearDamping = 1e15;

/// The key of c in an identification, N s/m: a viscous part that was identified in addition to the
/// friction.
inline constexpr std::string_view kViscousKey = "viscous_N_s_per_m";

/// β of D = … + βA², J/m²: the loss in addition to slip that was identified with the joint;
/// nothing where the file does not give it. A prediction with the joint adds it
/// (StructuralJoint::linear_damping).
/// @throws InputError  where a viscous part c > 0 was identified too: predictions do not support
///                     it, and would silently be wrong.
[[nodiscard]] std::optional<double> identified_damping(const JointFile& file);

/// c of a viscous part that was identified in addition to the friction, N s/m; 0 where the file
/// gives none.
[[nodiscard]] double identified_viscous(const JointFile& file);

/// A joint from the text of a joint.json.
/// @throws FormatError  for text that is no JSON, another schema, keys unknown or missing.
/// @throws InputError   naming `file: density[i].key` for a value of a wrong type or one that
///                      breaks a rule of SlipDensity or Joint; for a β in the identification that
///                      is no number from 0 to kLargestLinearDamping.
[[nodiscard]] JointFile parse_joint(std::string_view text, std::string_view file);

/// parse_joint() of a file; "-" is standard input. @throws FileError, FormatError, InputError
[[nodiscard]] JointFile read_joint(const std::string& path);

/// The text that parse_joint() reads back as the same: numbers are the shortest that read back as
/// the same double, keys come in a fixed order, nothing depends on the clock or the locale.
/// @throws InputError  where a value of the records is not finite or no JSON.
[[nodiscard]] std::string format_joint(const JointFile& file);

}  // namespace microslip
