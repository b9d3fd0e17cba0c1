// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/identify/assemblies.hpp"
#include "microslip/identify/assembly_start.hpp"

/// @file
/// What assemblies must be. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// k of each assembly, and where it comes from.
/// @param stiffness  of those that have none of their own.
/// @throws InputError  where it is missing, or told of some assemblies only.
[[nodiscard]] StiffnessOfAssemblies stiffness_of_assemblies(std::span<const Assembly> assemblies,
                                                            std::optional<double> stiffness);

}  // namespace microslip
