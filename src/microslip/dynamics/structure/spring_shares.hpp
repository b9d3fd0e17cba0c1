// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// By how much springs may exceed what the modes contain of them, relative: ω² of a frequency of
/// four digits is known to a thousandth.
inline constexpr double kSpringTolerance = 1e-3;

/// √k of the springs across the joints that the modes contain, √(N/m).
/// @param joints  StructuralJoint.
template <typename Joints>
Eigen::VectorXd spring_roots(const Joints& joints) {
  Eigen::VectorXd roots(static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index j = 0; j < roots.size(); ++j) {
    roots(j) = std::sqrt(joints[static_cast<std::size_t>(j)].spring_in_modes);
  }
  return roots;
}

/// K^½ C K^½ of those springs, K = diag(k), and the compliance C = Σ ψ_i ψ_iᵀ/ω_i² of the elastic
/// modes across the joints: on the diagonal k of a joint over the largest that the modes can
/// contain. Without the springs the structure is stable where no eigenvalue exceeds 1 and no
/// rigid-body mode moves a joint that has one.
/// @param modes   of the structure with the springs.
/// @param joints  StructuralJoint.
template <typename Joints>
Eigen::MatrixXd spring_shares(std::span<const Mode> modes, const Joints& joints) {
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(joints.size()),
                                                static_cast<Eigen::Index>(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double natural = modes[i].angular_frequency;
    if (!(natural > 0.0)) continue;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      moved(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) =
          std::sqrt(joints[j].spring_in_modes) * joints[j].shape[i] / natural;
    }
  }
  return moved * moved.transpose();
}

}  // namespace microslip
