// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

/// A slip force at which a density jumps.
struct DensityEdge {
  double slip_force = 0.0;  ///< N
  double deviation = 0.0;   ///< its standard deviation, N
};

/// A joint that was found.
struct CalibratedJoint {
  std::string name;                            ///< of the joint in the structure
  std::size_t index = 0;                       ///< among the joints of the structure
  Joint joint;                                 ///< the mean of the draws
  std::vector<double> slip_displacement = {};  ///< knots x*, m; from 0 to the largest amplitude
  std::vector<double> density = {};            ///< ψ = k²φ(kx*), N/m per m
  std::vector<double> lower = {};              ///< of its band
  std::vector<double> upper = {};              ///< of its band
  DensityBand band = {};                       ///< of φ at f* = k x*, 1/N
  /// Share of the prior's variance of ψ that the levels took, at the knots, 1: 0 where they tell
  /// nothing of this joint, 1 where they tell all.
  std::vector<double> told = {};
  /// Its loss over the standard deviation of it over the draws, 1, at the level where that is most.
  double loss_told = 0.0;
  Estimate stiffness = {};              ///< k, N/m
  Estimate elastic_stiffness = {};      ///< K_e, N/m: what does not slip within the levels
  std::vector<DensityEdge> edges = {};  ///< rising; the draws have theirs as far off as they may be
  /// By what −2 ln of the likelihood falls with all of them, 1; 17 and more each.
  double edges_evidence = 0.0;
  double exponent = 0.0;               ///< χ₀ of the prior
  double edf = 0.0;                    ///< effective degrees of freedom of its density
  double least_amplitude = 0.0;        ///< of the levels, m
  double largest_amplitude = 0.0;      ///< of the levels, m
  std::vector<StiffnessDraw> draws{};  ///< ψ at the knots; each a feasible joint
};

/// A joint at a level.
struct JointAtLevel {
  double amplitude = 0.0;           ///< half range of its displacement, m
  double measured_amplitude = 0.0;  ///< by a sensor, m; NaN without
  Estimate dissipation = {};        ///< D, J
};

/// A level as measured and as found.
struct CalibratedLevel {
  bool found = false;               ///< whether the structure has the resonance
  double frequency = 0.0;           ///< of the structure with the joints found, Hz
  double measured_frequency = 0.0;  ///< Hz; NaN without
  /// What those of its mode and session are off by, relative, the mean; NaN without.
  double frequency_offset = std::numeric_limits<double>::quiet_NaN();
  double dissipation = 0.0;               ///< of all joints together, J
  double measured_dissipation = 0.0;      ///< J; of ζ less the loss of the structure
  double measured_dissipation_std = 0.0;  ///< J; NaN where it was not given
  /// What D of the level scatters by, J: σ where all are known, times what losses scatter by over
  /// it where that is above 1; else that share of D or, of ζ, of the loss of structure and joints.
  /// NaN where the level was not found.
  double loss_noise = std::numeric_limits<double>::quiet_NaN();
  double damping_ratio = 0.0;          ///< ζ of structure and joints, 1
  double residual = 0.0;               ///< of the dissipation, over its standard deviation, 1
  double frequency_residual = 0.0;     ///< likewise; NaN without
  std::vector<JointAtLevel> joints{};  ///< one a joint of the structure
};

/// Two joints that the levels hardly tell apart.
struct JointPair {
  std::size_t first = 0;         ///< among the joints found
  std::size_t second = 0;        ///< among the joints found
  double correlation = 0.0;      ///< of their D over the draws, median of the levels, 1
  double spread_alone = 0.0;     ///< of D of the better known, relative, median of the levels, 1
  double spread_together = 0.0;  ///< of the sum of both, likewise
  /// The sum is known some times better than either: only that is to be believed.
  bool known_only_together = false;
};

/// What calibrate() found.
struct CalibrationResult {
  std::vector<CalibratedJoint> joints = {};  ///< those that were sought, in the structure's order
  std::vector<CalibratedLevel> levels = {};  ///< in the order given
  std::vector<JointPair> pairs = {};         ///< every two joints found
  /// Of three joints found and more: those whose loss is known far less well than that of all.
  std::vector<std::size_t> known_in_sum = {};
  /// What frequencies are off by in each mode, relative, the mean of its levels; NaN for
  /// modes without frequencies.
  std::vector<double> frequency_offset = {};
  double loss_scatter = 0.0;           ///< of the losses: over σ where given, else relative
  double frequency_scatter = 0.0;      ///< of the frequencies, likewise; 0 without
  bool loss_std_given = false;         ///< whether σ of all losses was known
  bool frequency_std_given = false;    ///< whether σ of all frequencies was known
  bool edges_sought = false;           ///< whether the levels were enough, and it was asked for
  double edf = 0.0;                    ///< effective degrees of freedom of all densities together
  double confidence = 0.0;             ///< of the bands
  std::vector<Warning> warnings = {};  ///< see diagnose()
  Summary summary = {};                ///< residual: last change of an amplitude, relative
};

}  // namespace microslip
