// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/joint/density_parts.hpp"

namespace microslip {

/// The Iwan distribution density φ(f*) of a frictional contact: the sliders with a critical slip
/// force between f* and f* + df* carry the fraction φ df* of the joint's stiffness. A sum of
/// parts; immutable. With Φn the partial moments, 1 − Φ0(∞) is the elastic remainder:
/// stiffness that has not slipped.
///
/// All parts but the power laws are merged once into segments on which φ is linear, so that every
/// closed form costs one search and a polynomial, whatever the number of parts.
class SlipDensity {
 public:
  /// φ = p + q·t, t = s − start, from `start` to the start of the next segment; the moments are
  /// those at `start`, the atoms there included.
  struct LinearSegment {
    double start;            ///< N
    double p;                ///< 1/N
    double q;                ///< 1/N²
    PartialMoments moments;  ///< Φ0, Φ1 and Φ2 at `start`
    double force_deficit;    ///< ∫₀ˢ (s − f*) φ df* at `start`, N
    double slip_energy;      ///< ∫₀ˢ f*(s − f*) φ df* at `start`, N²
  };

  /// No slip at all: the elastic remainder is 1.
  SlipDensity() : SlipDensity(std::vector<DensityPart>{}) {}

  /// @param parts  add up; total weight ≤ 1 (beyond 1e−9 of rounding), each as its comment demands.
  /// @throws InputError  naming the part and the value that breaks a rule.
  explicit SlipDensity(std::vector<DensityPart> parts);

  /// The parts, as given.
  [[nodiscard]] std::span<const DensityPart> parts() const { return parts_; }

  /// φ(f*) without the atoms, 1/N; f* in N. At a step of φ the value above it. Infinite at f* = 0
  /// where a power law with a negative exponent starts there; NaN where f* is.
  [[nodiscard]] double density(double slip_force) const;

  /// Φ0, Φ1, Φ2 at s, in closed form. @param s  N; s = ∞ gives the totals; s ≤ 0 gives zeros,
  /// NaN gives NaN.
  [[nodiscard]] PartialMoments moments(double s) const;

  /// E(s) = ∫₀ˢ f*(s − f*) φ df* = sΦ1(s) − Φ2(s), N², without the cancellation of that difference:
  /// the dissipation (7) is 4E(kA)/k. 0 for s ≤ 0, infinite for s = ∞ unless nothing slips, NaN for
  /// NaN.
  [[nodiscard]] double slip_energy(double s) const;

  /// Φn(∞).
  [[nodiscard]] const PartialMoments& total() const { return total_; }

  /// 1 − Φ0(∞), clipped to 0 where it is rounding.
  [[nodiscard]] double elastic_remainder() const { return elastic_remainder_; }

  /// The largest slip force with density, N; 0 when there is none.
  [[nodiscard]] double largest_slip_force() const { return largest_slip_force_; }

  /// All but the power laws. The last segment has p = q = 0 and extends to infinity.
  [[nodiscard]] std::span<const LinearSegment> segments() const { return segments_; }

  /// The power laws, that of a four-parameter part included.
  [[nodiscard]] std::span<const PowerLawPart> power_laws() const { return power_laws_; }

  /// All atoms with a weight, that of a four-parameter part included, by rising slip force; equal
  /// ones are merged.
  [[nodiscard]] const AtomsPart& atoms() const { return atoms_; }

 private:
  [[nodiscard]] const LinearSegment& segment_at(double s) const;

  std::vector<DensityPart> parts_;
  std::vector<LinearSegment> segments_;
  std::vector<PowerLawPart> power_laws_;
  AtomsPart atoms_;
  PartialMoments total_;
  double elastic_remainder_ = 1.0;
  double largest_slip_force_ = 0.0;
};

/// ψ_max = F_S(1+β)/(K_T(β + (χ+1)/(χ+2))), m: the displacement at which all has slipped.
[[nodiscard]] double macroslip_displacement(const FourParameterPart& part);

}  // namespace microslip
