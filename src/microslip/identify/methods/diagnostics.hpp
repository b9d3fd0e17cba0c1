// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/inversion/bands.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Warnings of the levels alone, before any method:
///   * `few_levels`          fewer than 10 different amplitudes;
///   * `narrow_range`        the highest amplitude is below 1.5 times the lowest;
///   * `amplitudes_merged`   equal amplitudes became one level each;
///   * `repeats_differ`      D of equal amplitudes differs far more than its mean does from a
///                           smooth curve;
///   * `exponent_below_two`  D grows less than A² in the lower half of the range and in all of it;
///   * `std_ignored`         a standard deviation of zero somewhere, so none of that column is
///                           used; or deviations of A without those of D;
///   * `implausible_value`   a displacement or a loss that no structure survives, see
///                           plausibility.hpp.
[[nodiscard]] std::vector<Warning> diagnose(const LevelEvidence& evidence);

/// The same of levels beside other evidence, which neither `few_levels` nor `narrow_range` concern.
[[nodiscard]] std::vector<Warning> diagnose_beside_others(const LevelEvidence& evidence);

/// Which joint the secant stiffnesses are compared with.
enum class SecantOf {
  kInversion,  ///< that of the inversion
  kFinal,      ///< the final one, by diagnose() of StiffnessEvidence: without `secant_inconsistent`
};

/// Warnings of an inversion:
///   * `density_negative`        without the limit φ would be significantly negative
///                               [AR14 Fig. B1];
///   * `data_not_convex`         three neighbouring levels make D concave, beyond their scatter;
///   * `stiffness_inconsistent`  the area would exceed 1: more stiffness slips than k has;
///   * `secant_inconsistent`     measured secant stiffnesses contradict D and k, see
///                               stiffness_evidence.hpp;
///   * `stiffness_unchecked`     less than 1 % of k slips, and no secant stiffness verifies k;
///   * `extrapolation`           much of the area lies below the lowest amplitude;
///   * `damping_suspected`       βA² alone fits D as well, and D grows as A²: it may not be slip
///                               at all;
///   * `damping_ambiguous`       linear damping accounts for most of D at the lowest level;
///   * `scatter_large`           the levels scatter more than a usable measurement, or than stated;
///   * `scatter_small`           they scatter much less than stated;
///   * `inner_not_converged`     solutions that λ, the atom or these warnings depend on did not
///                               converge;
///   * `macroslip_not_reached`   no atom was found.
/// @param result     of invert().
/// @param evidence   that was inverted.
/// @param stiffness  k, N/m.
/// @param options    of the inversion.
/// @param secant     which joint `secant_inconsistent` is of.
/// @throws InputError  where the result is not one of invert() or has another number of levels.
[[nodiscard]] std::vector<Warning> diagnose(const InversionResult& result,
                                            const LevelEvidence& evidence, double stiffness,
                                            const InversionOptions& options,
                                            SecantOf secant = SecantOf::kInversion);

/// Warnings of records and levels together. Of each record that is not of a Masing joint under
/// constant normal load:
///   * `rate_dependent`  the force depends on the velocity;
///   * `asymmetric`      it differs between the two directions;
///   * `dead_zone`       it is missing about zero, or stiffens where a contact closes;
///   * `drifts`          it grows or falls over the record;
///   * `offset_drifts`   its zero drifts;
///   * `displacement_drifts`  the zero of the displacement drifts;
///   * `not_masing`      branches do not follow one curve;
/// and of each table of levels that is of another joint than all other evidence:
///   * `levels_contradict`  D differs, by more than four times the noise and 3 %;
///   * `secant_differs`     k_eq differs, by more than four times the noise and 1 %.
/// @param result    of the records. @param evidence  that was inverted, with its names.
[[nodiscard]] std::vector<Warning> diagnose(const RecordInversionResult& result,
                                            const JointEvidence& evidence);

/// Warning of bands: `bands_not_converged`, where so many draws are correlated that they are worth
/// no more than 3 independent ones in 100.
[[nodiscard]] std::vector<Warning> diagnose(const DensityBands& bands);

}  // namespace microslip
