// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/density_parts.hpp"

/// @file
/// Integrals of one power law φ = R f*^χ on [from, to], all accurate to a few rounding errors of
/// their own value, also just above `from` and for χ near −1, −2 and −3 where the textbook
/// antiderivatives cancel or divide by zero. s is in N and may be infinite unless stated otherwise.

namespace microslip {

/// Φn(s) = ∫ f*ⁿ φ df* over [from, min(to, s)], n = 0, 1, 2.
[[nodiscard]] PartialMoments power_law_moments(const PowerLawPart& part, double s);

/// Φ0(s) alone, at a third of the cost.
[[nodiscard]] double power_law_weight(const PowerLawPart& part, double s);

/// ∫ (s − f*) φ df* over [from, min(to, s)], N; s finite: by how much slip reduces the elastic
/// force.
[[nodiscard]] double power_law_force_deficit(const PowerLawPart& part, double s);

/// Weight and force deficit together.
struct PowerLawSlip {
  double weight;         ///< Φ0(s), 1
  double force_deficit;  ///< N
};
/// Both at the cost of one where from = 0 and s ≤ to.
[[nodiscard]] PowerLawSlip power_law_slip(const PowerLawPart& part, double s);

/// ∫ f*(s − f*) φ df* over [from, min(to, s)], N²; s finite.
[[nodiscard]] double power_law_slip_energy(const PowerLawPart& part, double s);

}  // namespace microslip
