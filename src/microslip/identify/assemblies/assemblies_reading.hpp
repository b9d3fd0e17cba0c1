// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/identify/assemblies/assemblies_options.hpp"
#include "microslip/identify/assemblies/assemblies_result.hpp"
#include "microslip/identify/assemblies/assembly.hpp"
#include "microslip/identify/assemblies/assembly_chain.hpp"
#include "microslip/identify/assemblies/assembly_start.hpp"
#include "microslip/identify/assemblies/assembly_stiffness.hpp"

/// @file
/// Results from draws of assemblies. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// The draws and all data that a result is computed from.
struct DrawnAssemblies {
  std::span<const Assembly> assemblies;
  const StiffnessOfAssemblies& stiffness;
  const StartOfAssemblies& start;
  std::span<const AssemblyDraw> draws;
  const AssembliesOptions& options;
  std::size_t chain;  ///< draws of a chain
};

/// Densities, spreads and draws of the next assembly, with warnings where assemblies are few. Draw
/// i of the next is a function of (seed, i) and of draw i of the others.
void read_assemblies(const DrawnAssemblies& drawn, AssembliesResult& result);

}  // namespace microslip
