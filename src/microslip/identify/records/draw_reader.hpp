// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/records/record_settling.hpp"
#include "microslip/identify/records/stiffness_draw.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// Coefficients of a RecordModel as joints. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// Reads coefficients as joints.
class DrawReader {
 public:
  /// @param model    of the coefficients. @param records  that it is of; must outlive this.
  DrawReader(const RecordModel& model, const ScaledRecords& records);

  /// The joint of coefficients, with ψ at slip_displacements().
  [[nodiscard]] StiffnessDraw read(const Eigen::VectorXd& x) const;

  /// K_e, N/m, of coefficients.
  [[nodiscard]] double elastic(const Eigen::VectorXd& x) const;

  /// The rows that give k, K_e and c from coefficients, but for what is known of them.
  [[nodiscard]] Eigen::VectorXd stiffness_row() const;
  [[nodiscard]] Eigen::VectorXd elastic_row() const;
  [[nodiscard]] const Eigen::VectorXd& viscous_row() const { return viscous_; }

 private:
  const ScaledRecords& records_;
  Eigen::MatrixXd density_;
  Eigen::VectorXd area_;
  Eigen::VectorXd elastic_;
  Eigen::VectorXd viscous_;
};

/// The slip displacements x*, m, at which DrawReader reads ψ: from 0 to the largest half range.
[[nodiscard]] std::vector<double> slip_displacements(const SettledRecords& settled);

/// The joint of a stiffness density: f* = kx* and φ(f*) = ψ(f*/k)/k².
/// @param slip_displacement  x*, m. @param density  ψ there, N/m per m. @param stiffness  k, N/m.
[[nodiscard]] Joint joint_of_stiffness_density(std::span<const double> slip_displacement,
                                               std::span<const double> density, double stiffness);

}  // namespace microslip
