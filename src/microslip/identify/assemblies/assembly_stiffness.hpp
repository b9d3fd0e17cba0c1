// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/assemblies/assembly.hpp"

/// @file
/// Prior knowledge of the stiffnesses of assemblies. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// The stiffnesses before anything is fitted.
struct StiffnessOfAssemblies {
  AssemblyStiffness from = AssemblyStiffness::kGiven;
  double middle = 0.0;            ///< kₘ, geometric mean, N/m
  Eigen::VectorXd log_stiffness;  ///< ln κ of each, as known, or by its mean k_eq to start with
};

/// k of each assembly, and its source.
/// @param stiffness  of those that have none of their own.
/// @throws InputError  where it is missing, or given for some assemblies only.
[[nodiscard]] StiffnessOfAssemblies stiffness_of_assemblies(std::span<const Assembly> assemblies,
                                                            std::optional<double> stiffness);

}  // namespace microslip
