// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/assemblies/assembly.hpp"
#include "microslip/identify/assemblies/assembly_chain.hpp"
#include "microslip/identify/assemblies/assembly_model.hpp"
#include "microslip/identify/assemblies/assembly_stiffness.hpp"

/// @file
/// Start of the draws of assemblies. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// The levels of all assemblies over each other, and the model of them with its weights.
struct StartOfAssemblies {
  AssemblyModel model;
  AssemblyStart start = {};
  double covered = 0.0;  ///< largest scaled amplitude of a level, below the last knot
};

/// Scales the amplitudes of all assemblies such that their D lie on one curve, in turn with the
/// inversion of all levels together, which gives knots, prior and smoothing. The knots go on above
/// the levels as far as scales differ: an assembly with smaller slip forces than the others covers
/// them.
/// @param levels     of each assembly; must outlive the result.
/// @throws InputError  where they are too few.
[[nodiscard]] StartOfAssemblies start_of_assemblies(std::span<const Assembly> assemblies,
                                                    const StiffnessOfAssemblies& stiffness,
                                                    int coefficients);

}  // namespace microslip
