// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/evidence/joint_evidence.hpp"
#include "microslip/identify/records/stiffness_draw.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"
#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// How invert_records() solves.
struct RecordInversionOptions {
  /// Adds c u̇ with c ≥ 0 to the force: a viscous part beside the friction. It needs a time step.
  bool viscous = false;

  int coefficients = 56;     ///< of the density; ≥ 10. More cost time only.
  std::size_t draws = 1000;  ///< of the posterior; ≥ 100
  double confidence = 0.95;  ///< of the bands, in (0, 1)
  std::uint64_t seed = 1;    ///< of the draws
  Progress progress = {};    ///< of the draws

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

/// A number with its uncertainty.
struct Estimate {
  double value = 0.0;  ///< best estimate, as the result defines it
  double lower = 0.0;  ///< end of the band
  double upper = 0.0;  ///< the other end
};

/// Pointwise band of a density: between its edges lies the requested share of the draws.
struct DensityBand {
  std::vector<double> lower = {};  ///< 1/N
  std::vector<double> upper = {};  ///< 1/N
};

/// Result of one record.
struct RecordFit {
  PathStart start = PathStart::kVirgin;  ///< the state assumed at its first sample
  std::vector<double> offset = {};       ///< F₀ of each group of rows, N
  std::vector<double> residual = {};     ///< measured minus fitted force of each row, N
  double scatter = 0.0;                  ///< of the force of one sample, N
  double correlation = 0.0;              ///< of the residuals of neighbouring rows, 1
  double unexplained = 0.0;              ///< unexplained_share() from an unknown state on, 1
  /// Verdicts on each departure that was tested; the largest first. Where kOther is detected, no
  /// other is: the common joint would deviate from each record.
  std::vector<RecordVerdict> verdicts = {};
};

/// Result of one table of levels.
struct LevelFit {
  LevelScatter scatter = {};        ///< as LevelEvidence has it: σ is by it
  bool scatter_is_relative = true;  ///< that of D, to D; else to the standard deviations given
  LevelRows value = {};             ///< fitted, J and N/m; of LevelEvidence::levels()
  LevelRows deviation = {};         ///< σ that they were weighted by, J and N/m
  std::optional<LevelVerdict> dissipation_verdict = {};  ///< nothing without other evidence
  std::optional<LevelVerdict> secant_verdict = {};       ///< nor where k_eq was not measured
};

/// Result of invert_records(): the likeliest joint, with bands of the draws: of k, K_e and c the
/// shortest that contain the requested share, widened to as many standard deviations about the
/// estimate, those of the coefficients that are not 0.
struct RecordInversionResult {
  std::vector<double> slip_displacement = {};  ///< knots x*, m; from 0 to the largest half range
  std::vector<double> density = {};            ///< ψ, N/m per m
  std::vector<double> lower = {};              ///< of its band
  std::vector<double> upper = {};              ///< of its band
  Estimate stiffness = {};                     ///< k, N/m
  bool stiffness_known = false;                ///< given, not found
  /// K_e, N/m: the part that does not slip within the records.
  Estimate elastic_stiffness = {};
  std::optional<Estimate> viscous = {};   ///< c, N s/m
  double reference_exponent = 0.0;        ///< χ₀ of the prior: ψ ∝ x*^χ₀ costs nothing
  std::vector<RecordFit> records = {};    ///< one per record
  std::vector<LevelFit> levels = {};      ///< one per table of levels
  std::vector<StiffnessDraw> draws = {};  ///< each a feasible joint
  double confidence = 0.0;                ///< of the bands
  /// Smallest slip displacement that the records resolve, m.
  double resolved_from = 0.0;
  Summary summary = {};  ///< residual: of the optimality conditions, relative

  /// The joint of ψ and k, with f* = kx* and φ(f*) = ψ(f*/k)/k².
  [[nodiscard]] Joint joint() const;
  /// The band of φ at the slip forces of joint(), 1/N: draws have stiffnesses of their own.
  [[nodiscard]] DensityBand density_band() const;
};

/// Checks that records are forces of a joint on a path that turns: twice at least, with samples
/// after that, positive work, and with a time step where a viscous part is sought.
/// @param evidence  of one joint.
/// @param options   of the inversion.
/// @throws InputError  naming the value that breaks a rule.
void check_records(std::span<const RecordEvidence> evidence,
                   const RecordInversionOptions& options = {});

/// Identifies the stiffness density ψ(x*) = k²φ(kx*) of a joint from force–displacement records.
/// Sliders of slip displacement x* answer a path by the stop operator S, so that
///
///     F(t) = F₀ + K_e u(t) + c u̇(t) + ∫ S_x*[u](t) ψ dx*,   ψ, K_e, c ≥ 0,
///
/// is linear in all unknowns, and k = K_e + ∫ψ dx* is found with it.
///
/// Likelihood: rows of path_rows(), each with the scatter that the record shows and correlated as
/// neighbouring residuals are. Prior: Gaussian on second differences of ψ/x*^χ₀ over x*^P,
/// within the limits, χ₀ = 0 unless the likelihood strongly favours a power law; draws are of
/// each χ₀ that the data leave possible. Where nothing slips in the upper part of the range the
/// density ends there, and where most of it slips in a narrow range its knots are close there, if
/// the likelihood favours that. The smoothing
/// and the scale of the scatter are drawn with the density (PosteriorChain); given these, a draw is
/// one of the Gaussian without limits, brought within them. The estimate is the minimiser at the
/// likeliest smoothing: the mean of the draws, some of which are far rougher, is further from the
/// truth. Where a departure explains more than 5 % of the force, rows are weighed alike: the joint
/// is then the nearest in force.
///
/// A record does not determine the sliders that slip within its noise: their stiffness is that of a
/// smoothly continued density, and k depends on it.
/// @param evidence   of one joint; each with two reversals at least.
/// @param stiffness  k of the stuck joint, N/m, where it is known.
/// @param options    how it is solved.
/// @throws InputError  naming the value that breaks a rule.
/// @throws Cancelled   when the progress callback returns false.
[[nodiscard]] RecordInversionResult invert_records(std::span<const RecordEvidence> evidence,
                                                   std::optional<double> stiffness = {},
                                                   const RecordInversionOptions& options = {});

/// Identifies the stiffness density from records and levels together, or from several tables of
/// levels. D of a level is linear in ψ, too, whatever k is, and so is k_eq = K_e + ∫ g(x*/A) ψ
/// dx* [level_rows.hpp], which counts in full: with records k is found, else it must be given. Rows
/// of levels have σ of LevelEvidence; their scatter is that of their residuals. Each table is also
/// compared with the joint of the records, or of all other tables where there are no records: see
/// LevelVerdict. Common errors of levels are not drawn.
/// @param evidence   of one joint.
/// @param stiffness  k of the stuck joint, N/m, where it is known; needed without records.
/// @param options    how it is solved.
/// @throws InputError  naming the value that breaks a rule.
/// @throws Cancelled   when the progress callback returns false.
[[nodiscard]] RecordInversionResult invert_together(const JointEvidence& evidence,
                                                    std::optional<double> stiffness = {},
                                                    const RecordInversionOptions& options = {});

}  // namespace microslip
