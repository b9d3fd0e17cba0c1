// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/identify/assemblies/assemblies_options.hpp"
#include "microslip/identify/assemblies/assemblies_result.hpp"
#include "microslip/identify/assemblies/assembly.hpp"

namespace microslip {

/// Checks the arguments of identify_assemblies() before anything is computed.
/// @param assemblies, stiffness  as for identify_assemblies().
/// @throws InputError  as identify_assemblies().
void check_assemblies(std::span<const Assembly> assemblies, std::optional<double> stiffness = {});

/// Identifies the joints of several assemblies of one kind together. Assembly j has
///
///     φ_j(f*) = (1/S_j) φ(f*/S_j) e^{g_j(f*/S_j)},
///     ln S_j ~ N(0, σ_S²),  ln k_j ~ N(ln k, σ_k²),  g_j ~ a Gaussian process of variance σ_g²,
///
/// with φ as invert() seeks it but without edges, and g_j smooth: it may bend two or three times
/// over the range of the levels. Where levels of one assembly differ as much as those of two, no
/// spread is found. φ, S_j, g_j, the scatter of D, one of all assemblies, and the spreads are
/// drawn together; priors of the spreads see SpreadPrior: they are log-uniform from 0.5 % to a
/// factor of 1.6, and fall beyond as 1/σ³. The middle is that of the measured assemblies; as the
/// middle of all possible assemblies it has the standard deviation σ/√J, which adds to the
/// deviation of the next one.
/// @param assemblies  kFewestAssemblies or more; together kFewestLevels amplitudes or more.
/// @param stiffness   k of assemblies that have none of their own, N/m; > 0. Where all have k_eq,
///                    its differences between assemblies determine ratios of k, and this is their
///                    geometric mean.
/// @param options     how it is solved.
/// @throws InputError  naming the assembly and the rule that is broken.
/// @throws Cancelled   when the progress callback returns false.
[[nodiscard]] AssembliesResult identify_assemblies(std::span<const Assembly> assemblies,
                                                   std::optional<double> stiffness = {},
                                                   const AssembliesOptions& options = {});

}  // namespace microslip
