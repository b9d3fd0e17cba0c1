// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

namespace microslip {

/// LU factors of a square matrix whose unknowns fall into groups that do not know of each other:
/// M_ij = 0 exactly wherever i and j are of different groups. Each group is factored by itself, and
/// only where its right side is not zero. Internal to dynamics.
///
/// So it is with a motion whose second half of the period is the first turned round: even harmonics
/// vanish and stay so, and half of the unknowns cost an eighth.
class DecoupledFactors {
 public:
  /// Takes M, n × n.
  void compute(const Eigen::MatrixXd& matrix);

  /// M⁻¹ right.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right);

  /// The sign of the determinant of the group that the last unknown is in: in a bordered matrix
  /// that of the curve. The other groups' tells where a motion may lose its symmetry, which does
  /// not turn the curve round.
  [[nodiscard]] int last_determinant_sign();

  /// How many groups there are.
  [[nodiscard]] std::size_t groups() const { return groups_.size(); }

 private:
  struct Group {
    std::vector<Eigen::Index> members;
    Eigen::PartialPivLU<Eigen::MatrixXd> factors = {};
    bool factored = false;
  };

  void factor(Group& group) const;

  Eigen::MatrixXd matrix_;
  std::vector<Group> groups_;  // that of the last unknown first
};

}  // namespace microslip
