// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/curve_change.hpp"
#include "microslip/dynamics/further_modes.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "microslip/dynamics/jointed_structure.hpp"

/// @file
/// What a model lacks because its modes end somewhere: an estimate by its last modes. A structure of
/// masses and springs may have all its modes; that the modes do not tell for sure.

namespace microslip {

/// What the modes beyond those of a model add to the static compliance across a joint.
struct MissingCompliance {
  std::string joint;       ///< its name
  double stiffness = 0.0;  ///< k of the joint, N/m
  double in_modes = 0.0;   ///< Σ ψ_i²/ω_i² of the elastic modes, m/N
  double missing = 0.0;    ///< estimated, m/N

  /// k times what is missing: where the modes hold no spring of the joint, the stuck joint moves by
  /// so much too far in the model.
  [[nodiscard]] double over_joint() const { return stiffness * missing; }
};

/// Modes that stand for those beyond the last: the upper half of the n elastic modes once more, all
/// at ω_a (static_mode_frequency()), the shape at each place times what makes its static compliance
/// that of modes which go on as those of the model do. With c_i = φ_i²/ω_i² = C (i − ¼)^−q,
///
///     Σ_{i > n} c_i ≈ C (n + ¼)^{1 − q}/(q − 1),     q ≥ 1.5
///
/// where C is by the sum of c over the upper half and q by that over the same number of modes, or
/// half as many, below them. By a factor of two or so beside the truth for bars and beams; by more
/// where shapes differ much from mode to mode. Bases do not move them.
/// @return none where fewer than two elastic modes lie at different frequencies, and where the
///         structure seems to have all its modes: two or more of its points, as different as
///         masses are, Σ_i φ_i(p) φ_i(q) = 0 to a thousandth for each two.
[[nodiscard]] std::vector<FurtherMode> likely_missing_modes(const JointedStructure& structure);

/// What likely_missing_modes() add across each joint; empty where there are none.
[[nodiscard]] std::vector<MissingCompliance> missing_compliance(const JointedStructure& structure);

/// solve_again() in resonance with likely_missing_modes().
/// @param balance  that the curve is of.
/// @param curve    that was found.
/// @param kept     as in solve_again().
/// @return nothing where there are none, or no joint, or no point of the curve.
[[nodiscard]] std::optional<CurveChange> judge_missing_modes(const HarmonicBalance& balance,
                                                             const ResponseCurve& curve,
                                                             Quantity kept);

/// The change of level or dissipation, 1, above which missing modes are told of.
inline constexpr double kMissingModesAllowed = 0.01;
/// And that of a frequency, 1.
inline constexpr double kMissingModesDetune = 1e-3;

/// The warning `modes_missing` for joints of which k times what is missing is above
/// kMissingModesAllowed; nothing where none is.
/// @param missing  of the joints.
/// @param remedy   the end of the text, what to do about it.
[[nodiscard]] std::optional<Warning> missing_modes_warning(
    const std::vector<MissingCompliance>& missing, const std::string& remedy);

/// The same by what changes in a curve. @param change  by judge_missing_modes(). @param remedy  as
/// above.
[[nodiscard]] std::optional<Warning> changed_curve_warning(const CurveChange& change,
                                                           const std::string& remedy);

}  // namespace microslip
