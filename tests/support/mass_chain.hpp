// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "microslip/structure/structural_matrices.hpp"

namespace microslip::test {

/// Chains of equal masses m between equal springs k, side by side and not joined.
struct MassChains {
  std::size_t masses = 10;  ///< of a chain
  std::size_t chains = 1;
  bool held = true;  ///< at its first end, by a spring; the other is free
  double m = 2.0;    ///< kg
  double k = 5e4;    ///< N/m

  /// Of chain `chain`, its mass `i`, both from 0.
  [[nodiscard]] std::size_t row(std::size_t chain, std::size_t i) const {
    return chain * masses + i;
  }

  /// With rows of nodes 1, 2, … in x.
  [[nodiscard]] StructuralMatrices matrices() const {
    StructuralMatrices all;
    all.stiffness.size = all.mass.size = masses * chains;
    for (std::size_t chain = 0; chain < chains; ++chain) {
      for (std::size_t i = 0; i < masses; ++i) {
        const double springs = (i == 0 ? (held ? 1.0 : 0.0) : 1.0) + (i + 1 < masses ? 1.0 : 0.0);
        add(all.mass, row(chain, i), row(chain, i), m);
        add(all.stiffness, row(chain, i), row(chain, i), springs * k);
        if (i > 0) add(all.stiffness, row(chain, i), row(chain, i - 1), -k);
        all.degrees.push_back({static_cast<std::int64_t>(row(chain, i)) + 1, NodalDirection::kX});
      }
    }
    return all;
  }

  /// ω of mode j from 1 of one chain, in closed form: 2√(k/m) sin((2j − 1)π/(2(2n + 1))) held at
  /// one end, 2√(k/m) sin((j − 1)π/(2n)) free.
  [[nodiscard]] double angular_frequency(std::size_t j) const {
    const auto n = static_cast<double>(masses);
    const auto number = static_cast<double>(j);
    const double angle = held ? (2.0 * number - 1.0) * std::numbers::pi / (2.0 * (2.0 * n + 1.0))
                              : (number - 1.0) * std::numbers::pi / (2.0 * n);
    return 2.0 * std::sqrt(k / m) * std::sin(angle);
  }

  static void add(SymmetricEntries& matrix, std::size_t row, std::size_t column, double value) {
    matrix.row.push_back(static_cast<std::int32_t>(row));
    matrix.column.push_back(static_cast<std::int32_t>(column));
    matrix.value.push_back(value);
  }
};

}  // namespace microslip::test
