// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// A natural vibration of a linear structure.
struct Mode {
  double angular_frequency;  ///< ω, rad/s; ≥ 0, and 0 for a rigid body
  double loss_factor = 0.0;  ///< η = 2ζ, 1; ≥ 0, ζ the damping ratio
};

/// A place of the structure and a direction there, by the share of each mode in its displacement.
struct ModalPoint {
  std::string name;           ///< not empty; no two the same in a model
  std::vector<double> shape;  ///< φ_i, mass-normalised, kg^−½; one per mode
};

/// A motion of all supports together, as a shaker table makes it. Modes then describe the motion
/// relative to it: a rigid motion r by 1 of the supports, with the whole structure on them.
struct ModalBase {
  std::string name;                   ///< not empty; no two the same, and not that of a point
  std::vector<double> participation;  ///< Γ_i = φ_iᵀ M r, kg^½; one per mode
  std::vector<double> point_motion;   ///< r at each point, 1; one per point of the model
};

/// Frequency dependence of the damping of a loss factor; at the natural frequency the two are the
/// same.
enum class DampingLaw {
  kViscous,     ///< η_i ω_i q̇_i: i η_i ω_i ω q_i in a harmonic of ω
  kHysteretic,  ///< i η_i ω_i² q_i in each harmonic, whatever its ω
};

/// A linear structure by its modes and their mass-normalised shapes at named points:
///
///     q̈_i + η_i ω_i q̇_i + ω_i² q_i = Σ_p φ_i(p) f_p,   w(p) = Σ_i φ_i(p) q_i
///
/// with f_p the force at p, N, and w(p) its displacement, m. A point may be anything that displaces
/// linearly: a relative displacement across a joint, a rotation times a radius. Where bases b
/// accelerate, −Σ_b Γ_i(b) a_b stands on the right too, w is relative to them, and the absolute
/// displacement is w(p) + Σ_b r_p(b) x_b, ẍ_b = a_b. [Chopra, Dynamics of Structures, 9.4]
/// Immutable.
class ModalModel {
 public:
  /// @param modes   at least one, in any order.
  /// @param points  names not empty and no two the same; may be none.
  /// @param bases   names not empty and no two the same; may be none.
  /// @param static_modes  how many of the modes, the last, are no vibrations: they stand for the
  ///                      static flexibility of those that are left out. Fewer than all.
  /// @throws InputError  naming the mode, the point or the base and the rule it breaks.
  ModalModel(std::vector<Mode> modes, std::vector<ModalPoint> points,
             std::vector<ModalBase> bases = {}, std::size_t static_modes = 0);

  /// A model with the same points and bases and the same number of other modes.
  /// @throws InputError  as the constructor.
  [[nodiscard]] ModalModel with_modes(std::vector<Mode> modes) const;

  /// The number of modes.
  [[nodiscard]] std::size_t size() const { return modes_.size(); }
  /// How many of them are static, the last.
  [[nodiscard]] std::size_t static_modes() const { return static_modes_; }
  /// How many of them are vibrations of the structure, the first.
  [[nodiscard]] std::size_t vibrations() const { return modes_.size() - static_modes_; }
  /// The modes, in the order given.
  [[nodiscard]] std::span<const Mode> modes() const { return modes_; }
  /// The points, in the order given.
  [[nodiscard]] std::span<const ModalPoint> points() const { return points_; }
  /// The bases, in the order given.
  [[nodiscard]] std::span<const ModalBase> bases() const { return bases_; }
  /// Whether a base has this name: its load is an acceleration, m/s², and no force.
  [[nodiscard]] bool is_base(std::string_view place) const;

  /// r of a point: how far it moves with a base that moves by 1; 0 where `place` is no base.
  /// @throws InputError  naming the points there are, where the point is missing.
  [[nodiscard]] double carried(std::string_view point, std::string_view place) const;

  /// φ_i(point), one per mode.
  /// @throws InputError  naming the points there are, where it is missing.
  [[nodiscard]] std::span<const double> shape(std::string_view point) const;

  /// Modal load of 1 N at a point, or of 1 m/s² of a base: φ_i(point), or −Γ_i(base).
  /// @throws InputError  naming the points and bases there are, where it is missing.
  [[nodiscard]] std::span<const double> load(std::string_view place) const;

  /// The displacement at `to` over the force at `from`, both as factors of e^{iωt}, m/N:
  ///
  ///     H(ω) = Σ_i φ_i(to) φ_i(from) / (ω_i² − ω² + i η_i ω_i ω)      (kViscous)
  ///
  /// and ω_i in place of the last ω for kHysteretic. Infinite at the natural frequency of a mode
  /// without damping that both points take part in.
  /// @param to, from           names of points.
  /// @param angular_frequency  ω, rad/s; ≥ 0 and finite.
  /// @param law                of the damping.
  /// @throws InputError  where a point is missing or ω out of its range.
  [[nodiscard]] std::complex<double> receptance(std::string_view to, std::string_view from,
                                                double angular_frequency,
                                                DampingLaw law = DampingLaw::kViscous) const;

 private:
  /// @throws InputError  as shape().
  [[nodiscard]] std::size_t index_of(std::string_view point) const;

  std::vector<Mode> modes_;
  std::vector<ModalPoint> points_;
  std::vector<ModalBase> bases_;
  std::vector<std::vector<double>> base_loads_;  // −Γ_i
  std::size_t static_modes_ = 0;
};

/// ω_i² − ω² + i η_i ω_i ω, or i η_i ω_i² for kHysteretic, rad²/s²: the dynamic stiffness of one
/// mode.
/// @param mode               one of a ModalModel.
/// @param angular_frequency  ω, rad/s; ≥ 0, not checked.
/// @param law                of the damping.
[[nodiscard]] std::complex<double> modal_stiffness(const Mode& mode, double angular_frequency,
                                                   DampingLaw law = DampingLaw::kViscous);

}  // namespace microslip
