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

/// How a density is found from levels.
enum class IdentificationMethod {
  kInversion,    ///< invert() of levels, invert_together() of all else: the one to use
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

/// What identify() does.
struct IdentificationOptions {
  IdentificationMethod method = IdentificationMethod::kInversion;  ///< how the density is found
  InversionOptions inversion = {};          ///< of kInversion, and the linear damping of a fit
  SplineDensityOptions spline = {};         ///< of kSpline
  std::optional<ParametricModel> fit = {};  ///< a parametric model in place of the density
  std::optional<BandOptions> bands = {};    ///< with kInversion and without `fit` only

  /// @throws InputError  where options break their rules, or do not go together.
  void check() const;
};

/// What invert() found, with draws and their band where these were asked for.
struct InvertedDensity {
  InversionResult result;                   ///< of invert()
  std::vector<DensitySample> samples = {};  ///< of its posterior
  std::optional<DensityBands> bands = {};   ///< of these
};

/// A free density, by the method that found it; none where a parametric model was asked for and the
/// levels are too few for more.
using FreeDensity = std::variant<std::monostate, InvertedDensity, SplineDensityResult,
                                 SignedDensity, RecordInversionResult>;

/// A joint from levels or records, and what its user must know of it.
struct Identification {
  /// @param used   the method.
  /// @param found  its joint.
  Identification(IdentificationMethod used, Joint found) : method(used), joint(std::move(found)) {}

  IdentificationMethod method;  ///< that was used
  Joint joint;  ///< the identified density, or the parametric model that was asked for
  /// kA_min, N: below it levels tell two moments of φ only; of records what their noise hides
  double covered_from = 0.0;
  double covered_to = 0.0;  ///< kA_max, N: above it they tell nothing

  /// The density of `joint` at points for plots, with its band where there is one.
  std::vector<double> slip_force;  ///< N
  std::vector<double> density;     ///< 1/N
  std::vector<double> lower;       ///< 1/N; empty without a band
  std::vector<double> upper;       ///< 1/N; as many

  std::optional<double> linear_damping;  ///< β, J/m²

  FreeDensity free = {};  ///< what the method found; beside the parametric model where there is one
  std::optional<ParametricResult> parametric = {};  ///< of the model that was asked for

  [[nodiscard]] const InversionResult* inversion() const;   ///< in `free`; null for another method
  [[nodiscard]] const DensityBands* bands() const;          ///< in `free`; null without
  [[nodiscard]] const SplineDensityResult* spline() const;  ///< in `free`; null likewise
  [[nodiscard]] const SignedDensity* differences() const;   ///< in `free`; null likewise
  [[nodiscard]] const RecordInversionResult* records()
      const;  ///< in `free`; null for one table of levels

  /// Measured k_eq and frequencies held against `joint`.
  StiffnessEvidence stiffness = {};
  /// Whether one table of levels is of a joint of this kind; of records see `records()`.
  std::vector<LevelDepartureVerdict> verdicts = {};

  std::vector<Warning> warnings;  ///< of the levels, the method and the stiffness, see diagnose()
  Summary summary;                ///< of the method
};

/// Levels to joint by the chosen method, judged: see diagnose() in diagnostics.hpp and
/// stiffness_evidence.hpp for the warnings.
/// Methods whose density may be negative give a joint with max(φ, 0), scaled to an area of 1 where
/// it is above; both are said in a warning.
/// @param evidence   the levels with their errors.
/// @param stiffness  k of the stuck joint, N/m; > 0. It scales the slip forces: f* = kA.
/// @param options    the method, and what belongs to it.
/// @throws InputError  where an option or a level breaks a rule.
/// @throws Cancelled   as density_bands().
[[nodiscard]] Identification identify(const LevelEvidence& evidence, double stiffness,
                                      const IdentificationOptions& options = {});

/// Records and tables of levels of one joint together: see invert_together(). Frequencies of the
/// levels are held against the joint as in the other case.
/// @param evidence   of one joint.
/// @param stiffness  k of the stuck joint, N/m, where it is known; needed without records.
/// @param options    how it is solved.
/// @throws InputError  as invert_together(). @throws Cancelled  likewise.
[[nodiscard]] Identification identify(const JointEvidence& evidence,
                                      std::optional<double> stiffness = {},
                                      const RecordInversionOptions& options = {});

/// Force–displacement records to joint: see invert_records(). k is found where it is not given.
/// @param evidence   of one joint.
/// @param stiffness  k of the stuck joint, N/m, where it is known.
/// @param options    how it is solved.
/// @throws InputError  as invert_records(). @throws Cancelled  likewise.
[[nodiscard]] Identification identify(std::span<const RecordEvidence> evidence,
                                      std::optional<double> stiffness = {},
                                      const RecordInversionOptions& options = {});

}  // namespace microslip
