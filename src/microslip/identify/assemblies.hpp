// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/record_inversion.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

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

/// How identify_assemblies() solves.
struct AssembliesOptions {
  int coefficients = 56;     ///< of the density; ≥ 10. More change nothing but the time.
  std::size_t draws = 1000;  ///< of the posterior; ≥ 100
  double confidence = 0.95;  ///< of bands and intervals, in (0, 1)
  std::uint64_t seed = 1;    ///< of the draws
  Execution execution = Execution::threads();  ///< of the chains
  Progress progress = {};                      ///< of the draws

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

/// Where the stiffnesses of assemblies come from.
enum class AssemblyStiffness {
  kGiven,   ///< each its own, as given
  kSought,  ///< their ratios by k_eq; their geometric mean is the one that was given
  kCommon,  ///< all have the one that was given: what they differ by is not known
};

/// A standard deviation between assemblies, of a logarithm: 0.1 is 10 %.
struct Spread {
  double median = 0.0;  ///< of the draws
  double lower = 0.0;   ///< half of what the interval leaves out is below
  double upper = 0.0;   ///< and the other half above
};

/// A density at AssembliesResult::slip_force with its band. That of the next assembly is the median
/// of the draws.
struct BandedDensity {
  std::vector<double> density = {};  ///< mean of the draws, 1/N
  std::vector<double> lower = {};    ///< 1/N
  std::vector<double> upper = {};    ///< 1/N
};

/// What came of one assembly. Deviations are from the middle of those that were measured.
struct AssemblyFit {
  std::string name;                ///< as given
  Estimate stiffness = {};         ///< k, N/m
  Estimate slip_force_scale = {};  ///< S, over the geometric mean of all, 1
  Estimate shape = {};             ///< rms of ln of the density over that of the middle, 1
  BandedDensity density = {};      ///< its own
  double covered_from = 0.0;       ///< kA_min, N
  double covered_to = 0.0;         ///< kA_max, N
  LevelRows value = {};            ///< D as found, J, at LevelEvidence::levels()
};

/// A joint that the next assembly may be.
struct AssemblyJoint {
  double stiffness = 0.0;            ///< k, N/m
  std::vector<double> density = {};  ///< ψ at AssembliesResult::slip_displacement, N/m per m
};

/// What identify_assemblies() found.
struct AssembliesResult {
  double stiffness = 0.0;  ///< k of the middle, geometric mean of the assemblies', N/m
  AssemblyStiffness stiffness_from = AssemblyStiffness::kGiven;  ///< how k are known
  std::vector<double> slip_force = {};  ///< of all densities, N; from 0 to the largest k_j A_max,j
  BandedDensity common = {};            ///< of the middle of the assemblies
  BandedDensity next = {};              ///< of another assembly: the band holds that one
  double covered_from = 0.0;            ///< least kA_min/S of all assemblies, N
  double covered_to = 0.0;              ///< largest kA_max/S of all assemblies, N

  std::optional<Spread> stiffness_spread = {};  ///< of ln k; nothing with kCommon
  Spread slip_force_spread = {};                ///< of ln S
  Spread shape_spread = {};                     ///< of ln of the density at any place

  std::vector<AssemblyFit> assemblies = {};    ///< as given
  std::vector<double> slip_displacement = {};  ///< x* of `draws`, m
  std::vector<AssemblyJoint> draws = {};       ///< of the next assembly; each a feasible joint

  double scatter = 0.0;                ///< of D: of all levels about those found, 1
  bool scatter_is_relative = true;     ///< to D; else to the standard deviations given
  double confidence = 0.0;             ///< of bands and intervals
  double effective_draws = 0.0;        ///< the least that the spreads' draws are worth
  std::vector<Warning> warnings = {};  ///< what few assemblies, or levels, leave open
  Summary summary = {};                ///< of the method

  /// The joint in the middle: the mean of the draws up to `covered_to`.
  [[nodiscard]] Joint joint() const;
  /// The joint of an assembly, up to its own `covered_to`. @param assembly  from 0.
  [[nodiscard]] Joint joint(std::size_t assembly) const;
};

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
