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

/// An identified joint.
struct CalibratedJoint {
  std::string name;                            ///< of the joint in the structure
  std::size_t index = 0;                       ///< among the joints of the structure
  Joint joint;                                 ///< the mean of the draws
  std::vector<double> slip_displacement = {};  ///< knots x*, m; from 0 to the largest amplitude
  std::vector<double> density = {};            ///< ψ = k²φ(kx*), N/m per m
  std::vector<double> lower = {};              ///< of its band
  std::vector<double> upper = {};              ///< of its band
  DensityBand band = {};                       ///< of φ at f* = k x*, 1/N
  /// Variance reduction: share of the prior's variance of ψ that the levels remove, at the knots,
  /// 1: 0 where they do not determine this joint, 1 where they determine it fully.
  std::vector<double> variance_reduction = {};
  /// Its loss over the standard deviation of that over the draws, 1, at the level where it is
  /// largest.
  double loss_significance = 0.0;
  Estimate stiffness = {};              ///< k, N/m
  Estimate elastic_stiffness = {};      ///< K_e, N/m: the part that does not slip within the levels
  std::vector<DensityEdge> edges = {};  ///< rising; those of the draws vary by their uncertainty
  /// Decrease of −2 ln of the likelihood by all of them, 1; 17 and more each.
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

/// A level as measured and as fitted.
struct CalibratedLevel {
  bool found = false;               ///< whether the structure has the resonance
  double frequency = 0.0;           ///< of the structure with the identified joints, Hz
  double measured_frequency = 0.0;  ///< Hz; NaN without
  /// Mean frequency offset of its mode and session, relative; NaN without.
  double frequency_offset = std::numeric_limits<double>::quiet_NaN();
  double dissipation = 0.0;               ///< of all joints together, J
  double measured_dissipation = 0.0;      ///< J; of ζ minus the loss of the structure
  double measured_dissipation_std = 0.0;  ///< J; NaN where it was not given
  /// Standard deviation of D of the level, J: σ where all are known, times the scatter of the
  /// losses over it where that is above 1; else the relative scatter times D or, for ζ, times the
  /// loss of structure and joints. NaN where the level was not found.
  double loss_noise = std::numeric_limits<double>::quiet_NaN();
  double damping_ratio = 0.0;  ///< ζ of structure and joints, 1
  double residual = 0.0;       ///< of the dissipation, over its standard deviation, 1
  /// Residual of the frequency, over its standard deviation, 1; NaN without.
  double frequency_residual = 0.0;
  std::vector<JointAtLevel> joints{};  ///< one per joint of the structure
};

/// Two joints that the levels hardly distinguish.
struct JointPair {
  std::size_t first = 0;         ///< among the identified joints
  std::size_t second = 0;        ///< among the identified joints
  double correlation = 0.0;      ///< of their D over the draws, median of the levels, 1
  double spread_alone = 0.0;     ///< of D of the better known, relative, median of the levels, 1
  double spread_together = 0.0;  ///< of D of both together, relative, median of the levels, 1
  /// The sum is known several times better than either: only the sum is reliable.
  bool known_only_together = false;
};

/// Resolution of a resonance, relative: a smaller offset is none.
inline constexpr double kFrequencyResolution = 1e-4;

/// Frequencies of the modes of a structure without its joints against those that were given, one
/// entry each; empty where nothing is known of them.
struct FoundModes {
  std::vector<double> offset = {};     ///< of ln ω_i, 1
  std::vector<double> deviation = {};  ///< standard deviation of it, 1
  /// Of half of ln k_s of the spring that the modes have across each joint, 1; empty: none.
  std::vector<double> springs = {};

  /// Whether any offset is above kFrequencyResolution.
  [[nodiscard]] bool any() const;
};

/// Result of calibrate().
struct CalibrationResult {
  std::vector<CalibratedJoint> joints = {};  ///< those that were sought, in the structure's order
  std::vector<CalibratedLevel> levels = {};  ///< in the order given
  std::vector<JointPair> pairs = {};         ///< all pairs of identified joints
  /// With three or more identified joints: those whose loss is known far less well than that of
  /// all.
  std::vector<std::size_t> known_in_sum = {};
  /// Mean frequency offset of each mode, relative; NaN for modes without frequencies.
  std::vector<double> frequency_offset = {};
  /// The offsets of the modes without joints that explain these; where frequencies count by their
  /// change. Where they are above kFrequencyResolution the joints are those of the structure with
  /// them.
  FoundModes modes = {};
  double loss_scatter = 0.0;  ///< of the losses: over σ where given, else relative
  /// Scatter of the frequencies: over σ where given, else relative; 0 without.
  double frequency_scatter = 0.0;
  /// Scatter of displacements of joints by sensors over their σ; 0 where none has one.
  double sensor_scatter = 0.0;
  bool loss_std_given = false;       ///< whether σ of all losses was known
  bool frequency_std_given = false;  ///< whether σ of all frequencies was known
  bool edges_sought = false;         ///< whether edges were requested and the levels sufficient
  double edf = 0.0;                  ///< effective degrees of freedom of all densities together
  double confidence = 0.0;           ///< of the bands
  /// Levels of the warnings `level_outlier`, from 0, in their order.
  std::vector<std::size_t> outliers = {};
  std::vector<Warning> warnings = {};  ///< see diagnose()
  Summary summary = {};                ///< residual: last change of an amplitude, relative
};

}  // namespace microslip
