// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

// g++ 12 warns that scoped enumerators hide the dimensions of units.hpp, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Quantities of a steady vibration that may be prescribed. Its frequency and its force amplitude
/// are two numbers: two targets make a vibration, one makes a curve.
enum class Quantity {
  kAngularFrequency,  ///< ω, rad/s; > 0
  kForceAmplitude,    ///< A, N; > 0
  kResponse,          ///< amplitude of the first harmonic at the response point; > 0
  /// Phase lag of the displacement there behind the force, rad; in (0, π), modulo π: a point that
  /// moves against the excitation has it too.
  kPhaseLag,
};

/// "angular frequency", "force amplitude", "response", "phase lag".
[[nodiscard]] std::string_view to_string(Quantity quantity);

/// A quantity with the value that it is to have.
struct Target {
  Quantity quantity;  ///< what is prescribed
  double value;       ///< in the unit of the quantity
};

/// Text for messages: "frequency 55.8 Hz", "force amplitude 0.1 N", "response 2e-05", "phase lag
/// 1.57 rad".
/// @param target   any.
/// @param of_base  whether the excitations are accelerations of bases: "base acceleration 0.1
///     m/s^2".
[[nodiscard]] std::string describe(const Target& target, bool of_base = false);

/// "force 0.1 N", "base acceleration 0.1 m/s^2".
/// @param amplitude  A, N or m/s². @param of_base  as in describe().
[[nodiscard]] std::string drive_text(double amplitude, bool of_base);

/// The phase lag at resonance, π/2: the force then feeds the damping alone.
inline constexpr Target kPhaseResonance{Quantity::kPhaseLag, 1.57079632679489661923};

/// Kinds of forcing of a vibration.
enum class Forcing {
  kExcitation,  ///< the excitations of the structure
  /// A force ξ M q̇ on every mode: it replaces at each place what the motion loses there, as a
  /// shaker at each mass would. What remains is a nonlinear mode, whatever the drive point: the
  /// extended periodic motion q̈ + … − 2ζω q̇ = 0 with ξ = 2ζω. [Krack 2015] The excitations of the
  /// structure are left out. The force amplitude is that of a force at the response point, in phase
  /// with its velocity, that would feed the same energy: A = W_ext/(π|w_1|).
  kModal,
};

/// The response of a point: the amplitude of the first harmonic of its displacement w, or of the
/// derivatives of that.
enum class ResponseKind {
  kDisplacement,  ///< |w_1|, m
  kVelocity,      ///< ω|w_1|, m/s
  kAcceleration,  ///< ω²|w_1|, m/s²
};

#pragma GCC diagnostic pop

/// "m", "m/s", "m/s^2".
[[nodiscard]] std::string_view unit_of(ResponseKind kind);

/// Where the response is measured.
struct ResponsePoint {
  std::string point;                                ///< of the modal model
  ResponseKind kind = ResponseKind::kDisplacement;  ///< of the amplitude
};

}  // namespace microslip
