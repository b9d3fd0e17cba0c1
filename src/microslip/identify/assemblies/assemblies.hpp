// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/identify/assemblies/assemblies_options.hpp"
#include "microslip/identify/assemblies/assemblies_result.hpp"
#include "microslip/identify/assemblies/assembly.hpp"

namespace microslip {

/// What can be checked before anything is computed.
/// @param assemblies  as for identify_assemblies(). @param stiffness  likewise.
/// @throws InputError  as that.
void check_assemblies(std::span<const Assembly> assemblies, std::optional<double> stiffness = {});

/// Identifies the joints of several assemblies of one kind together. Assembly j has
///
///     φ_j(f*) = (1/S_j) φ(f*/S_j) e^{g_j(f*/S_j)},
///     ln S_j ~ N(0, σ_S²),  ln k_j ~ N(ln k, σ_k²),  g_j ~ a Gaussian process of variance σ_g²,
///
/// with φ as invert() seeks it but without edges, and g_j smooth: it may bend two or three times
/// over the range of the levels. Where two levels of one assembly are as different as those of
/// two, no spread is found. φ, S_j, g_j, the scatter of D, one of all assemblies, and the spreads
/// are drawn together; priors of the spreads see SpreadPrior: they are log-uniform from 0.5 % to
/// a factor of 1.6, and fall beyond as 1/σ³. The middle is that of the assemblies that were
/// measured; of all assemblies there may be it is known to σ/√J, which the next one has on top of
/// its own deviation.
/// @param assemblies  kFewestAssemblies or more; together kFewestLevels amplitudes or more.
/// @param stiffness   k of assemblies that have none of their own, N/m; > 0. Where all have k_eq,
///                    its differences between assemblies tell ratios of k, and this is their
///                    geometric mean.
/// @param options     how it is solved.
/// @throws InputError  naming the assembly and what breaks a rule.
/// @throws Cancelled   as the progress callback says.
[[nodiscard]] AssembliesResult identify_assemblies(std::span<const Assembly> assemblies,
                                                   std::optional<double> stiffness = {},
                                                   const AssembliesOptions& options = {});

}  // namespace microslip
