// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/evidence/joint_evidence.hpp"
#include "microslip/identify/evidence/level_verdicts.hpp"
#include "microslip/identify/evidence/stiffness_evidence.hpp"
#include "microslip/identify/inversion/bands.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/parametric/parametric.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/identify/smoothing/spline_density.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Method of identifying a density from levels.
enum class IdentificationMethod {
  kInversion,    ///< invert() of levels, invert_together() of other evidence: the recommended one
  kSpline,       ///< density_by_spline(), [AR14 Fig. 9]
  kDifferences,  ///< density_by_differences(), a baseline
};

inline constexpr std::array kIdentificationMethods = {IdentificationMethod::kInversion,
                                                      IdentificationMethod::kSpline,
                                                      IdentificationMethod::kDifferences};  ///< all

/// "inversion", "spline", "differences".
[[nodiscard]] std::string_view to_string(IdentificationMethod method);
/// The method of such a name; nothing for another.
[[nodiscard]] std::optional<IdentificationMethod> find_identification_method(std::string_view name);

/// Options of identify().
struct IdentificationOptions {
  IdentificationMethod method = IdentificationMethod::kInversion;  ///< how the density is found
  InversionOptions inversion = {};          ///< of kInversion, and the linear damping of a fit
  SplineDensityOptions spline = {};         ///< of kSpline
  std::optional<ParametricModel> fit = {};  ///< a parametric model instead of the density
  std::optional<BandOptions> bands = {};    ///< with kInversion and without `fit` only

  /// @throws InputError  where options break their rules, or are incompatible.
  void check() const;
};

/// Result of invert(), with draws and their band where requested.
struct InvertedDensity {
  InversionResult result;                   ///< of invert()
  std::vector<DensitySample> samples = {};  ///< of its posterior
  std::optional<DensityBands> bands = {};   ///< of these
};

/// A free density, by the method that found it; none where a parametric model was requested and the
/// levels are too few for a free density.
using FreeDensity = std::variant<std::monostate, InvertedDensity, SplineDensityResult,
                                 SignedDensity, RecordInversionResult>;

/// A joint identified from levels or records, with its evidence and warnings.
struct Identification {
  /// @param used   the method.
  /// @param found  its joint.
  Identification(IdentificationMethod used, Joint found) : method(used), joint(std::move(found)) {}

  IdentificationMethod method;  ///< method used
  Joint joint;                  ///< the identified density, or the requested parametric model
  /// kA_min, N: below it levels determine two moments of φ only; of records the limit set by noise
  double covered_from = 0.0;
  double covered_to = 0.0;  ///< kA_max, N: above it they determine nothing

  /// The density of `joint` at points for plots, with its band where there is one.
  std::vector<double> slip_force;  ///< N
  std::vector<double> density;     ///< 1/N
  std::vector<double> lower;       ///< 1/N; empty without a band
  std::vector<double> upper;       ///< 1/N; as many

  std::optional<double> linear_damping;  ///< β, J/m²

  FreeDensity free = {};  ///< of the method; beside the parametric model where there is one
  std::optional<ParametricResult> parametric = {};  ///< of the requested model

  [[nodiscard]] const InversionResult* inversion() const;   ///< in `free`; null for another method
  [[nodiscard]] const DensityBands* bands() const;          ///< in `free`; null without
  [[nodiscard]] const SplineDensityResult* spline() const;  ///< in `free`; null without
  [[nodiscard]] const SignedDensity* differences() const;   ///< in `free`; null without
  [[nodiscard]] const RecordInversionResult* records()
      const;  ///< in `free`; null for one table of levels

  /// Measured k_eq and frequencies compared with `joint`.
  StiffnessEvidence stiffness = {};
  /// Verdicts on whether one table of levels is of a Masing joint; of records see `records()`.
  std::vector<LevelDepartureVerdict> verdicts = {};

  std::vector<Warning> warnings;  ///< of the levels, the method and the stiffness, see diagnose()
  Summary summary;                ///< of the method
};

/// Levels to joint by the chosen method, judged: see diagnose() in diagnostics.hpp and
/// stiffness_evidence.hpp for the warnings. Methods whose density may be negative give a joint with
/// max(φ, 0), scaled to an area of 1 where it is above; both give a warning.
/// @param evidence   the levels with their errors.
/// @param stiffness  k of the stuck joint, N/m; > 0. It scales the slip forces: f* = kA.
/// @param options    the method, and its options.
/// @throws InputError  where an option or a level breaks a rule.
/// @throws Cancelled   as density_bands().
[[nodiscard]] Identification identify(const LevelEvidence& evidence, double stiffness,
                                      const IdentificationOptions& options = {});

/// Records and tables of levels of one joint together: see invert_together(). Frequencies of the
/// levels are compared with the joint as in the other case.
/// @param evidence   of one joint.
/// @param stiffness  k of the stuck joint, N/m, where it is known; needed without records.
/// @param options    how it is solved.
/// @throws InputError  as invert_together().
/// @throws Cancelled   as invert_together().
[[nodiscard]] Identification identify(const JointEvidence& evidence,
                                      std::optional<double> stiffness = {},
                                      const RecordInversionOptions& options = {});

/// Force–displacement records to joint: see invert_records(). k is found where it is not given.
/// @param evidence   of one joint.
/// @param stiffness  k of the stuck joint, N/m, where it is known.
/// @param options    how it is solved.
/// @throws InputError  as invert_records().
/// @throws Cancelled   as invert_records().
[[nodiscard]] Identification identify(std::span<const RecordEvidence> evidence,
                                      std::optional<double> stiffness = {},
                                      const RecordInversionOptions& options = {});

}  // namespace microslip
