// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// @file
/// Units at the borders of the program: a value that a file gives in mm, lbf or g becomes SI when
/// it is read.

namespace microslip {

/// The exponents of metre, kilogram, second and radian. The radian counts, so that a frequency in
/// Hz and an angular frequency in rad/s are two things and no factor 2π is lost between them.
struct Dimension {
  int length = 0;  ///< of the metre
  int mass = 0;    ///< of the kilogram
  int time = 0;    ///< of the second
  int angle = 0;   ///< of the radian

  /// Whether all exponents are the same.
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;

  /// The dimension of a product.
  friend constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
  }

  /// The dimension of a quantity to the power n.
  [[nodiscard]] constexpr Dimension power(int n) const {
    return {n * length, n * mass, n * time, n * angle};
  }

  /// The dimension of a quotient.
  friend constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
    return a * b.power(-1);
  }
};

inline constexpr Dimension kDimensionless{};                         ///< 1
inline constexpr Dimension kLength{.length = 1};                     ///< m
inline constexpr Dimension kMass{.mass = 1};                         ///< kg
inline constexpr Dimension kTime{.time = 1};                         ///< s
inline constexpr Dimension kAngle{.angle = 1};                       ///< rad
inline constexpr Dimension kFrequency = kTime.power(-1);             ///< Hz, which is 1/s
inline constexpr Dimension kAngularFrequency = kAngle / kTime;       ///< rad/s
inline constexpr Dimension kVelocity = kLength / kTime;              ///< m/s
inline constexpr Dimension kAcceleration = kVelocity / kTime;        ///< m/s²
inline constexpr Dimension kForce = kMass * kAcceleration;           ///< N
inline constexpr Dimension kEnergy = kForce * kLength;               ///< J
inline constexpr Dimension kStiffness = kForce / kLength;            ///< N/m
inline constexpr Dimension kPerForce = kForce.power(-1);             ///< 1/N
inline constexpr Dimension kPressure = kForce / kLength.power(2);    ///< Pa
inline constexpr Dimension kMassDensity = kMass / kLength.power(3);  ///< kg/m³

inline constexpr double kStandardGravity = 9.80665;  ///< m/s², exact by definition

/// A unit: value in SI = value·numerator/denominator. Two factors, so that powers of ten stay
/// exact: 3 um is the double nearest to 3e-6.
struct Unit {
  double numerator = 1.0;    ///< of the factor to SI
  double denominator = 1.0;  ///< of the factor to SI
  Dimension dimension;       ///< what the unit measures

  /// A value in this unit in SI.
  [[nodiscard]] double to_si(double value) const { return value * numerator / denominator; }
  /// One of this unit in SI.
  [[nodiscard]] double factor() const { return numerator / denominator; }
};

/// The unit that a text names: products, quotients and powers of m, in, ft, mil, N, lbf, J, kg, s,
/// Hz, Pa, psi, rad, deg, g, with the usual prefixes n, u (µ), m, c, k, M, G where they are in
/// use, and `1`, `-` or `%` for a number. `g` is standard gravity, 9.80665 m/s^2; masses are in kg.
/// Powers read m/s^2, m/s2 or m/s²; products N m, N*m or N·m; a quotient is read from the left;
/// an expression in brackets, (m/s^2)^2/Hz, is one unit. Other spellings of laboratories count too:
/// sec, msec, min, inches, in., mils, microns, lbs (a force), kips, kgf, daN, g's, G, rpm, µε, bar,
/// ksi; Nm is N m, and ms-2 is m s^-2.
/// @return  nothing where the text is no such unit.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view text);

/// Whether a text names a unit of a quantity that is not mechanical, such as °C, V, A or mV/g.
/// Values in it have no dimension here.
[[nodiscard]] bool is_other_unit(std::string_view text);

/// find_unit() for a unit that must be of the given dimension.
/// @throws InputError  naming the unit, its dimension, and units that would fit.
[[nodiscard]] Unit parse_unit(std::string_view text, const Dimension& expected);

/// In words: "length", or the unit where it has no name, such as "kg^2 s^-1".
[[nodiscard]] std::string dimension_name(const Dimension& dimension);

/// The SI unit as columns are labelled: "m", "N/m", "1/N", or in base units where it has none.
[[nodiscard]] std::string si_unit(const Dimension& dimension);

/// A length in a sentence, of four digits: "12.5 µm", "3 mm", "1.2 m".
/// @param metres  ≥ 0, m.
[[nodiscard]] std::string length_text(double metres);

/// Units in use for a dimension, SI first: "m, mm, um (µm), nm, cm, in, ft, mil".
[[nodiscard]] std::string usual_units(const Dimension& dimension);

}  // namespace microslip
