// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

// g++ 12 says that scoped enumerators hide the dimensions of units.hpp, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// What may be prescribed of a steady vibration. Its frequency and its force amplitude are two
/// numbers: two targets make a vibration, one makes a curve.
enum class Quantity {
  kAngularFrequency,  ///< ω, rad/s; > 0
  kForceAmplitude,    ///< A, N; > 0
  kResponse,          ///< amplitude of the first harmonic at the response point; > 0
  /// Of the displacement there behind the force, rad; in (0, π), modulo π: a point that moves against
  /// the excitation has it too.
  kPhaseLag,
};

/// "angular frequency", "force amplitude", "response", "phase lag".
[[nodiscard]] std::string_view to_string(Quantity quantity);

struct Target {
  Quantity quantity;
  double value;
};

/// The phase lag at resonance, π/2: the force then feeds the damping alone.
inline constexpr Target kPhaseResonance{Quantity::kPhaseLag, 1.57079632679489661923};

enum class ResponseKind {
  kDisplacement,  ///< |w_1|, m
  kVelocity,      ///< ω|w_1|, m/s
  kAcceleration,  ///< ω²|w_1|, m/s²
};

#pragma GCC diagnostic pop

/// Where the response is measured.
struct ResponsePoint {
  std::string point;  ///< of the modal model
  ResponseKind kind = ResponseKind::kDisplacement;
};

}  // namespace microslip
