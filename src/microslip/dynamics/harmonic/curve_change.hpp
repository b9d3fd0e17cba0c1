// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"

namespace microslip {

/// Which points of a curve are solved again.
enum class PointsAgain : std::uint8_t {
  kTelling,      ///< all telling points
  kInResonance,  ///< those of them that lag by 30° to 150°, where there are any
};

/// Change of a curve under a change of its model, by points of it that were solved again. Changes
/// are relative, 1, the largest of those points.
struct CurveChange {
  std::size_t points = 0;          ///< number of points that were solved again
  std::size_t peaks_left_out = 0;  ///< of the curve, where it has very many
  double dissipation = 0.0;        ///< of a joint, where it dissipates more than 1e-3 of the whole
  std::string joint = {};          ///< with that change of dissipation
  double level = 0.0;              ///< of the response, or, where that is kept, of the force
  double frequency = 0.0;          ///< of the vibration
  double worst_response = 0.0;     ///< where `dissipation` is, in `response_unit`
  double worst_frequency = 0.0;    ///< frequency there, Hz
  std::string_view response_unit = "m";      ///< of the response point
  std::optional<std::string> unsolved = {};  ///< why a point was not solved again; the last such

  /// The largest of the three changes.
  [[nodiscard]] double largest() const;
};

/// Solves telling points of a curve again, from themselves, each once: those with the largest
/// response, the largest motion of each joint, the highest damping, and the largest share of
/// the two highest harmonics in the force of a joint; then its peaks, up to 20 of them by that
/// share. In resonance the constant quantity and the phase lag are kept, elsewhere the constant
/// quantity and the frequency.
/// @param other  with the same joints in number and order, no fewer harmonics.
/// @param curve  the curve.
/// @param kept   the constant quantity of the curve: the force, the response, or, of a backbone,
///               phase resonance.
/// @param points which of them.
[[nodiscard]] CurveChange solve_again(const HarmonicBalance& other, const ResponseCurve& curve,
                                      Quantity kept, PointsAgain points = PointsAgain::kTelling);

}  // namespace microslip
