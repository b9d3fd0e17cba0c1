// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// @file
/// The description of a frictional-support test. All values are SI.

namespace microslip {

/// A slender uniform beam of rectangular section, clamped at x = 0 and resting by a rod on the
/// frictional support at x = L. [AR14 (10)]
struct RigBeam {
  double length = 0.0;          ///< L, m; above 0
  double width = 0.0;           ///< b, m; above 0
  double thickness = 0.0;       ///< h, m; above 0
  double youngs_modulus = 0.0;  ///< E, Pa; above 0
  double mass_density = 0.0;    ///< ρ, kg/m³; above 0

  /// bh, m².
  [[nodiscard]] double area() const { return width * thickness; }
  /// EI = E b h³/12, N m².
  [[nodiscard]] double bending_stiffness() const {
    return youngs_modulus * width * thickness * thickness * thickness / 12.0;
  }
};

/// The linear structure with the stuck joint in it, by modes measured or computed elsewhere,
/// mass-normalised: shapes in kg^-1/2.
struct RigModes {
  std::vector<double> frequency;   ///< f_i, Hz; above 0, rising
  std::vector<double> excitation;  ///< φ_i at the exciter
  std::vector<double> joint;       ///< relative displacement across the joint per modal coordinate
};

/// The frictional contact.
struct RigContact {
  double rod_radius = 0.0;  ///< r, m; above 0 for a beam, without meaning for modes
  /// k, N/m; above 0. For a beam either this or the stick frequency is given.
  std::optional<double> stiffness = {};
  /// First natural frequency of the beam with the stuck joint, Hz; above 0.
  std::optional<double> stick_frequency = {};
  std::string joint = {};  ///< file of the true joint; only the virtual test has one
};

/// The mass of a sensor on the beam.
struct RigMass {
  double position = 0.0;  ///< x, m; 0 to L
  double mass = 0.0;      ///< kg; 0 or more
};

/// Where a force acts or an acceleration is measured, and the channel that records it.
struct RigSensor {
  double position = 0.0;      ///< x, m; above 0 and below L. For a beam
  std::vector<double> shape;  ///< φ_i there, kg^-1/2. For an accelerometer where modes are given
  std::string channel;        ///< its name in the recordings
};

/// A displacement sensor at the joint.
struct RigVibrometer {
  /// Quantity that a vibrometer measures.
  enum class Measures {
    kJoint,  ///< the joint displacement u itself
    kAxial,  ///< the axial motion of the beam's centre line, to which r w′(L) is added [AR14 (13)]
  };
  std::string channel;                   ///< its name in the recordings
  Measures measures = Measures::kJoint;  ///< what it shows
};

/// The virtual test.
struct RigTest {
  double response_from = 0.0;         ///< acceleration amplitude at the exciter, m/s²; above 0
  double response_to = 0.0;           ///< at or above response_from
  std::size_t count = 1;              ///< levels
  bool logarithmic = false;           ///< in equal ratios; equally spaced otherwise
  double sampling_rate = 0.0;         ///< Hz; above 0
  double duration = 0.0;              ///< of a record, s; above 0
  double frequency_resolution = 0.0;  ///< of the drive, Hz; 0 or more
  std::size_t modes = 7;              ///< of a beam; 1 to 100
  std::size_t harmonics = 9;          ///< of the balance; 1 to 100
};

/// Standard deviation of the noise of a sample.
struct RigNoise {
  double force = 0.0;         ///< N; 0 or more
  double acceleration = 0.0;  ///< m/s²; 0 or more
  double vibrometer = 0.0;    ///< m; 0 or more
};

/// The electrodynamic shaker of the virtual test, see shaker.hpp. The defaults are a modal shaker
/// of some 50 N: a coil of 2 Ω, 80 g that move, its free resonance at 48 Hz, and a steel wire 100
/// mm long and 1.5 mm thick as stinger.
struct RigShaker {
  double resistance = 2.0;              ///< R of the coil, Ω; above 0
  double inductance = 2e-4;             ///< L of the coil, H; 0 or more
  double force_factor = 8.0;            ///< Bl, N/A; above 0
  double moving_mass = 0.08;            ///< m, kg; above 0
  double suspension_stiffness = 7.2e3;  ///< k, N/m; 0 or more
  double suspension_damping = 5.0;      ///< c, N s/m; 0 or more
  double stinger_stiffness = 3.6e6;     ///< k_s, N/m; above 0
};

/// A frictional-support test.
struct Rig {
  std::variant<RigBeam, RigModes> structure;  ///< a beam, or modes of another structure
  RigContact contact;                         ///< between structure and support
  std::vector<double> loss_factor;            ///< η_i, 0 or more; later modes take the last value
  std::vector<RigMass> masses;                ///< for a beam
  RigSensor excitation;                       ///< where the force acts
  std::vector<RigSensor> accelerometers;      ///< one at least
  std::optional<RigVibrometer> vibrometer = {};  ///< where there is one
  std::optional<RigTest> test = {};              ///< of a virtual test alone
  std::optional<RigNoise> noise = {};            ///< of a virtual test; without it none
  std::optional<RigShaker> shaker = {};  ///< of the virtual test; without it the default one

  /// The beam; null where the structure is given by modes.
  [[nodiscard]] const RigBeam* beam() const { return std::get_if<RigBeam>(&structure); }
  /// The modes; null where the structure is a beam.
  [[nodiscard]] const RigModes* modes() const { return std::get_if<RigModes>(&structure); }

  /// η of mode i, counted from 0.
  [[nodiscard]] double loss_factor_of(std::size_t mode) const {
    return loss_factor[mode < loss_factor.size() ? mode : loss_factor.size() - 1];
  }
};

/// Checks the ranges above, and what must go together.
/// @throws InputError  naming the field, `accelerometers[1].position`, its value and the rule that
///                     it breaks.
void check_rig(const Rig& rig);

}  // namespace microslip
