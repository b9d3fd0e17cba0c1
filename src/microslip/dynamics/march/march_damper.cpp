// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_damper.hpp"

#include <cmath>
#include <numbers>

#include "microslip/algebra/eigenvalues.hpp"

namespace microslip {

double frequency_of_joint(const JointedStructure& structure, std::size_t joint) {
  constexpr double kRigid = 1e-9;  // of the largest ω²
  constexpr double kStill = 1e-6;  // of the joint's shape
  const auto modes = static_cast<Eigen::Index>(structure.linear().size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(modes, modes);
  for (Eigen::Index i = 0; i < modes; ++i) {
    stiffness(i, i) =
        std::pow(structure.linear().modes()[static_cast<std::size_t>(i)].angular_frequency, 2);
  }
  for (const StructuralJoint& each : structure.joints()) {
    const double k = each.joint.stiffness();
    const Eigen::Map<const Eigen::VectorXd> shape(each.shape.data(), modes);
    stiffness +=
        (k / (1.0 + k * each.series_compliance) - each.spring_in_modes) * shape * shape.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> stuck(stiffness);
  const Eigen::Map<const Eigen::VectorXd> shape(structure.joints()[joint].shape.data(), modes);
  const double largest = stuck.eigenvalues()(modes - 1);
  for (Eigen::Index i = 0; i < modes; ++i) {
    const double square = stuck.eigenvalues()(i);
    const bool moves = std::abs(stuck.eigenvectors().col(i).dot(shape)) > kStill * shape.norm();
    if (square > kRigid * largest && moves) return std::sqrt(square);
  }
  return 0.0;
}

double damper_of_joint(const JointedStructure& structure, std::size_t joint) {
  const double beta = structure.joints()[joint].linear_damping;
  if (beta == 0.0) return 0.0;
  const double omega = frequency_of_joint(structure, joint);
  return omega > 0.0 ? beta / (std::numbers::pi * omega) : 0.0;
}

}  // namespace microslip
