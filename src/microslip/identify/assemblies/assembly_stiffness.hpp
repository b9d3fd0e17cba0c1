// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/assemblies/assembly.hpp"

/// @file
/// What is known of the stiffnesses of assemblies. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// What is known of the stiffnesses before anything is fitted.
struct StiffnessOfAssemblies {
  AssemblyStiffness from = AssemblyStiffness::kGiven;
  double middle = 0.0;            ///< kₘ, geometric mean, N/m
  Eigen::VectorXd log_stiffness;  ///< ln κ of each, as known or as its k_eq begin with
};

/// k of each assembly, and where it comes from.
/// @param stiffness  of those that have none of their own.
/// @throws InputError  where it is missing, or told of some assemblies only.
[[nodiscard]] StiffnessOfAssemblies stiffness_of_assemblies(std::span<const Assembly> assemblies,
                                                            std::optional<double> stiffness);

}  // namespace microslip
