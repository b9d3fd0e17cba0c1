// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "microslip/dynamics/steady_vibration.hpp"

namespace microslip {

/// What is missing in a curve because its harmonics end at H, by the same vibrations with 2H + 1.
/// Changes are relative, 1, the largest of the points that were looked at; the error itself is a
/// little larger.
struct Truncation {
  std::size_t harmonics = 0;       ///< 2H + 1
  std::size_t points = 0;          ///< that were solved again
  std::size_t peaks_left_out = 0;  ///< of the curve, where it has very many
  double dissipation = 0.0;        ///< of a joint, where it dissipates more than 1e-3 of the whole
  std::string joint;               ///< whose
  double level = 0.0;              ///< of the response, or, where that is kept, of the force
  double frequency = 0.0;          ///< of the vibration
  double worst_response = 0.0;     ///< where `dissipation` is, in `response_unit`
  double worst_frequency = 0.0;    ///< likewise, Hz
  std::string_view response_unit = "m";  ///< of the response point
  std::optional<std::string> unsolved;   ///< why a point was not solved again; the last such

  /// The largest of the three changes.
  [[nodiscard]] double largest() const;
};

/// The error that truncation may make unsaid, 1.
inline constexpr double kTruncationAllowed = 2e-3;

/// Solves telling points of a curve again, from themselves, each once: those with the largest
/// response, the largest motion of each joint, the highest damping, and the largest share of
/// harmonics H − 1 and H in the force of a joint; then its peaks, up to 20 of them by that share.
/// In resonance what was kept and the phase lag are kept, elsewhere what was kept and the
/// frequency. All harmonics up to 2H + 1 cost some 6 evaluations a point of equations twice as many
/// as those of the curve.
/// @param balance  that the curve is of.
/// @param curve    that was found.
/// @param kept     what was kept on the curve: the force, the response, or, of a backbone, phase
///                 resonance.
/// @return nothing where the structure has no joint, or the curve no point.
[[nodiscard]] std::optional<Truncation> judge_truncation(const HarmonicBalance& balance,
                                                         const ResponseCurve& curve, Quantity kept);

/// The warning `truncated`, with figures and remedy, where more than kTruncationAllowed changes or
/// where that could not be seen.
[[nodiscard]] std::optional<Warning> truncation_warning(const Truncation& truncation);

}  // namespace microslip
