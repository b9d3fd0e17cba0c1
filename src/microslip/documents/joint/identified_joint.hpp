// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// The identification of a joint as joint.json holds it. All values are SI.

namespace microslip {

/// A departure from the kind of joint, as it was looked for in a record or in levels.
struct DepartureFound {
  std::string departure = {};  ///< its code: "rate_dependent"
  double share = 0.0;          ///< of the force, or of what the levels tell, that it explains, 1
  double noise = 0.0;          ///< that it would of noise alone, 1
  bool broken = false;         ///< whether it is there
};

/// Results of the identification for a record of force and displacement.
struct RecordFound {
  std::string source = {};  ///< its file, as its call named it
  double input = 0.0;       ///< its file among the inputs of the provenance, from 1; 0: not known
  std::string start = {};   ///< "virgin" or "unknown": the state it begins in
  std::string start_from = {};                  ///< who says so: "shown", "given", "assumed"
  double scatter = 0.0;                         ///< of the force of one sample, N
  double correlation = 0.0;                     ///< of neighbouring residuals, 1
  double unexplained = 0.0;                     ///< rms of residuals over that of the force, 1
  std::vector<double> offset = {};              ///< F₀ of each group of samples, N
  std::vector<double> displacement_drift = {};  ///< SensorDrift::displacement subtracted, m
  std::vector<double> force_drift = {};         ///< SensorDrift::force subtracted, N
  std::vector<DepartureFound> verdicts = {};    ///< the weightiest first
};

/// A table of levels that a joint was identified from together with other evidence.
struct TableFound {
  double scatter = 0.0;                       ///< of D, in the unit that follows
  bool scatter_is_relative = true;            ///< to D; in the standard deviations given otherwise
  std::vector<DepartureFound> verdicts = {};  ///< of "dissipation" and "secant_stiffness"
};

/// A value with the ends of its band.
struct BandedValue {
  double value = 0.0;  ///< in the unit of all three
  double lower = 0.0;  ///< end of the band
  double upper = 0.0;  ///< the other end
};

/// Results of an identification from records of force and displacement.
struct FoundByRecords {
  std::optional<BandedValue> stiffness = {};      ///< k, N/m; nothing where it was given
  std::optional<BandedValue> elastic = {};        ///< K_e, N/m
  std::optional<BandedValue> viscous = {};        ///< c, N s/m; nothing where it was not sought
  std::optional<double> reference_exponent = {};  ///< of the prior of the density, 1
  std::vector<RecordFound> records = {};          ///< one per record
  std::vector<TableFound> tables = {};            ///< one per table of levels
};

/// The values of λ that were compared. Vectors of one length.
struct SmoothingPath {
  std::vector<double> lambda = {};              ///< λ, as the method scales it
  std::vector<double> degrees_of_freedom = {};  ///< of the fit, 1
  std::vector<double> residual = {};            ///< weighted sum of squares, 1
  std::vector<double> gcv = {};                 ///< criterion of generalised cross-validation
};

/// Bands of what levels determine in addition to the density.
struct LevelBandsFound {
  double effective_samples = 0.0;                         ///< independent draws as good as those
  std::pair<double, double> area = {};                    ///< Φ0, 1
  std::optional<std::pair<double, double>> damping = {};  ///< β, J/m²
  std::optional<std::pair<double, double>> atom = {};     ///< weight of the atom, 1
};

/// Measured k_eq and frequencies beside those of the joint.
struct StiffnessFound {
  double offset = 0.0;      ///< of k_eq, N/m
  double offset_std = 0.0;  ///< its standard deviation, N/m
};

/// Measured frequencies beside those that the joint explains, see FrequencyEvidence.
struct FrequenciesFound {
  double rise = 0.0;                    ///< the largest, relative
  double fall_unexplained = 0.0;        ///< the largest, relative
  double softening_share = 0.0;         ///< of the softening of the joint, 1
  double uncertainty = 0.0;             ///< of a resonance, Hz
  double equivalent_joint_error = 0.0;  ///< of a resonance, Hz
};

/// A parameter of a parametric model, in SI.
struct ParameterFound {
  std::string name = {};             ///< "macroslip_force"
  double value = 0.0;                ///< the best
  std::optional<double> error = {};  ///< standard error; 0 at the end of its range
};

/// Results for one of several assemblies, or for their mean.
struct FoundOfAssemblies {
  std::string name = {};                              ///< of the assembly; empty of the mean
  std::vector<std::string> names = {};                ///< of all; empty of one
  std::string stiffness_from = {};                    ///< "given", "secant_stiffness", "common"
  std::optional<BandedValue> stiffness_spread = {};   ///< relative
  std::optional<BandedValue> slip_force_spread = {};  ///< relative
  std::optional<BandedValue> shape_spread = {};       ///< 1
  std::optional<double> spread_prior_from = {};       ///< the least spread of the prior
  std::optional<double> spread_prior_to = {};         ///< its usual one
  std::optional<double> effective_draws = {};         ///< independent draws as good as those
  std::optional<BandedValue> stiffness = {};          ///< k of the assembly, N/m
  std::optional<BandedValue> slip_force_scale = {};   ///< of the assembly, over that of the mean
  std::optional<BandedValue> shape = {};              ///< of the assembly, 1
};

/// Results for a joint by the calibration of a structure.
struct FoundByCalibration {
  double levels = 0.0;         ///< of modes, that were given
  BandedValue stiffness = {};  ///< k, N/m
  BandedValue elastic = {};    ///< K_e, N/m
  std::vector<double> variance_reduction =
      {};                              ///< variance reduction at the slip forces of the band, 1
  double reference_exponent = 0.0;     ///< of the prior of the density, 1
  std::vector<double> edges_std = {};  ///< of each edge, N
  double edges_evidence = 0.0;         ///< for the edges, ln of the odds
};

/// The method of IdentifiedJoint::of_assemblies.
inline constexpr std::string_view kAssembliesMethod = "assemblies";
/// The method of IdentifiedJoint::by_calibration.
inline constexpr std::string_view kCalibrationMethod = "calibration";

/// The status of an identification whose file does not tell it.
inline constexpr std::string_view kStatusNotTold = "not given in the file";

/// A joint with the results of its identification. A joint without a method was not identified as
/// far as its file tells, and the report does not say so.
struct IdentifiedJoint {
  Joint joint;                                ///< as identified
  std::string method = {};                    ///< "inversion", "assemblies", "calibration"
  std::string model = {};                     ///< parametric, in place of the density of the method
  std::string status = {};                    ///< "converged"
  bool from_these_levels = false;             ///< identified from the levels of the results
  std::optional<double> covered_from = {};    ///< kA_min, N
  std::optional<double> covered_to = {};      ///< kA_max, N
  std::optional<double> linear_damping = {};  ///< β of D = … + βA², J/m²
  std::vector<std::string> warnings = {};     ///< codes
  std::vector<std::string> warning_texts = {};            ///< one a code, or none
  std::optional<FoundByRecords> by_records = {};          ///< of an identification from records
  std::optional<FoundOfAssemblies> of_assemblies = {};    ///< of several assemblies
  std::optional<FoundByCalibration> by_calibration = {};  ///< of a joint of a structure
  std::vector<DepartureFound> verdicts = {};  ///< of one from levels: what they were tested for
  std::optional<double> scatter = {};         ///< of D of its levels, in the unit that follows
  bool scatter_is_relative = true;            ///< to D; in the standard deviations given otherwise
  std::optional<double> secant_scatter = {};  ///< of k_eq, in the standard deviations given
  std::optional<double> scatter_of_all = {};  ///< of D and k_eq together, in that unit
  std::optional<double> lambda = {};          ///< its smoothing, as its method scales it
  std::string smoothing = {};                 ///< how λ was chosen: "as specified"
  std::optional<double> degrees_of_freedom = {};     ///< of the smoothed fit, 1
  std::optional<double> smoothing_trend = {};        ///< of λ over the slip force
  std::optional<double> inner_not_converged = {};    ///< solutions along the path
  std::optional<SmoothingPath> path = {};            ///< of the values of λ
  std::vector<double> edges = {};                    ///< slip forces at which the density jumps, N
  std::vector<ParameterFound> parameters = {};       ///< of a parametric model
  std::vector<double> covariance = {};               ///< of the parameters, row by row
  std::optional<double> misfit = {};                 ///< of D of a parametric model, rms, relative
  std::optional<StiffnessFound> secant = {};         ///< where k_eq was measured
  std::optional<FrequenciesFound> frequencies = {};  ///< where frequencies were measured
  // The band, where there is one; one length.
  double band_confidence = 0.0;                     ///< 1
  std::optional<double> band_samples = {};          ///< draws that it is of
  std::vector<double> band_slip_force = {};         ///< N
  std::vector<double> band_lower = {};              ///< 1/N
  std::vector<double> band_upper = {};              ///< 1/N
  std::optional<LevelBandsFound> level_bands = {};  ///< of an inversion of levels

  /// The parametric model, or the method; empty where the file tells neither.
  [[nodiscard]] const std::string& found_by() const { return model.empty() ? method : model; }
};

/// The contents of the joint.json of a joint.
[[nodiscard]] JointFile joint_file_of(IdentifiedJoint found, Provenance provenance);

/// What joint_file_of() wrote. A status that is missing is kStatusNotTold, a confidence 0.95.
/// @param file  that was read.
/// @param path  of the file, for messages.
/// @throws InputError  naming the key of which there are fewer or more values than others have, or
///                     whose values contradict others.
[[nodiscard]] IdentifiedJoint identified_joint_of(const JointFile& file, const std::string& path);

}  // namespace microslip
