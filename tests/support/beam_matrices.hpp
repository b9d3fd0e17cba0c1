// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/structure/structural_matrices.hpp"
#include "support/mass_chain.hpp"

namespace microslip::test {

/// A uniform beam of cubic elements, free at both ends: rows 2i and 2i + 1 are the deflection and
/// the slope of node i.
struct BeamMatrices {
  std::size_t elements = 20;
  double length = 0.4;             ///< m
  double bending = 11.2;           ///< EI, N m²
  double mass_per_length = 0.314;  ///< kg/m

  [[nodiscard]] std::size_t rows() const { return 2 * (elements + 1); }
  [[nodiscard]] double mass() const { return mass_per_length * length; }

  [[nodiscard]] StructuralMatrices matrices() const {
    const std::array<std::array<double, 4>, 4> k = {
        {{12, 6, -12, 6}, {6, 4, -6, 2}, {-12, -6, 12, -6}, {6, 2, -6, 4}}};
    const std::array<std::array<double, 4>, 4> m = {
        {{156, 22, 54, -13}, {22, 4, 13, -3}, {54, 13, 156, -22}, {-13, -3, -22, 4}}};
    const double l = length / static_cast<double>(elements);
    StructuralMatrices all;
    all.stiffness.size = all.mass.size = rows();
    for (std::size_t e = 0; e < elements; ++e) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          const double arms = std::pow(l, static_cast<double>(i % 2 + j % 2));
          MassChains::add(all.stiffness, 2 * e + i, 2 * e + j,
                          k[i][j] * arms * bending / (l * l * l));
          MassChains::add(all.mass, 2 * e + i, 2 * e + j,
                          m[i][j] * arms * mass_per_length * l / 420.0);
        }
      }
    }
    return all;
  }

  /// Adds a spring to the ground at a row.
  static void hold(StructuralMatrices& matrices, std::size_t row, double stiffness) {
    MassChains::add(matrices.stiffness, row, row, stiffness);
  }

  /// Of mode i from 1 of the beam clamped at one end, in closed form, Hz: λ²√(EI/(ρA))/(2πL²), the
  /// roots λ of cos λ cosh λ = −1.
  [[nodiscard]] double cantilever_hertz(std::size_t i) const {
    const double wave = root(i) / length;
    return wave * wave * std::sqrt(bending / mass_per_length) / (2.0 * std::numbers::pi);
  }
  static double root(std::size_t i) {
    double lambda = (static_cast<double>(i) - 0.5) * std::numbers::pi;
    for (int step = 0; step < 50; ++step) {  // Newton's method for cos λ + 1/cosh λ
      const double value = std::cos(lambda) + 1.0 / std::cosh(lambda);
      lambda -= value / (-std::sin(lambda) - std::tanh(lambda) / std::cosh(lambda));
    }
    return lambda;
  }
};

}  // namespace microslip::test
