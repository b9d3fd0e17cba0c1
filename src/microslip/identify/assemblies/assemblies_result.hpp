// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/assemblies/assembly.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// A standard deviation between assemblies, of a logarithm: 0.1 is 10 %.
struct Spread {
  double median = 0.0;  ///< of the draws
  double lower = 0.0;   ///< half of the draws outside the interval lie below
  double upper = 0.0;   ///< and the other half above
};

/// A density at AssembliesResult::slip_force with its band. That of the next assembly is the median
/// of the draws.
struct BandedDensity {
  std::vector<double> density = {};  ///< mean of the draws, 1/N
  std::vector<double> lower = {};    ///< 1/N
  std::vector<double> upper = {};    ///< 1/N
};

/// Result of one assembly. Deviations are from the middle of the measured assemblies.
struct AssemblyFit {
  std::string name;                ///< as given
  Estimate stiffness = {};         ///< k, N/m
  Estimate slip_force_scale = {};  ///< S, over the geometric mean of all, 1
  Estimate shape = {};             ///< rms of ln of the density over that of the middle, 1
  BandedDensity density = {};      ///< its own
  double covered_from = 0.0;       ///< kA_min, N
  double covered_to = 0.0;         ///< kA_max, N
  LevelRows value = {};            ///< fitted D, J, at LevelEvidence::levels()
};

/// A possible joint of the next assembly.
struct AssemblyJoint {
  double stiffness = 0.0;            ///< k, N/m
  std::vector<double> density = {};  ///< ψ at AssembliesResult::slip_displacement, N/m per m
};

/// Result of identify_assemblies().
struct AssembliesResult {
  double stiffness = 0.0;  ///< k of the middle, geometric mean of the assemblies', N/m
  AssemblyStiffness stiffness_from = AssemblyStiffness::kGiven;  ///< how k are known
  std::vector<double> slip_force = {};  ///< of all densities, N; from 0 to the largest k_j A_max,j
  BandedDensity common = {};            ///< of the middle of the assemblies
  BandedDensity next = {};              ///< of another assembly: the band contains it
  double covered_from = 0.0;            ///< least kA_min/S of all assemblies, N
  double covered_to = 0.0;              ///< largest kA_max/S of all assemblies, N

  std::optional<Spread> stiffness_spread = {};  ///< of ln k; nothing with kCommon
  Spread slip_force_spread = {};                ///< of ln S
  Spread shape_spread = {};                     ///< of ln of the density at any place

  std::vector<AssemblyFit> assemblies = {};    ///< as given
  std::vector<double> slip_displacement = {};  ///< x* of `draws`, m
  std::vector<AssemblyJoint> draws = {};       ///< of the next assembly; each a feasible joint

  double scatter = 0.0;                ///< of D: of all levels about the fit, 1
  bool scatter_is_relative = true;     ///< to D; else to the standard deviations given
  double confidence = 0.0;             ///< of bands and intervals
  double effective_draws = 0.0;        ///< the fewest independent draws of a spread
  std::vector<Warning> warnings = {};  ///< where assemblies or levels are few
  Summary summary = {};                ///< of the method

  /// The joint in the middle: the mean of the draws up to `covered_to`.
  [[nodiscard]] Joint joint() const;
  /// The joint of an assembly, up to its own `covered_to`. @param assembly  from 0.
  [[nodiscard]] Joint joint(std::size_t assembly) const;
};

}  // namespace microslip
