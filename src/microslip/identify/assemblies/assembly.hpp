// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "microslip/observe/level_evidence.hpp"

/// @file
/// Nominally equal assemblies of a joint, as input of their identification.

namespace microslip {

/// The least number of assemblies that identify_assemblies() takes: two give one difference, and
/// one number hardly determines a spread.
inline constexpr std::size_t kFewestAssemblies = 3;

/// Measured levels of one assembly of a joint.
struct Assembly {
  std::string name;                      ///< for messages and files; unique
  LevelEvidence levels;                  ///< one level will do
  std::optional<double> stiffness = {};  ///< k of this assembly, N/m, where it is known; > 0
};

/// Source of the stiffnesses of assemblies.
enum class AssemblyStiffness {
  kGiven,   ///< one given for each
  kSought,  ///< their ratios from k_eq; their geometric mean as given
  kCommon,  ///< one given for all: how they differ is not known
};

}  // namespace microslip
