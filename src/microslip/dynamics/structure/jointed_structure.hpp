// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/joint/joint.hpp"
#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// A joint and its place in a structure of modes q_i. With N = −F(u) the tension in it [AR14 (13)],
///
///     u = Σ_i ψ_i q_i − ½ Σ_ij Γ_ij q_i q_j + cN,     on mode i:  [ψ_i − Σ_r Γ_ir q_r] N
///
/// The terms with Γ are those of a joint that the shortening of a bending beam moves, and that
/// tensions the beam in turn [AR14 (12)]; both come from one potential, so that they lose no
/// energy.
///
/// In addition to F a joint may lose energy with the square of its amplitude, D = … + βA², as
/// identified from levels with a loss other than slip. To harmonic n ≥ 1 of its force that adds
/// i(β/π) u_n: the same loss at every frequency, nβ|u_n|² of that harmonic per period. It is not
/// part of the stiffness.
struct StructuralJoint {
  std::string name;           ///< not empty, no two the same
  Joint joint;                ///< F(u)
  std::vector<double> shape;  ///< ψ_i, relative displacement over q_i, kg^−½; one per mode

  /// Stiffness k_s between its ends that the modes were computed with, N/m; ≥ 0, e.g. k for the
  /// modes of the stuck structure. It is subtracted: k_s ψ_i Σ_r ψ_r q_r is added to the force on
  /// mode i. On a shape r φ_i′(L) this is the torsional spring k_θ = k_s r². Without the springs of
  /// all joints diag(ω_i²) − Σ k_s ψψᵀ must not have a negative eigenvalue, but within 1e-6 of the
  /// largest, or one that springs softer by a thousandth do not have.
  double spring_in_modes = 0.0;

  /// Compliance c in series with the joint, m/N; ≥ 0: L/(EA) for a beam.
  double series_compliance = 0.0;

  /// Γ_ij, 1/(kg m), by rows, symmetric; empty without shortening.
  std::vector<double> shortening = {};

  double linear_damping = 0.0;  ///< β, J/m²: further loss βA² per cycle of amplitude A; ≥ 0, finite

  /// k/(1 + kc), N/m: of the stuck joint with the compliance in series.
  [[nodiscard]] double stuck_stiffness() const;
};

/// A periodic force at a point, f(t) = A Re Σ_n s_n e^{inωt}, or a periodic acceleration of a base.
/// The amplitude A, N or m/s², is common to all excitations of a structure: they are all forces or
/// all accelerations.
struct Excitation {
  std::string point;  ///< of the modal model, or a base of it
  /// s_1, s_2, …, 1: harmonic n is entry n − 1. Those above the harmonics of the balance are an
  /// error.
  std::vector<std::complex<double>> harmonics = {1.0};
};

/// A load that acts for ever, and has acted from before any vibration: dead weight, a preload.
struct StaticLoad {
  std::string place;  ///< a point of the modal model, or a base of it
  double value =
      0.0;  ///< force at a point, N; acceleration of a base, m/s², −g of a weight along it
};

/// The vibrations of the structure with joints that have lost stiffness, static modes included.
struct SoftenedModes {
  std::vector<double> angular_frequency;   ///< rad/s, rising
  std::vector<std::vector<double>> shape;  ///< of each over the modes q_i, of length 1
};

/// A linear structure in modal form, its joints and its excitations:
///
///     q̈_i + damping + ω_i² q_i = Σ_d φ_i(d) f_d(t) + what the joints do (see StructuralJoint)
///
/// with −Γ_i in place of φ_i and the acceleration in place of f where a base is driven (see
/// ModalModel); static loads act in addition.
///
/// Damping of harmonic n of a motion of ω is η_i ω_i nω (viscous) or η_i ω_i² (hysteretic, n ≥ 1).
/// Immutable.
class JointedStructure {
 public:
  /// @param linear       the structure without its joints.
  /// @param joints       may be none: a linear structure.
  /// @param excitations  at least one, and one s_n that is not 0.
  /// @param damping      of all modes.
  /// @param static_loads may be none.
  /// @throws InputError  naming the joint, excitation or load and the rule it breaks.
  JointedStructure(ModalModel linear, std::vector<StructuralJoint> joints,
                   std::vector<Excitation> excitations, DampingLaw damping = DampingLaw::kViscous,
                   std::vector<StaticLoad> static_loads = {});

  /// The structure with other joints. @throws InputError  as the constructor.
  [[nodiscard]] JointedStructure with_joints(std::vector<StructuralJoint> joints) const;

  /// The structure without its joints.
  [[nodiscard]] const ModalModel& linear() const { return linear_; }
  /// The joints, in the order given.
  [[nodiscard]] std::span<const StructuralJoint> joints() const { return joints_; }
  /// The excitations, in the order given.
  [[nodiscard]] std::span<const Excitation> excitations() const { return excitations_; }
  /// The damping of all modes.
  [[nodiscard]] DampingLaw damping() const { return damping_; }
  /// The loads that always act, in the order given.
  [[nodiscard]] std::span<const StaticLoad> static_loads() const { return static_loads_; }

  /// Whether the excitations are accelerations of bases, m/s², and not forces, N.
  [[nodiscard]] bool base_driven() const;
  /// Modal loads by the static loads, p_i = Σ φ_i f − Σ Γ_i a, N kg^−½; one per mode.
  [[nodiscard]] std::vector<double> static_modal_load() const;

  /// Whether some joint has shortening (Γ).
  [[nodiscard]] bool shortens() const;
  /// The largest n with an s_n.
  [[nodiscard]] std::size_t excited_harmonics() const;

  /// Undamped natural frequencies with all joints stuck, rad/s, rising: the resonances at small
  /// amplitude, one per vibration of linear(): static modes have none. Series compliance included,
  /// shortening not.
  [[nodiscard]] std::vector<double> stuck_frequencies() const;

  /// The shape of such a vibration over the modes q_i, of length 1 (mass-normalised).
  /// @param mode  by frequency, from 0. @throws InputError  where there are not so many vibrations.
  [[nodiscard]] std::vector<double> stuck_mode(std::size_t mode) const;

  /// The vibrations with a share of each joint's stiffness k, as at amplitudes at which it slips.
  /// @param shares  of k, 0 to 1; one per joint. @throws InputError  for another number of them.
  [[nodiscard]] SoftenedModes softened_modes(std::span<const double> shares) const;

 private:
  ModalModel linear_;
  std::vector<StructuralJoint> joints_;
  std::vector<Excitation> excitations_;
  DampingLaw damping_;
  std::vector<StaticLoad> static_loads_;
};

}  // namespace microslip
