// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic/curve_change.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/structure/further_modes.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

/// @file
/// Estimate of the effect of missing higher modes from the last modes of a model. A structure of
/// masses and springs may have all its modes; the modes alone do not show that with certainty.

namespace microslip {

/// Static compliance across a joint of the modes beyond those of a model.
struct MissingCompliance {
  std::string joint;       ///< its name
  double stiffness = 0.0;  ///< k of the joint, N/m
  double in_modes = 0.0;   ///< Σ ψ_i²/ω_i² of the elastic modes, m/N
  double missing = 0.0;    ///< estimated, m/N

  /// k times the missing compliance: where the modes contain no spring of the joint, the error of
  /// the motion of the stuck joint in the model, relative.
  [[nodiscard]] double over_joint() const { return stiffness * missing; }
};

/// Modes that represent those beyond the last, static_modes() across the joints of a compliance
///
///     (R⁻¹ + B⁻¹)⁻¹,   B = diag(1/k) − C,
///
/// with R = diag(R_j) of the trend of the modes, k of the springs that they contain across joints
/// and C = Σ ψ_i ψ_iᵀ/ω_i². Those springs are no part of what modes leave out: without them the
/// structure keeps a stiffness for anything less than B. What is taken is below both R and B, half
/// of the smaller or more; without springs it is R. R_j, the static compliance of modes that go on
/// as the n elastic ones of the model do, is
///
///     R = E/ω_n² Σ_{i > n} (i′/n′)^{s − 2p} ≈ E n′/ω_n² (1 + 1/(2n′))^{1 + s − 2p}/(2p − s − 1)
///
/// with i′ = i − ¼ and ω_i = ω_n (i′/n′)^p of the frequencies of the upper half, E the largest ψ_i²
/// of all and s ≥ 0 its growth from the lower half to the upper: where shapes have nodes, as in the
/// middle of a bar, single ones are not conclusive. For bars and beams that is between half and
/// some four times the truth, mostly too much inside of them. The coupling of joint and driven
/// point is not included.
/// @return none where fewer than two modes are elastic, and where the structure seems to have all
///         its modes: as many points as modes or more, as different as masses are,
///         Σ_i φ_i(p) φ_i(q) = 0 to a thousandth for each two.
[[nodiscard]] std::vector<FurtherMode> likely_missing_modes(const JointedStructure& structure);

/// The compliance of likely_missing_modes() of each joint; empty where there are none.
[[nodiscard]] std::vector<MissingCompliance> missing_compliance(const JointedStructure& structure);

/// solve_again() in resonance with likely_missing_modes().
/// @param balance  of the curve.
/// @param curve    the curve.
/// @param kept     as in solve_again().
/// @return none without such modes, joints or points of the curve.
[[nodiscard]] std::optional<CurveChange> judge_missing_modes(const HarmonicBalance& balance,
                                                             const ResponseCurve& curve,
                                                             Quantity kept);

/// The change of level or dissipation, 1, above which a warning of missing modes is given.
inline constexpr double kMissingModesAllowed = 0.01;
/// And that of a frequency, 1.
inline constexpr double kMissingModesDetune = 1e-3;
/// Beyond this change of a frequency, 1, an estimate gives no figure.
inline constexpr double kMissingModesFar = 0.1;

/// The warning `modes_missing` for joints for which k times the missing compliance exceeds
/// kMissingModesAllowed; none otherwise.
/// @param missing  of the joints.
/// @param remedy   the end of the text, what to do about it.
[[nodiscard]] std::optional<Warning> missing_modes_warning(
    const std::vector<MissingCompliance>& missing, const std::string& remedy);

/// The warning `residual_large` for joints across which the compliance of the static modes of a
/// structure is a hundred times that of its vibrations, as where a unit was mistaken; none
/// otherwise.
[[nodiscard]] std::optional<Warning> large_residual_warning(const JointedStructure& structure);

/// The warning of missing modes by the change of a curve, or that this could not be estimated:
/// where points were not solved again, or their frequency changed by more than kMissingModesFar, to
/// another resonance.
/// @param change  by judge_missing_modes(). @param remedy  as above.
[[nodiscard]] std::optional<Warning> changed_curve_warning(const CurveChange& change,
                                                           const std::string& remedy);

}  // namespace microslip
