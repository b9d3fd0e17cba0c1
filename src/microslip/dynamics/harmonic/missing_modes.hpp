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
/// What a model lacks because its modes end somewhere: an estimate by its last modes. A structure
/// of masses and springs may have all its modes; that the modes do not tell for sure.

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

/// Modes that stand for those beyond the last, one a joint and moving it alone, all at ω_a
/// (static_mode_frequency()): their shape there is ω_a √R. R, the static compliance of modes that
/// go on as the n elastic ones of the model do, is
///
///     R = E/ω_n² Σ_{i > n} (i′/n′)^{s − 2p} ≈ E n′/ω_n² (1 + 1/(2n′))^{1 + s − 2p}/(2p − s − 1)
///
/// with i′ = i − ¼ and ω_i = ω_n (i′/n′)^p of the frequencies of the upper half, E the largest ψ_i²
/// of all and s ≥ 0 its growth from the lower half to the upper: where shapes have nodes, as in the
/// middle of a bar, single ones tell nothing. For bars and beams that is between half and some four
/// times the truth, mostly too much inside of them. What joint and driven point share is not in it.
/// @return none where fewer than two modes are elastic, and where the structure seems to have all
///         its modes: as many points as modes or more, as different as masses are,
///         Σ_i φ_i(p) φ_i(q) = 0 to a thousandth for each two.
[[nodiscard]] std::vector<FurtherMode> likely_missing_modes(const JointedStructure& structure);

/// R of each joint; empty where there are no likely_missing_modes().
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
/// Beyond this change of a frequency, 1, an estimate tells no figure.
inline constexpr double kMissingModesFar = 0.1;

/// The warning `modes_missing` for joints of which k times what is missing is above
/// kMissingModesAllowed; nothing where none is.
/// @param missing  of the joints.
/// @param remedy   the end of the text, what to do about it.
[[nodiscard]] std::optional<Warning> missing_modes_warning(
    const std::vector<MissingCompliance>& missing, const std::string& remedy);

/// The warning `residual_large` for joints across which the static modes of a structure give way
/// a hundred times as far as its vibrations do, as where a unit was mistaken; nothing where none
/// does.
[[nodiscard]] std::optional<Warning> large_residual_warning(const JointedStructure& structure);

/// The same by what changes in a curve, or that this could not be estimated: where points were not
/// solved again, or their frequency changed by more than kMissingModesFar, to another resonance.
/// @param change  by judge_missing_modes(). @param remedy  as above.
[[nodiscard]] std::optional<Warning> changed_curve_warning(const CurveChange& change,
                                                           const std::string& remedy);

}  // namespace microslip
