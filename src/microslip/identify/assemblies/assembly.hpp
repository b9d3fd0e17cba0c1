// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "microslip/observe/level_evidence.hpp"

/// @file
/// Assemblies of one kind of joint: what is given of each.

namespace microslip {

/// The least number of assemblies that identify_assemblies() takes: of two there is one difference,
/// and a spread of one number is hardly told.
inline constexpr std::size_t kFewestAssemblies = 3;

/// What was measured of one assembly of a joint.
struct Assembly {
  std::string name;                      ///< for messages and files; each its own
  LevelEvidence levels;                  ///< one level will do
  std::optional<double> stiffness = {};  ///< k of this assembly, N/m, where it is known; > 0
};

/// Where the stiffnesses of assemblies come from.
enum class AssemblyStiffness {
  kGiven,   ///< each its own, as given
  kSought,  ///< their ratios by k_eq; their geometric mean is the one that was given
  kCommon,  ///< all have the one that was given: what they differ by is not known
};

}  // namespace microslip
