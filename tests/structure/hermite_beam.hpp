// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/structure/beam.hpp"

namespace microslip::testing {

/// Natural frequencies, rad/s, by cubic Hermite elements with their consistent masses: from above,
/// and with an error of the order h⁴. Masses must lie on nodes, k·L/elements.
inline std::vector<double> hermite_frequencies(const Beam& beam, int elements) {
  const Eigen::Index size = 2 * (elements + 1);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size);
  const double h = beam.length / elements;
  Eigen::Matrix4d k;
  k << 12, 6 * h, -12, 6 * h,               //
      6 * h, 4 * h * h, -6 * h, 2 * h * h,  //
      -12, -6 * h, 12, -6 * h,              //
      6 * h, 2 * h * h, -6 * h, 4 * h * h;
  Eigen::Matrix4d m;
  m << 156, 22 * h, 54, -13 * h,              //
      22 * h, 4 * h * h, 13 * h, -3 * h * h,  //
      54, 13 * h, 156, -22 * h,               //
      -13 * h, -3 * h * h, -22 * h, 4 * h * h;
  for (Eigen::Index e = 0; e < elements; ++e) {
    stiffness.block<4, 4>(2 * e, 2 * e) += beam.bending_stiffness / (h * h * h) * k;
    mass.block<4, 4>(2 * e, 2 * e) += beam.mass_per_length * h / 420.0 * m;
  }
  for (const auto& [position, point_mass] : beam.masses) {
    const auto node = static_cast<Eigen::Index>(std::lround(position / h));
    mass(2 * node, 2 * node) += point_mass;
  }
  // Without w and w′ at the clamp and w at L; w′(L) takes the place of w(L).
  const Eigen::Index free = std::isinf(beam.tip_stiffness) ? size - 4 : size - 3;
  if (free == size - 3) {
    for (auto* matrix : {&stiffness, &mass}) {
      matrix->row(size - 2).swap(matrix->row(size - 1));
      matrix->col(size - 2).swap(matrix->col(size - 1));
    }
    stiffness(size - 2, size - 2) += beam.tip_stiffness;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness.block(2, 2, free, free), mass.block(2, 2, free, free), Eigen::EigenvaluesOnly);
  const Eigen::VectorXd frequencies = solver.eigenvalues().cwiseSqrt();
  return {frequencies.begin(), frequencies.end()};
}

}  // namespace microslip::testing
