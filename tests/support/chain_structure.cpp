// SPDX-License-Identifier: MIT
#include "support/chain_structure.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"

namespace microslip::testing {

JointedStructure chain_structure(const std::vector<double>& mass, const std::vector<double>& spring,
                                 const std::vector<ChainJoint>& joints, double loss_factor,
                                 const std::vector<double>& stuck) {
  const auto n = static_cast<Eigen::Index>(mass.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  const auto add = [&](Eigen::Index a, Eigen::Index b, double k) {
    if (a >= 0) stiffness(a, a) += k;
    if (b >= 0) stiffness(b, b) += k;
    if (a >= 0 && b >= 0) stiffness(a, b) = stiffness(b, a) = stiffness(a, b) - k;
  };
  for (Eigen::Index i = 0; i <= n; ++i) {
    add(i - 1, i < n ? i : -1, spring[static_cast<std::size_t>(i)]);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) add(joints[j].from, joints[j].to, stuck[j]);
  const Eigen::VectorXd root = Eigen::Map<const Eigen::VectorXd>(mass.data(), n).cwiseSqrt();
  const Eigen::MatrixXd scaled =
      root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const Eigen::MatrixXd shapes = root.cwiseInverse().asDiagonal() * eigen.eigenvectors();

  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < n; ++i) {
    modes.push_back({std::sqrt(eigen.eigenvalues()(i)), loss_factor});
  }
  const auto shape_of = [&](int at) {
    const Eigen::VectorXd row =
        at < 0 ? Eigen::VectorXd::Zero(n) : Eigen::VectorXd(shapes.row(at).transpose());
    return std::vector<double>(row.begin(), row.end());
  };
  std::vector<ModalPoint> points;
  for (int i = 0; i < static_cast<int>(n); ++i) {
    points.push_back({"p" + std::to_string(i + 1), shape_of(i)});
  }
  std::vector<StructuralJoint> placed;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::vector<double> shape = shape_of(joints[j].to);
    const std::vector<double> from = shape_of(joints[j].from);
    for (std::size_t i = 0; i < shape.size(); ++i) shape[i] -= from[i];
    StructuralJoint joint{.name = joints[j].name, .joint = joints[j].joint, .shape = shape};
    joint.spring_in_modes = stuck[j];
    placed.push_back(std::move(joint));
  }
  return {ModalModel(std::move(modes), std::move(points)),
          std::move(placed),
          {Excitation{"p1"}},
          DampingLaw::kHysteretic};
}

}  // namespace microslip::testing
